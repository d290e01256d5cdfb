#pragma once

namespace coilwright::simulation {

/// What one would write first: the prototype's step response by classical Runge-Kutta steps of 0.1 ms, with the force
/// of the paper's shells, (13)-(19) corrected, from Boost.Math's K, E and Pi each time it is asked for.
struct Straightforward {
  double current{};   ///< A
  double duration{};  ///< s
};

/// Largest bending speed on the way, rad/s.
[[nodiscard]] double peak_speed(const Straightforward& step);

/// Axial force of coil on magnet at a distance of centres (m), N, positive for repulsion.
[[nodiscard]] double shell_force(double distance, double current);

}  // namespace coilwright::simulation
