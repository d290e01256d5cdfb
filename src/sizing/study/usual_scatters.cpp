#include "coilwright/sizing/study/usual_scatters.hpp"

#include <string>
#include <vector>

#include "coilwright/actuator/number_widths.hpp"

namespace coilwright::sizing {
namespace {

UsualScatter normal(std::string_view name, double deviation, bool is_share, std::string_view source) {
  return {.scatter = {.name = std::string(name), .about = NormalDeviation{deviation}, .relative = is_share},
          .source = source};
}

std::vector<UsualScatter> scatters_of(Making making) {
  std::vector<UsualScatter> out;
  for (const actuator::NumberWidth& width : actuator::number_widths()) {
    // Makers and standards give bounds: two standard deviations of these.
    const double bound = making == Making::printed ? width.printed : width.by_hand;
    if (bound > 0.0)
      out.push_back(normal(width.name, 0.5 * bound, width.in == actuator::NumberWidth::In::shares, width.source));
  }
  if (making == Making::printed)
    out.push_back(normal(
        "each_joint_stiffness_factor", 0.035, true,
        "two hinges of a cast apart by 5 %, as a diagnosis takes them: each 2 % in height, cut by hand, assumed"));
  else
    out.push_back(normal("each_joint_stiffness_factor", 0.12, true,
                         "what each cut by hand leaves of 2.5 mm: 6 % in height, twice that by the slit's square"));
  out.push_back(normal("each_remanence_factor", 0.0075, true, "magnets of one lot: half of what a grade has, assumed"));
  return out;
}

}  // namespace

std::span<const UsualScatter> usual_scatters(Making making) {
  static const std::vector<UsualScatter> printed = scatters_of(Making::printed);
  static const std::vector<UsualScatter> by_hand = scatters_of(Making::by_hand);
  return making == Making::printed ? printed : by_hand;
}

}  // namespace coilwright::sizing
