#pragma once

#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include "coilwright/actuator/demagnetisation.hpp"
#include "coilwright/simulation/performance.hpp"
#include "coilwright/systems/gripper/grasp.hpp"
#include "coilwright/systems/gripper/gripper.hpp"
#include "coilwright/systems/gripper/object.hpp"
#include "coilwright/systems/gripper/placement_tolerance.hpp"

namespace coilwright::systems::gripper {

/// The least of something with which an object is held.
struct LeastToHold {
  double most{};                  ///< up to which it was looked for
  std::optional<double> found{};  ///< nothing: not even the most holds it
};

/// What becomes of an object between fingers, and of the fingers: what `grip` prints.
struct GripAnswer {
  Mounting mounting{};
  Object object{};
  double current{};   ///< A, in every coil
  bool is_of_file{};  ///< whether it is that of the file's operating point
  Grasp grasp;
  PlacementTolerance tolerance{};  ///< of an object that is held
  double cost{};                   ///< US$, of the gripper with driver and supply
  double burns_from{};             ///< A: from this current on a finger bent like that has no steady temperature
  std::optional<simulation::Heat> heat{};  ///< of one finger at the pose of the hold
  /// Of a straight finger's magnets at 20 degC; nothing where they have no grade.
  std::optional<actuator::Demagnetisation> magnets_cold{};
  /// The same at the temperatures of a hold without end; nothing where it has none either.
  std::optional<actuator::Demagnetisation> magnets_held{};
  std::optional<LeastToHold> least_current{};   ///< A; nothing: not asked for
  std::optional<LeastToHold> least_friction{};  ///< coefficient; nothing: not asked for

  /// Whether a finger bent like that has no steady temperature at this current.
  [[nodiscard]] bool burns() const { return std::abs(current) >= burns_from; }

  /// Whether the coils' field takes the magnets' strength for good before they warm up.
  [[nodiscard]] bool is_demagnetised() const { return magnets_cold && magnets_cold->margin < 0.0; }

  /// What a person is told of where the fingers press: of more than two, which do all the same, one stands for all.
  [[nodiscard]] std::vector<GraspContact> told_contacts() const {
    std::vector<GraspContact> told = grasp.contacts;
    if (mounting.fingers > 2) std::erase_if(told, [](const GraspContact& each) { return each.finger != 0; });
    return told;
  }

  /// "left" or "right"; of more than two fingers "each".
  [[nodiscard]] std::string_view finger_name(const GraspContact& contact) const {
    if (mounting.fingers > 2) return "each";
    return contact.finger == 0 ? "left" : "right";
  }
};

/// What is asked of a grip beside the task; 0: not asked for.
struct GripSearch {
  double most_current{};   ///< A, up to which the least one that holds is looked for
  double most_friction{};  ///< coefficient, likewise
};

/// Closes fingers of `design` that hang as `mounting` says on the object, lifts it, loads it until it slips, and says
/// what that does to coils and magnets. `supply` drives one finger. Throws as Gripper and grasp().
[[nodiscard]] GripAnswer grip(const actuator::Design& design, const Mounting& mounting, const Object& object,
                              const GraspTask& task, const actuator::Supply& supply, const GripSearch& search);

}  // namespace coilwright::systems::gripper
