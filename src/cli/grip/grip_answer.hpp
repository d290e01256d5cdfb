#pragma once

#include <optional>

#include "coilwright/simulation/performance.hpp"
#include "coilwright/systems/gripper/grasp.hpp"
#include "coilwright/systems/gripper/placement_tolerance.hpp"
#include "grip_options.hpp"

namespace coilwright::cli {

/// What becomes of the object of `grip`.
struct GripAnswer {
  double current{};   ///< A, in every coil
  bool is_of_file{};  ///< whether it is that of the file's operating point
  systems::gripper::Grasp grasp;
  systems::gripper::PlacementTolerance tolerance{};  ///< of an object that is held
  double cost{};                                     ///< US$, of the gripper with driver and supply
  double burns_from{};  ///< A: from this current on a finger bent like that has no steady temperature
  std::optional<simulation::Heat> heat{};          ///< of one finger at the pose of the hold
  std::optional<double> demagnetisation_margin{};  ///< of the worst magnet of a straight finger at 20 degC
  /// Of the current, A, and of the coefficient of friction, where asked for; nothing inside if none up to the given
  /// one holds it.
  std::optional<std::optional<double>> least_current{};
  std::optional<std::optional<double>> least_friction{};
};

/// Closes the gripper on the object, lifts and loads it. Throws InputError naming the file or the options whose rule is
/// broken.
[[nodiscard]] GripAnswer answer_of(const GripOptions& options);

/// Whether a finger bent like that has no steady temperature at this current.
[[nodiscard]] bool burns(const GripAnswer& answer);

/// Whether the coils' field takes the magnets' strength for good.
[[nodiscard]] bool is_demagnetised(const GripAnswer& answer);

}  // namespace coilwright::cli
