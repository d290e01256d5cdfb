#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "coilwright/systems/gripper/gripper.hpp"
#include "coilwright/systems/gripper/object.hpp"

namespace coilwright::systems::gripper {

/// The load and the currents of a grasp.
struct GraspTask {
  double current{};       ///< in every coil of all fingers, A, from t = 0; finite
  double open_current{};  ///< current before that, while the object is put between them, A; a negative one opens them;
                          ///< finite
  double acceleration{};  ///< upward acceleration that the hold must survive beside gravity, m/s^2; finite, >= 0
  double step = 2e-3;     ///< the longest time step, s; > 0, at most 2e-3. Motion takes shorter ones.
  bool find_capacity = true;  ///< whether the load is increased until the object is lost
};

/// A place where a finger presses on the object.
struct GraspContact {
  int finger{};              ///< 0 left, 1 right
  int link{};                ///< -1 is the base segment
  double along{};            ///< on the face of that link, from its own joint, m
  Eigen::Vector2d position;  ///< in the gripper's frame, m
  double normal{};           ///< N, >= 0
  double friction{};         ///< N, upwards along the face of the object > 0
};

/// The result of a grasp.
struct Grasp {
  bool holds{};              ///< the load was still held, at rest, 0.2 s after it was reached
  bool both_touched{};       ///< both fingers reached the object
  double missing{};          ///< least distance of the finger that did not touch, m; 0 if both touched
  double closing_time{};     ///< from the current to the touch of the later finger, s; infinite if one never touched
  double load{};             ///< mass times gravity and acceleration, N
  double capacity{};         ///< force of the fingers on the object when it began to slip, N; 0 without a grasp
  bool capacity_is_bound{};  ///< the object was still held at ten times its load: the capacity is at least that
  double settling{};         ///< way by which the object sank between the end of support and the full load, m
  double magnet_force{};     ///< largest force between two magnets of different fingers while holding, N
  mechanics::JointVector left, right;  ///< joint angles, rad: at the end of the hold, or of closing if it does not hold
  std::vector<GraspContact> contacts;  ///< mean over the last 20 ms of that time

  /// Capacity over load; 1 and more where it holds.
  [[nodiscard]] double margin() const { return load > 0.0 ? capacity / load : 0.0; }
};

/// A measure of how well an object is held that grows from out of reach to held firmly, for searches. From 0 on the
/// object is held, and the measure is capacity over load less one. Between -1 and 0 it slips: the same, but at most
/// -0.01. Below -1 a finger does not reach it: -1 less the missing distance over the object's width.
[[nodiscard]] double holding_margin(const Grasp& grasp, const Object& object);

/// The open fingers leave no room for the object, or more than two fingers leave each other none.
class NoRoom : public std::invalid_argument {
 public:
  /// An error with an overlap > 0, m, and the text of what().
  NoRoom(double overlap, const std::string& text) : std::invalid_argument(text), overlap_(overlap) {}
  /// The overlap, m.
  [[nodiscard]] double overlap() const noexcept { return overlap_; }

 private:
  double overlap_;
};

/// Closes fingers on an object that stands on a smooth support, removes the support, loads the object with its weight
/// and the acceleration within 0.3 s, holds for 0.2 s, and increases the load until the object is lost. Segments and
/// object are rigid; dry friction is computed by Moreau and Jean's time stepping, first order in the step.
///
/// More than two fingers all move alike, and the object moves as between two of them that carry their share of it; it
/// has to be round about the gripper's axis and on it. Contacts are those of two fingers; load and capacity those of
/// all. An object that could roll out between three fingers is not detected.
///
/// Throws std::invalid_argument for a task or an object that breaks a rule, NoRoom for an object that the open fingers
/// touch, or fingers that meet their neighbours around it; std::runtime_error if the fingers find no rest.
[[nodiscard]] Grasp grasp(const Gripper& gripper, const Object& object, const GraspTask& task);

/// The least current, A, up to `most`, that holds the object, to 0.5 %; absent if `most` does not hold it, and 0 if the
/// fingers hold it without current. `task.current` is not used.
[[nodiscard]] std::optional<double> least_current(const Gripper& gripper, const Object& object, GraspTask task,
                                                  double most);

/// The least coefficient of friction, up to `most`, with which the task's current holds the object, to 0.5 %; absent if
/// `most` does not hold it. The object's own coefficient is not used.
[[nodiscard]] std::optional<double> least_friction(const Gripper& gripper, Object object, const GraspTask& task,
                                                   double most);

}  // namespace coilwright::systems::gripper
