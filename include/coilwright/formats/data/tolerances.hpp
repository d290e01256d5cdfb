#pragma once

#include <string>
#include <vector>

namespace coilwright::formats {

/// What a data set says of the accuracy of one declared number.
struct NamedTolerance {
  /// A JSON pointer to a number of the actuator file, or `force_curve`, `joint_stiffness_ratio`, `joint_damping_ratio`,
  /// `face_closing_deg`.
  std::string name;
  double deviation{};  ///< one standard deviation, in the unit of the name; >= 0, and 0 for a number that is exact
};

/// What a data set says of the accuracy of its declared numbers.
struct Tolerances {
  bool others_exact{};                  ///< whether numbers that are not named are exact; otherwise they have defaults
  std::vector<NamedTolerance> named{};  ///< each name once

  /// Every declared number is exact.
  [[nodiscard]] static Tolerances exact() { return {.others_exact = true}; }
};

}  // namespace coilwright::formats
