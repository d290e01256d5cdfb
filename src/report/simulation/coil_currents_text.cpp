#include "coilwright/report/simulation/coil_currents_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

#include "coilwright/actuator/design/current_shares.hpp"
#include "coilwright/report/simulation/text_table.hpp"

namespace coilwright::report {

std::string coil_currents_text(const actuator::Design& design, double current) {
  if (has_one_current(design)) return fmt::format("{} A in every coil", short_number(current));
  std::vector<std::string> currents;
  for (const double share : actuator::current_shares(design)) currents.push_back(short_number(share * current));
  return fmt::format("{} A in the coils from base to tip", fmt::join(currents, " and "));
}

}  // namespace coilwright::report
