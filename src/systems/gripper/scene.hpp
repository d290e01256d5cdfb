#pragma once

#include <array>
#include <optional>
#include <vector>

#include "coilwright/mechanics/moreau_step.hpp"
#include "coilwright/systems/gripper/grasp.hpp"
#include "systems/gripper/face_contacts.hpp"

namespace coilwright::systems::gripper {

/// What acts on a scene from outside.
struct Actions {
  double current{};  ///< in every coil, A
  double load{};     ///< on the object, downwards, N
  bool support{};    ///< whether it stands on a smooth plane
  bool apart{};      ///< whether nothing touches: the object stays where it is
};

/// The farthest that a fingertip or the surface of the object moves in a step, m: in flight, where contacts are met, as
/// much as in 0.2 ms at 0.5 m/s; what hardly moves takes the longest steps.
inline constexpr double longest_way = 1e-4;

/// Both fingers and the object, in motion. Coordinates: joints of the left finger, of the right one, x, y and angle of
/// the object.
class Scene {
 public:
  /// Fingers at rest under this current, A, each by itself; the object where it is. Throws std::invalid_argument if the
  /// fingers touch it there, std::runtime_error if they find no rest.
  Scene(const Gripper& gripper, const Object& object, double current);

  /// One step, of `longest`, s, or as much less as nothing moves by more than longest_way in, and a motion that has
  /// just been started can be followed in; gives what it took, s.
  double advance(const Actions& actions, double longest);

  /// Takes the speed of everything away.
  void halt() { velocity_.setZero(); }

  /// A contact of the last step: where, and with which forces, N. A step in which something lands has parts, and a
  /// contact in each of them; their forces are shares of the mean over the step.
  struct Touch {
    FacePoint point;
    double normal{}, tangential{};
  };
  [[nodiscard]] const std::vector<Touch>& touches() const noexcept { return touches_; }
  [[nodiscard]] bool touches(int finger) const;
  /// With which both fingers lift the object in the last step, N.
  [[nodiscard]] double lifting_force() const;
  /// Gap between a finger and the object in the middle of the last step, m; infinite where no face looks at the object.
  [[nodiscard]] double gap(int finger) const { return gaps_[static_cast<std::size_t>(finger)]; }
  /// Throws std::invalid_argument if a finger overlaps the object.
  void require_apart() const;
  [[nodiscard]] ObjectPose object() const;
  [[nodiscard]] Eigen::Vector2d object_velocity() const { return velocity_.segment<2>(2 * joints_); }
  [[nodiscard]] mechanics::JointVector angles(int finger) const { return position_.segment(finger * joints_, joints_); }
  [[nodiscard]] double magnet_force() const noexcept { return pull_.largest_force; }
  /// Kinetic energy of the fingers, J.
  [[nodiscard]] double finger_energy() const;

 private:
  [[nodiscard]] mechanics::MiddleOfStep middle(const mechanics::CoordinateVector& position,
                                               const mechanics::CoordinateVector& velocity, double duration,
                                               const Actions& actions);
  void add_fingers(const mechanics::CoordinateVector& position, const mechanics::CoordinateVector& velocity,
                   const Actions& actions, double duration, mechanics::MiddleOfStep& out) const;
  void add_contacts(const mechanics::CoordinateVector& position, const mechanics::CoordinateVector& velocity,
                    double duration, const Actions& actions, mechanics::MiddleOfStep& out);
  [[nodiscard]] double duration_of_step(const Actions& actions, double longest, double speed);
  void pull_by_magnets(double way, double duration);
  // Whether faces of a joint meet within `duration`, s, or press while it moves.
  [[nodiscard]] bool joints_close(double duration) const;
  // Of a fingertip or the surface of the object, m/s: none is faster.
  [[nodiscard]] double fastest() const;

  const Gripper& gripper_;
  const Object& object_;
  Eigen::Index joints_;
  mechanics::JointVector reaches_;  // from each joint to the tip of the straight finger, m
  double support_height_;
  mechanics::CoordinateVector position_, velocity_;
  std::vector<FacePoint> closed_;  // of the contacts of the last step that are a finger's, in their order
  std::vector<Touch> touches_;
  std::array<double, 2> gaps_{};  // m
  Gripper::Pull pull_;
  double pull_way_;                   // moved since then, m
  double pull_age_;                   // s
  std::optional<Actions> actions_{};  // of the last step
  double last_step_{};                // s
};

}  // namespace coilwright::systems::gripper
