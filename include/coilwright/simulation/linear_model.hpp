#pragma once

#include <Eigen/Core>
#include <complex>
#include <optional>
#include <vector>

#include "coilwright/actuator/model/model.hpp"
#include "coilwright/simulation/modes.hpp"

namespace coilwright::simulation {

/// Small motions about an equilibrium, for the design of a controller: x' = A x + B u, y = C x + D u.
///
/// x are deviations of the n joint angles (rad), of their n rates (rad/s) and of those states of effects that return by
/// themselves (each in its own SI unit); u is one deviation of the current in every coil, or one for each coil (A); y
/// are deviations of the bending angle and of the n joint angles (rad), the true ones and not those that a camera
/// shows.
struct LinearModel {
  mechanics::JointVector angles;                  ///< of the equilibrium, rad
  actuator::CoilCurrents currents;                ///< of each coil there, A
  Eigen::MatrixXd a;                              ///< (2n + e, 2n + e)
  Eigen::MatrixXd b;                              ///< (2n + e, m): m = 1 for all coils alike, or one for each coil
  Eigen::MatrixXd c;                              ///< (1 + n, 2n + e)
  Eigen::MatrixXd d;                              ///< (1 + n, m): zeros, because a torque first changes a rate
  int effect_states{};                            ///< e
  std::vector<Mode> modes;                        ///< of the chain, slowest first
  std::vector<std::complex<double>> eigenvalues;  ///< of A, 1/s; conjugates side by side
  std::optional<Eigen::MatrixXd> dc_gain;         ///< -C A^-1 B + D, rad/A; absent if A is singular
  /// Whether something sticks (dry friction, hysteresis). The model then describes motions that exceed the friction,
  /// and not those that it holds.
  bool sticks{};
  std::vector<int> pressed_joints;  ///< joints whose faces push there; the model holds while they do

  /// Whether all small motions decay.
  [[nodiscard]] bool stable() const;
};

/// The linear model about the stable equilibrium to which `model` goes from its pose without current, under the same
/// `current` (A, finite) in every coil. Throws std::invalid_argument if it has no coils, or effects with bodies of
/// their own (a mount, a loose magnet), which the states leave out; std::runtime_error if there is no such equilibrium,
/// or if a joint rests there beyond the angles over which its torque is known. It does not check whether the parts bear
/// the current; evaluate does.
[[nodiscard]] LinearModel linearise(const actuator::Model& model, double current);

/// The linear model with a separate current in every coil (A, finite, one for each, base to tip), each of them an
/// input.
[[nodiscard]] LinearModel linearise(const actuator::Model& model, const actuator::CoilCurrents& currents);

}  // namespace coilwright::simulation
