#pragma once

#include <array>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "coilwright/actuator/calibrate.hpp"
#include "coilwright/actuator/model/lumped_model.hpp"

namespace coilwright::measurement::replay {

/// How well a number of a built actuator is known where nobody says: docs/formats-dataset.md, "Tolerances".
struct DefaultTolerance {
  std::string name;    ///< as in `tolerances`
  double deviation{};  ///< one standard deviation: of a number in the file over that number; of a difference in the
                       ///< unit of the name
  std::vector<std::string> instead_of{};  ///< names in whose place it stands: left out where one of them is said
};

/// All of them, with the strongest first where two act alike; of a design, by what was measured on it.
[[nodiscard]] std::vector<DefaultTolerance> default_tolerances(const actuator::Measured& measured);
[[nodiscard]] std::vector<DefaultTolerance> default_tolerances(const actuator::LumpedModel& model);

/// What is taken as exact where nobody says otherwise, in plain words.
[[nodiscard]] std::vector<std::string> exact_by_default_of_design();
[[nodiscard]] std::vector<std::string> exact_by_default_of_lumped_model();

/// A factor of all torque per ampere: of the magnets' strength where that is no number of the file.
inline constexpr std::string_view force_gain_name = "force_curve_0";

/// Standard deviations of the coefficients c_1 to c_3 over the rms error of a curve's shape: sqrt((2 n + 1) w_n), with
/// shares w of 80, 16 and 4 % of its variance. The error of the paper's approximation on its finger has 83, 16 and 1 %,
/// those of wrong lengths have 93 to 99 % in the first, those of a wrong coil radius 10 to 26, 58 to 67 and 14 to 19 %.
inline constexpr std::array<double, 4> force_curve_shares = {0.0, 1.5491933384829668, 0.8944271909999159,
                                                             0.5291502622129182};

/// Up to where the joints of a finger work, rad: the prototype's bend to 28 degrees each at 1.05 A, gripping ones
/// further.
inline constexpr double widest_working_angle = 60.0 * std::numbers::pi / 180.0;

/// Effects whose names changes of numbers of a file bear.
inline constexpr std::array<std::pair<std::string_view, std::string_view>, 3> effects_of_numbers = {
    {{"/measured/tip_segment_mass_g", "added_mass"},
     {"/calibration/coil_segment_mass_factor", "added_mass"},
     {"/surroundings/base_tilt_deg", "base_tilt"}}};

}  // namespace coilwright::measurement::replay
