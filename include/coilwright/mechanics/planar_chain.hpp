#pragma once

#include <Eigen/Core>
#include <array>
#include <span>

#include "coilwright/mechanics/joint_vector.hpp"

namespace coilwright::mechanics {

/// A rigid segment of the chain. "Along" is the direction from its own joint to the next along the hinge line, "offset"
/// the direction across it, towards the side on which the chain's joints open.
struct Link {
  double length{};      ///< own joint to next joint, m; finite, >= 0
  double com_along{};   ///< centre of mass along the link, m; finite
  double com_offset{};  ///< centre of mass across the link, m; finite (the paper's h)
  double mass{};        ///< kg; finite, > 0
  double inertia{};     ///< about the centre of mass, kg m^2; finite, >= 0
  /// Inertia of a rotor that a gear turns with the own joint, as the joint feels it (gear ratio squared times the
  /// rotor's), kg m^2; finite, >= 0. Its energy is half of this times the joint's rate squared. The part that turns
  /// with the carrying link is smaller by the ratio and belongs to that link's inertia. A FloatingChain has none.
  double rotor_inertia{};
};

/// A point fixed to a link, in the link's own along and offset coordinates, m.
struct LinkPoint {
  int link{};       ///< index of the link, 0 is the first that moves; -1 is the fixed base
  double along{};   ///< m
  double offset{};  ///< m
};

/// Jacobian d(x, y)/dtheta of a point, (2, n), m/rad.
using PointJacobian = Eigen::Matrix<double, 2, Eigen::Dynamic, Eigen::ColMajor, 2, max_joints>;

/// Place of a link: its own joint, m, and sine and cosine of its absolute angle.
struct LinkFrame {
  Eigen::Vector2d joint;
  double sine{};
  double cosine{};

  [[nodiscard]] Eigen::Vector2d axis() const { return {sine, -cosine}; }  ///< along the link, unit length
  /// Position of the point at `along` and `offset` of the link, m.
  [[nodiscard]] Eigen::Vector2d at(double along, double offset) const {
    return joint + along * axis() + offset * Eigen::Vector2d(-cosine, -sine);
  }
};

/// The base (as link -1), then every link: the frame of link i has index i + 1. Those of a shorter chain end earlier.
using LinkFrames = std::array<LinkFrame, max_joints + 1>;

/// Slopes of a chain's equation of motion M theta'' + c + g = tau about one motion: the further joint torque for small
/// changes of accelerations, rates and angles. (n, n) each; only the first is symmetric.
struct ChainSlopes {
  JointMatrix by_acceleration;  ///< the mass matrix M, kg m^2
  JointMatrix by_rate;          ///< dc/dtheta', N m s/rad
  JointMatrix by_angle;         ///< d(M theta'' + c + g)/dtheta at these accelerations, N m/rad
};

/// n rigid links in a vertical plane, joined by hinges, hanging from a fixed base joint at the origin.
///
/// Joint angles are relative, rad, all zero if the chain hangs along gravity (-y). A point at (along, offset) of a link
/// with absolute angle phi lies at its joint + along (sin phi, -cos phi) + offset (-cos phi, -sin phi). For two links
/// of equal com_offset h this is (1)-(12) of the paper without the spring and damper terms of (11) and (12), which
/// belong to the hinge. Immutable; copies are cheap; no heap.
class PlanarChain {
 public:
  /// Takes the links. Throws std::invalid_argument naming link, field, rule and value. `gravity` in m/s^2, finite, >=
  /// 0. `base_tilt` in rad, finite, turns the whole chain towards opening: link j makes the angle phi_j + base_tilt
  /// with gravity, and positions stay in the frame of the base.
  explicit PlanarChain(std::span<const Link> links, double gravity = 9.81, double base_tilt = 0.0);

  [[nodiscard]] int joints() const noexcept { return joints_; }
  /// A link, counted from the base: 0 to joints() - 1.
  [[nodiscard]] const Link& link(int index) const noexcept { return links_[index]; }
  [[nodiscard]] std::span<const Link> links() const noexcept { return std::span(links_).first(joints_); }
  [[nodiscard]] double gravity() const noexcept { return gravity_; }
  [[nodiscard]] double base_tilt() const noexcept { return base_tilt_; }

  /// The same links under another gravity (m/s^2) and base tilt (rad). Throws as the constructor does.
  [[nodiscard]] PlanarChain under_gravity(double gravity, double base_tilt) const;
  /// Other links under the same gravity and base tilt. Throws as the constructor does.
  [[nodiscard]] PlanarChain with_links(std::span<const Link> links) const;

  /// Mass matrix over the relative joint angles, (n, n), kg m^2: (10) of the paper.
  [[nodiscard]] JointMatrix mass_matrix(const JointVector& angles) const;

  /// Centrifugal and Coriolis torques c with M theta'' + c + g = tau, N m: (11) of the paper without b.
  [[nodiscard]] JointVector velocity_torques(const JointVector& angles, const JointVector& rates) const;

  /// Gravity torques g = dV/dtheta, N m: (12) of the paper without k.
  [[nodiscard]] JointVector gravity_torques(const JointVector& angles) const;
  /// Sum of velocity_torques() and gravity_torques(), at the cost of one.
  [[nodiscard]] JointVector bias_torques(const JointVector& angles, const JointVector& rates) const;

  /// Slope of the gravity torques, dg/dtheta, (n, n), N m/rad, symmetric: gravity's part of the stiffness.
  [[nodiscard]] JointMatrix gravity_stiffness(const JointVector& angles) const;

  /// theta'' = M^-1 (tau - c - g), rad/s^2, for joint torques tau (magnetics, springs, dampers, contact), N m.
  [[nodiscard]] JointVector accelerations(const JointVector& angles, const JointVector& rates,
                                          const JointVector& torques) const;

  /// Slopes of M theta'' + c + g about a motion: analytic, for integrators that need a Jacobian.
  [[nodiscard]] ChainSlopes slopes(const JointVector& angles, const JointVector& rates,
                                   const JointVector& accelerations) const;

  /// Acceleration of each joint by a torque of its own while the others move freely: the diagonal of the inverse mass
  /// matrix of the straight chain, 1/(kg m^2), > 0. It limits the stiffness of a contact or a regularisation.
  [[nodiscard]] JointVector joint_mobility() const;

  /// Kinetic energy, J.
  [[nodiscard]] double kinetic_energy(const JointVector& angles, const JointVector& rates) const;

  /// Gravitational potential energy, J, zero with every centre of mass at the height of the base joint.
  [[nodiscard]] double potential_energy(const JointVector& angles) const;

  /// Position (x, y) of a point, m.
  [[nodiscard]] Eigen::Vector2d position(const LinkPoint& point, const JointVector& angles) const;

  /// The places of all links at one pose, for many points.
  [[nodiscard]] LinkFrames frames(const JointVector& angles) const;

  /// d(position)/dtheta, (2, n), m/rad.
  [[nodiscard]] PointJacobian jacobian(const LinkPoint& point, const JointVector& angles) const;
  /// The Jacobian for a chain whose frames() are known.
  [[nodiscard]] PointJacobian jacobian(const LinkPoint& point, const LinkFrames& frames) const;

 private:
  struct Directions;  // sines and cosines of the absolute link angles

  // Each for a number of joints that the compiler knows, or any_count for the one met at run time.
  static constexpr int any_count = 0;
  template <int Count = any_count>
  [[nodiscard]] Directions directions(const JointVector& angles, double tilt) const;
  template <int Count = any_count>
  [[nodiscard]] JointMatrix absolute_mass_matrix(const Directions& d) const;
  template <int Count = any_count>
  [[nodiscard]] JointVector absolute_velocity_torques(const Directions& d, const JointVector& rates) const;
  template <int Count = any_count>
  [[nodiscard]] JointVector absolute_gravity_torques(const Directions& tilted) const;
  template <int Count>
  [[nodiscard]] JointVector accelerations_of(const JointVector& angles, const JointVector& rates,
                                             const JointVector& torques) const;

  int joints_;
  double gravity_;
  double base_tilt_;
  std::array<Link, max_joints> links_{};
  std::array<double, max_joints> outboard_mass_{};  // mass of all links beyond this one
  std::array<double, max_joints> along_moment_{};   // length * outboard mass + mass * com_along
  std::array<double, max_joints> offset_moment_{};  // mass * com_offset
};

}  // namespace coilwright::mechanics
