#include "report/broken_part_limits_text.hpp"

#include <fmt/format.h>

namespace coilwright::report {

std::string warning_of_parts(std::span<const sizing::BrokenPartLimit> broken, std::string_view which,
                             std::size_t designs) {
  if (broken.empty()) return {};
  std::string text = fmt::format("\nBEWARE: {} break limits of their parts that the study does not set\n", which);
  for (const sizing::BrokenPartLimit& each : broken)
    text += fmt::format("  {}: {} of {} designs: {}\n", each.quantity, each.designs, designs, each.consequence);
  return text +
         "Limit these quantities in the study's \"constraints\" and run it anew; evaluate says what the limits are.\n";
}

}  // namespace coilwright::report
