#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <span>
#include <vector>

#include "coilwright/mechanics/joint_vector.hpp"

namespace coilwright::mechanics {

/// The largest number of generalised coordinates of a system with contacts: two of the longest chains and two bodies.
inline constexpr int max_coordinates = 2 * max_joints + 8;

/// One value per generalised coordinate.
using CoordinateVector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, max_coordinates, 1>;
/// (n, n) over generalised coordinates.
using CoordinateMatrix =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, max_coordinates, max_coordinates>;

/// Coulomb friction that may differ with the direction of sliding.
struct DirectionalFriction {
  double along{};    ///< coefficient while the contact slides along +tangent; finite, >= 0
  double against{};  ///< while it slides along -tangent; finite, >= 0
};

/// A closed contact in the plane: how fast it opens and slides, over the generalised velocities.
struct Contact {
  CoordinateVector normal;   ///< normal speed = normal . velocities, positive where the contact opens
  CoordinateVector tangent;  ///< sliding speed = tangent . velocities
  DirectionalFriction friction{};
};

/// Impulses and state of one contact in a step.
struct ContactImpulse {
  double normal{};         ///< N s (N m s where the row is of an angle), >= 0
  double tangential{};     ///< along +tangent; between -along and +against times the normal impulse
  double normal_speed{};   ///< after the step, m/s, >= 0 except for rounding
  double sliding_speed{};  ///< after the step, m/s
};

/// Velocities after a step, and the impulses that caused them.
struct ContactStep {
  CoordinateVector velocities;
  std::vector<ContactImpulse> impulses;  ///< one per contact, in their order
};

/// Velocities v and impulses p of one step with unilateral contacts and dry friction, without restitution:
///
///   mass (v - free_velocity) = sum of normal_i n_i + tangent_i t_i,   0 <= n_i, 0 <= normal speed, one of them zero,
///   -along n_i <= t_i <= against n_i, and a contact that slides is resisted by all that the friction gives.
///
/// `mass` is (n, n), symmetric and positive definite; `free_velocity` is the velocity at the end of the step without
/// contacts. Moreau, Numerical aspects of the sweeping process, Comput. Methods Appl. Mech. Eng. 177 (1999) 329. In the
/// plane this is a linear complementarity problem, solved exactly by Lemke's method: Stewart and Trinkle, Int. J.
/// Numer. Methods Eng. 39 (1996) 2673. If several impulses give the same motion (a table of four legs), one of them is
/// returned. Pure. Throws std::invalid_argument naming field, rule and value, and std::runtime_error if the method
/// finds no answer that keeps all conditions to 1e-8 of the largest speed, or to 1e-5 for a wedged body that rigid
/// contacts would hold by unbounded impulses.
[[nodiscard]] ContactStep contact_impulses(const CoordinateMatrix& mass, const CoordinateVector& free_velocity,
                                           std::span<const Contact> contacts);

/// The same with a mass matrix that is factorised already.
[[nodiscard]] ContactStep contact_impulses(const Eigen::LLT<CoordinateMatrix>& mass,
                                           const CoordinateVector& free_velocity, std::span<const Contact> contacts);

}  // namespace coilwright::mechanics
