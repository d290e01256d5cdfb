#pragma once

#include <array>
#include <span>

#include "coilwright/mechanics/contact_impulses.hpp"
#include "coilwright/mechanics/planar_chain.hpp"

namespace coilwright::mechanics {

/// Jacobian d(x, y)/dq of a point, (2, n).
using FloatingJacobian = Eigen::Matrix<double, 2, Eigen::Dynamic, Eigen::ColMajor, 2, max_coordinates>;

/// The places of all links of a floating chain, base first.
using FloatingFrames = std::array<LinkFrame, max_joints + 1>;

/// Rigid links in a vertical plane, joined by hinges, with a base that moves freely: PlanarChain without its support.
///
/// Coordinates q are x and y of the base's own joint (its rear end), m, the base's absolute angle phi and the relative
/// joint angles, rad. Conventions are those of PlanarChain: a link of absolute angle phi has its axis along (sin phi,
/// -cos phi), offsets along (-cos phi, -sin phi), and gravity along -y. Link 0 is the base. Points and centres of mass
/// are computed link by link, by a route that shares nothing with PlanarChain's. Immutable.
class FloatingChain {
 public:
  /// Takes the links, base first. Throws std::invalid_argument naming link, field, rule and value; `gravity` in m/s^2,
  /// finite, >= 0.
  explicit FloatingChain(std::span<const Link> links, double gravity = 9.81);

  [[nodiscard]] int links() const noexcept { return count_; }
  [[nodiscard]] int joints() const noexcept { return count_ - 1; }
  [[nodiscard]] int coordinates() const noexcept { return count_ + 2; }
  /// A link; 0 is the base.
  [[nodiscard]] const Link& link(int index) const noexcept { return links_[index]; }
  [[nodiscard]] double mass() const noexcept;  ///< of all links, kg

  /// The places of the links. The other functions take the frames of their pose.
  [[nodiscard]] FloatingFrames frames(const CoordinateVector& coordinates) const;

  /// Position (x, y) of a point, m.
  [[nodiscard]] Eigen::Vector2d position(const FloatingFrames& frames, const LinkPoint& point) const;
  /// d(position)/dq, (2, n).
  [[nodiscard]] FloatingJacobian jacobian(const FloatingFrames& frames, const LinkPoint& point) const;

  /// M of M q'' + c + g = forces, (n, n); kg, kg m and kg m^2.
  [[nodiscard]] CoordinateMatrix mass_matrix(const FloatingFrames& frames) const;
  /// Centrifugal and Coriolis forces c, N and N m.
  [[nodiscard]] CoordinateVector velocity_forces(const FloatingFrames& frames, const CoordinateVector& rates) const;
  /// Gravity forces g = dV/dq, N and N m.
  [[nodiscard]] CoordinateVector gravity_forces(const FloatingFrames& frames) const;
  /// Sum of velocity_forces() and gravity_forces(), c + g, at the cost of one.
  [[nodiscard]] CoordinateVector bias_forces(const FloatingFrames& frames, const CoordinateVector& rates) const;

  /// Kinetic energy, J.
  [[nodiscard]] double kinetic_energy(const FloatingFrames& frames, const CoordinateVector& rates) const;
  /// Potential energy, J, zero with every centre of mass at y = 0.
  [[nodiscard]] double potential_energy(const FloatingFrames& frames) const;

 private:
  [[nodiscard]] CoordinateVector forces_in_lift(const FloatingFrames& frames, const CoordinateVector& rates,
                                                double lift) const;
  [[nodiscard]] LinkPoint centre(int link) const {
    return {.link = link, .along = links_[link].com_along, .offset = links_[link].com_offset};
  }

  int count_;
  double gravity_;
  std::array<Link, max_joints + 1> links_{};
};

}  // namespace coilwright::mechanics
