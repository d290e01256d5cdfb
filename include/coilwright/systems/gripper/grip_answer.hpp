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

/// The least value of a number with which an object is held.
struct LeastToHold {
  double most{};                  ///< largest value tried
  std::optional<double> found{};  ///< absent: not even the largest holds it
};

/// The answer of `grip`: the state of the object and of the fingers.
struct GripAnswer {
  Mounting mounting{};
  Object object{};
  double current{};   ///< A, in every coil
  bool is_of_file{};  ///< whether that is the current of the file's operating point
  Grasp grasp;
  PlacementTolerance tolerance{};  ///< of an object that is held
  double cost{};                   ///< US$, of the gripper with driver and supply
  double burns_from{};  ///< smallest current from which on a finger in that pose has no steady temperature, A
  std::optional<simulation::Heat> heat{};  ///< of one finger at the pose of the hold
  /// Demagnetisation of a straight finger's magnets at 20 degC; absent if they have no grade.
  std::optional<actuator::Demagnetisation> magnets_cold{};
  /// Demagnetisation at the temperatures of a hold without end; absent if there are none.
  std::optional<actuator::Demagnetisation> magnets_held{};
  std::optional<LeastToHold> least_current{};   ///< A; absent: not asked for
  std::optional<LeastToHold> least_friction{};  ///< coefficient; absent: not asked for

  /// Whether a finger in that pose has no steady temperature at this current.
  [[nodiscard]] bool burns() const { return std::abs(current) >= burns_from; }

  /// Whether the coils' field demagnetises the magnets for good before they warm up.
  [[nodiscard]] bool is_demagnetised() const { return magnets_cold && magnets_cold->margin < 0.0; }

  /// The contacts that are reported: of more than two fingers, which all move alike, one stands for all.
  [[nodiscard]] std::vector<GraspContact> told_contacts() const {
    std::vector<GraspContact> told = grasp.contacts;
    if (mounting.fingers > 2) std::erase_if(told, [](const GraspContact& each) { return each.finger != 0; });
    return told;
  }

  /// The name of a contact's finger: "left" or "right"; "each" for more than two fingers.
  [[nodiscard]] std::string_view finger_name(const GraspContact& contact) const {
    if (mounting.fingers > 2) return "each";
    return contact.finger == 0 ? "left" : "right";
  }
};

/// Further questions about a grip; 0: not asked.
struct GripSearch {
  double most_current{};   ///< largest current tried for the least one that holds, A; 0: not asked for
  double most_friction{};  ///< largest coefficient tried for the least one that holds; 0: not asked for
};

/// Closes fingers of `design` that hang as `mounting` says on the object, lifts it, loads it until it slips, and
/// computes the heat of coils and magnets. `supply` drives one finger. Throws as Gripper and grasp().
[[nodiscard]] GripAnswer grip(const actuator::Design& design, const Mounting& mounting, const Object& object,
                              const GraspTask& task, const actuator::Supply& supply, const GripSearch& search);

}  // namespace coilwright::systems::gripper
