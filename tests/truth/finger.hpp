#pragma once

#include <array>

namespace truth {

/// Coil and magnet of the source paper's Table II, m and T.
struct Pair {
  double inner_radius = 3e-3;
  double outer_radius = 9.5e-3;
  double coil_length = 12e-3;
  int turns_radial = 15;
  int turns_axial = 30;
  double magnet_radius = 10e-3;
  double magnet_length = 6e-3;
  double remanence = 1.44;
  double coil_offset = 6.3e-3;    ///< joint to the coil's centre along the chain, l_0
  double magnet_offset = 3.6e-3;  ///< joint to the magnet's centre, l_1
  double axis_offset = 11.5e-3;   ///< joint to the common axis across, h
};

/// Faces of two segments that push, and never pull, where a joint closes further than `angle`: the torque
/// max(0, stiffness p - damping rate) at the penetration p.
struct Faces {
  double angle{};      ///< rad
  double stiffness{};  ///< N m/rad; 0 for a joint without faces
  double damping{};    ///< N m s/rad
};

/// Smooth relative error of the torque per ampere over the joint angle: coefficients of the Chebyshev polynomials of
/// degree 1 to 4 over -20 to 70 degrees, constant beyond.
using CurveError = std::array<double, 4>;

[[nodiscard]] double curve_error(const CurveError& error, double angle);

/// The two-link finger of the paper: Table II, SI. A built finger differs from it.
struct Finger {
  double first_mass = 16.5e-3;
  double second_mass = 22.5e-3;
  double half_pitch = 3.6e-3;    ///< l_1: half of the first link
  double second_com = 9.1e-3;    ///< l_2
  double axis_offset = 11.5e-3;  ///< h
  double stiffness = 12.5e-3;    ///< N m/rad
  double damping = 0.129e-3;     ///< N m s/rad
  double gravity = 9.81;         ///< m/s^2
  double coil_resistance = 4.0;  ///< ohm, for a voltage drive: 4.2 V and 1.05 A in the paper's robot
  double tip_length = 21.2e-3;   ///< second joint to the tip, along the link

  double second_stiffness_ratio = 1.0;  ///< second joint over first
  double second_damping_ratio = 1.0;
  std::array<double, 2> force_factor{1.0, 1.0};  ///< of the torque per ampere of each joint: remanence over Table II's
  CurveError curve_error{};                      ///< of both joints: their coils are alike
  Faces faces{};                                 ///< of both joints
};

}  // namespace truth
