#pragma once

#include <Eigen/Core>
#include <array>

#include "truth/finger.hpp"
#include "truth/quirks.hpp"

namespace truth {

/// What moves in time: angles and rates, then what the quirks remember. Fields that no quirk uses stay zero.
struct Slot {
  static constexpr int angle = 0;  // two
  static constexpr int rate = 2;   // two
  static constexpr int coil_heat = 4;
  static constexpr int magnet_heat = 5;
  static constexpr int creep = 6;       // two
  static constexpr int hysteresis = 8;  // two
  static constexpr int mount = 10;      // displacement, speed
  static constexpr int count = 12;
};
using Phase = std::array<double, Slot::count>;

/// What is the same from one sample to the next.
struct Held {
  double target{};         ///< A, what the driver aims at
  double since{};          ///< s, when it began to
  double from{};           ///< A, in the coils at that time: the lag between is an exponential, known in closed form
  double pull{};           ///< N m on both joints
  double stiffness = 1.0;  ///< share that is left of it, drift
  std::array<double, 2> largest_angle{};
  double shake_phase{};  ///< rad
};

/// Lagrange's equations of (1)-(8) by d'Alembert: the momentum of the two point masses, projected on what each joint
/// moves, with the mount's displacement as a third coordinate. Coulomb friction is a mode a joint: sliding up (1) or
/// down
/// (-1), or held (0).
class Dynamics {
 public:
  Dynamics(const Finger& finger, const Quirks& quirks);

  Held held;
  std::array<int, 2> modes{};

  /// d(phase)/dt at time `t`, s.
  void operator()(const Phase& phase, Phase& slope, double t) const;

  /// Torque that holds a joint which is stuck, N m, against what acts on it; 0 for one that slides.
  [[nodiscard]] std::array<double, 2> holding_torques(const Phase& phase, double t) const;

  /// Accelerations, rad/s^2.
  [[nodiscard]] std::array<double, 2> accelerations(const Phase& phase, double t) const;

  /// Torques left over at rest, friction apart, N m.
  [[nodiscard]] Eigen::Vector2d static_residual(const Phase& phase) const;

  /// At `angles`, at rest for ever under the held target: all memories settled.
  [[nodiscard]] Phase settled(const Eigen::Vector2d& angles) const;

  /// Of the command, by the driver's quirks of no memory, A.
  [[nodiscard]] double target(double command) const;

  /// In the coils before they are warm, A.
  [[nodiscard]] double current(double t) const;

  [[nodiscard]] const Quirks& quirks() const { return quirks_; }

 private:
  struct Balance {
    Eigen::Matrix3d inertia;
    Eigen::Vector3d force;
  };
  [[nodiscard]] Balance balance(const Phase& phase, double t) const;
  [[nodiscard]] Eigen::Vector3d solve(const Balance& balance) const;
  [[nodiscard]] Eigen::Vector2d joint_torques(const Phase& phase, double t) const;

  Finger finger_;
  Quirks quirks_;
  std::array<double, 2> stop_damping_{};
};

}  // namespace truth
