#pragma once

#include <Eigen/Core>
#include <array>

#include "truth/finger.hpp"
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
  static constexpr int mount = 10;      // displacement, speed
  static constexpr int count = 12;
};
using StateVector = std::array<double, StateIndex::count>;

/// Quantities that are constant from one sample to the next.
struct HeldInput {
  double target{};         ///< A, steady current of the driver
  double since{};          ///< s, time from which that holds
  double from{};           ///< A, current in the coils at that time: the lag between both is exponential
  double pull{};           ///< N m on both joints
  double stiffness = 1.0;  ///< share of the stiffness that drift has left
  std::array<double, 2> largest_angle{};
  double shake_phase{};  ///< rad
};

/// Lagrange's equations of (1)-(8) by d'Alembert's principle: the momentum of the two point masses, projected on the
/// directions in which each joint moves them, with the displacement of the mount as a third coordinate. Coulomb
/// friction gives each joint a mode: sliding up (1) or down (-1), or held (0).
class Dynamics {
 public:
  Dynamics(const Finger& finger, const UnmodelledEffects& effects);

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

  /// Current in cold coils, A.
  [[nodiscard]] double current(double t) const;

  [[nodiscard]] const UnmodelledEffects& effects() const { return effects_; }

 private:
  struct Balance {
    Eigen::Matrix3d inertia;
    Eigen::Vector3d force;
  };
  [[nodiscard]] Balance balance(const StateVector& state, double t) const;
  [[nodiscard]] Eigen::Vector3d solve(const Balance& balance) const;
  [[nodiscard]] Eigen::Vector2d joint_torques(const StateVector& state, double t) const;

  Finger finger_;
  UnmodelledEffects effects_;
  std::array<double, 2> stop_damping_{};
};

}  // namespace truth
