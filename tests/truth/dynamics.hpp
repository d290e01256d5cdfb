#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "truth/finger.hpp"
#include "truth/rig.hpp"
#include "truth/unmodelled_effects.hpp"

namespace truth {

/// Indices of the state vector: angles and rates, then the internal states of effects. Those of absent effects stay
/// zero.
struct StateIndex {
  static constexpr int angle = 0;  // two
  static constexpr int rate = 2;   // two
  static constexpr int coil_heat = 4;
  static constexpr int magnet_heat = 5;
  static constexpr int creep = 6;       // two
  static constexpr int hysteresis = 8;  // two
  static constexpr int mount = 10;      // displacement and speed of the mount, or of the part that bends
  static constexpr int tracking = 12;   // two: the angles that the tracker shows
  static constexpr int travel = 14;     // two: the way of each joint, rad
  static constexpr int friction_heat = 16;
  static constexpr int magnet = 17;       // two: angles of loose magnets from the middles of their seats
  static constexpr int magnet_rate = 19;  // two
  static constexpr int count = 21;
};
using StateVector = std::array<double, StateIndex::count>;

/// Quantities that are constant from one sample to the next.
struct HeldInput {
  double target{};                 ///< A, steady current of the driver
  double since{};                  ///< s, time from which that holds
  double from{};                   ///< A, current in the coils at that time: the lag between both is exponential
  double from_slope{};             ///< A/s, its slope at that time
  double pull{};                   ///< N m on both joints
  std::optional<double> anchor{};  ///< rad, where the first joint was when a sticking cable was last slack
  double stiffness = 1.0;          ///< share of the stiffness that drift has left
  std::array<double, 2> largest_angle{};
  double shake_phase{};       ///< rad
  bool disconnected = false;  ///< whether the coils are open or shorted
};

/// Lagrange's equations of (1)-(8) by d'Alembert's principle: the momentum of the two point masses, projected on the
/// directions in which each joint moves them, with the displacement of the mount as a third coordinate. Coulomb
/// friction gives each joint a mode: sliding up (1) or down (-1), or held (0).
class Dynamics {
 public:
  /// Throws std::invalid_argument for a mount and a segment that both give way: there is one coordinate for either.
  Dynamics(const Finger& finger, const UnmodelledEffects& effects, const Rig& rig = {});

  HeldInput input;
  std::array<int, 2> modes{};

  /// d(state)/dt at time `t`, s.
  void operator()(const StateVector& state, StateVector& slope, double t) const;

  /// Friction torque on a joint that is held, N m; 0 for one that slides.
  [[nodiscard]] std::array<double, 2> holding_torques(const StateVector& state, double t) const;

  /// Accelerations, rad/s^2.
  [[nodiscard]] std::array<double, 2> accelerations(const StateVector& state, double t) const;

  /// Sum of the torques at rest without friction, N m.
  [[nodiscard]] Eigen::Vector2d static_residual(const StateVector& state) const;

  /// The state at rest at `angles`, with all internal states at their steady values under the present input.
  [[nodiscard]] StateVector settled(const Eigen::Vector2d& angles) const;

  /// Steady current of the driver under a command, A.
  [[nodiscard]] double target(double command) const;

  /// Whether the coils are off the driver under a command.
  [[nodiscard]] bool is_disconnected(double command) const;

  /// Current in cold coils, A, and its slope, A/s, of a driver that rings (0 for another).
  [[nodiscard]] double current(double t) const;
  [[nodiscard]] double current_slope(double t) const;

  /// Friction torque of a joint that slides at a rate, or is at rest, N m.
  [[nodiscard]] double friction_at(double rate) const;

  [[nodiscard]] const UnmodelledEffects& effects() const { return effects_; }
  [[nodiscard]] const Finger& finger() const { return finger_; }

 private:
  struct Balance {
    Eigen::Matrix3d inertia;
    Eigen::Vector3d force;
  };
  [[nodiscard]] Balance balance(const StateVector& state, double t) const;
  struct Ringing {
    double current{};
    double slope{};
  };
  [[nodiscard]] Eigen::Vector3d solve(const Balance& balance, const Eigen::Vector2d& rates) const;
  [[nodiscard]] double motional_conductance() const;
  [[nodiscard]] double warm_current(const StateVector& state, double t) const;
  [[nodiscard]] double torque_per_ampere(const StateVector& state, int joint) const;
  [[nodiscard]] Eigen::Vector2d drive_torques(const StateVector& state, double t) const;
  [[nodiscard]] double seat_torque(const StateVector& state, int joint) const;
  [[nodiscard]] Ringing ringing(double t) const;
  [[nodiscard]] double bent_by_gravity(double angle) const;
  [[nodiscard]] Eigen::Vector2d joint_torques(const StateVector& state, double t) const;

  Finger finger_;
  UnmodelledEffects effects_;
  Rig rig_;
  std::array<double, 2> stop_damping_{};
  std::array<double, 2> loose_inertia_{};  // kg m^2, of loose magnets
};

}  // namespace truth
