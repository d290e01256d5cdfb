#include "report/broken_part_limits_text.hpp"

#include <fmt/format.h>

namespace coilwright::report {

namespace {

std::string lines_of(std::span<const sizing::BrokenPartLimit> broken, bool conditional, std::size_t designs) {
  std::string text;
  for (const sizing::BrokenPartLimit& each : broken)
    if (each.conditional == conditional)
      text += fmt::format("  {}: {} of {} designs: {}\n", each.quantity, each.designs, designs, each.consequence);
  return text;
}

}  // namespace

std::string warning_of_parts(std::span<const sizing::BrokenPartLimit> broken, std::string_view which,
                             std::size_t designs) {
  std::string text;
  if (const std::string lines = lines_of(broken, false, designs); !lines.empty())
    text += fmt::format(
        "\nBEWARE: {} break limits of their parts that the study does not set\n{}Limit these quantities in the study's "
        "\"constraints\" and run it anew; evaluate says what the limits are.\n",
        which, lines);
  if (const std::string lines = lines_of(broken, true, designs); !lines.empty())
    text += fmt::format(
        "\nMIND what {} need, or give up\n{}Where that will not do, limit these quantities in the study's "
        "\"constraints\"; evaluate says what the limits are.\n",
        which, lines);
  return text;
}

}  // namespace coilwright::report
