#pragma once

#include <functional>
#include <string>
#include <vector>

#include "coilwright/actuator/model/model.hpp"
#include "coilwright/control/arrival.hpp"
#include "coilwright/control/current_profile.hpp"
#include "coilwright/simulation/modes.hpp"

namespace coilwright::control {

/// The task to reach a bending angle from rest, fast and without ringing, by a current profile without a sensor.
struct ReachTask {
  double angle{};                ///< bending angle to reach, rad
  double start_current{};        ///< in every coil before, A
  double lowest_current{};       ///< lowest current of the driver, A
  double highest_current{};      ///< highest current of the driver, A; > lowest_current
  double stiffness_error = 0.1;  ///< relative error of k of all hinges; 0 to 0.5
  double damping_error = 0.1;    ///< relative error of b of all hinges; 0 to 0.5
  int pieces = 3;                ///< levels of the searched profile before the last one, 1 to 6
};

/// A profile with the arrivals to which it leads.
struct ProfileQuality {
  std::string name;  ///< "step", "zero_vibration", "zero_vibration_derivative", "searched"
  CurrentProfile profile;
  Arrival nominal;
  /// The latest arrival among the finger as declared and those with k and b off either way. Its overshoot is the
  /// largest of all.
  Arrival worst;
};

/// The result of reach(): the profiles and what they start from.
struct Reach {
  double current{};                      ///< current that holds the angle, A
  simulation::Mode mode;                 ///< the slowest mode of small motions at the angle
  double duration{};                     ///< duration for which every profile was followed, s
  std::vector<ProfileQuality> profiles;  ///< step, the two shapers, searched; at least the step
  double least_end{};                    ///< smallest end of the bending angle with k and b off, rad
  double greatest_end{};                 ///< largest end; no profile without a sensor can reduce the difference
};

/// Finds the current that holds the angle, shapes a step to it for the slowest mode, and searches with NLopt (Nelder
/// and Mead on subspaces, from both shapers and from the highest current) for the levels and lengths of the profile
/// with the least worst Arrival::time_outside over the five fingers. The same task gives the same answer. Throws
/// std::invalid_argument naming the field, the rule and the value, and std::runtime_error with the reason if the angle
/// cannot be reached or the plain step does not settle.
[[nodiscard]] Reach reach(const actuator::Model& model, const ReachTask& task);

/// The profile whose worst finger settles first; of equals the earlier one. Profiles that overshoot by more than
/// most_overshoot come after all that do not.
[[nodiscard]] const ProfileQuality& best_profile(const Reach& reach);

}  // namespace coilwright::control
