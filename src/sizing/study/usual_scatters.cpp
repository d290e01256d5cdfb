#include "coilwright/sizing/study/usual_scatters.hpp"

#include <vector>

namespace coilwright::sizing {
namespace {

UsualScatter absolute(const char* name, double deviation, std::string_view source) {
  return {.scatter = {.name = name, .about = NormalDeviation{deviation}, .relative = false}, .source = source};
}
UsualScatter relative(const char* name, double deviation, std::string_view source) {
  return {.scatter = {.name = name, .about = NormalDeviation{deviation}, .relative = true}, .source = source};
}

}  // namespace

// Makers and standards give bounds: two standard deviations of these.
std::span<const UsualScatter> usual_scatters() {
  static const std::vector<UsualScatter> rows{
      relative("remanence_T", 0.015, "makers' ranges of one grade of NdFeB, typical +-3 %"),
      absolute("magnet_radius_mm", 0.05, "makers of discs: +-0.1 mm"),
      absolute("magnet_length_mm", 0.05, "makers of discs: +-0.1 mm"),
      absolute("gap_mm", 0.05, "walls cast in printed moulds: +-0.1 mm, assumed"),
      absolute("bottom_layer_mm", 0.05, "cast in printed moulds: +-0.1 mm, assumed"),
      relative("joint_stiffness_factor", 0.08, "2 points of Shore A between batches: 8 % of the modulus by Gent"),
      relative("joint_damping_factor", 0.15, "assumed"),
      relative("constant_damping_factor", 0.3, "assumed: measured on one finger alone"),
      relative("coil_resistance_factor", 0.015,
               "IEC 60317-0-1: resistance of wires of 0.2 to 0.5 mm within +-3 to 5 %"),
      relative("radial_pitch_factor", 0.02, "winding by hand, assumed"),
      relative("heat_transfer_factor", 0.15, "calibrated on one remark; changes by 25 % with the rise"),
      relative(
          "each_joint_stiffness_factor", 0.035,
          "two hinges of a cast apart by 5 %, as a diagnosis takes them: each 2 % in height, cut by hand, assumed"),
      relative("each_remanence_factor", 0.0075, "magnets of one lot: half of what a grade has, assumed"),
  };
  return rows;
}

}  // namespace coilwright::sizing
