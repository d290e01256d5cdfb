#pragma once

#include "truth/finger.hpp"

namespace truth {

/// Axial force of coil on magnet per ampere, coaxial, centres `z` apart, repulsion positive, N/A. The coil is
/// `turns_radial` shells, both radii included (the paper's (14)); the magnet is its surface current.
[[nodiscard]] double coaxial_force(const Pair& pair, double z);

/// The paper's torque per ampere: the coaxial force along the line of centres, on the arm of that line about the joint
/// ((20) to (22), with (21) as corrected), N m/A, opening positive.
[[nodiscard]] double line_of_centres_torque(const Pair& pair, double angle);

/// The torque of all Lorentz forces on the magnet's surface current about the joint, N m/A.
[[nodiscard]] double exact_torque(const Pair& pair, double angle);

/// Mutual inductance of the finger's two coils at a pose, H.
[[nodiscard]] double coil_coil_inductance(const Pair& pair, double first_angle, double second_angle);

/// Torques per square ampere that the coils put on the joints when both carry the same current, N m/A^2.
struct CoilCoilTorque {
  double first{};
  double second{};
};

/// The curves above for the pair of Table II, interpolated. Angles from -60 to 150 degrees; constant beyond.
namespace curves {
[[nodiscard]] double line_of_centres(double angle);
[[nodiscard]] double exact(double angle);
[[nodiscard]] CoilCoilTorque coil_coil(double first_angle, double second_angle);
}  // namespace curves

}  // namespace truth
