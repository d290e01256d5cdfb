#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "coilwright/magnetics/body.hpp"

namespace coilwright::magnetics {

/// The flux density of bodies at a point, and its gradient there.
struct FieldSample {
  Eigen::Vector3d flux_density = Eigen::Vector3d::Zero();  ///< B, T
  Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero();      ///< element (i, j): dB_i / dx_j, T/m
};

/// Flux density B of all bodies and its gradient at each of many points, anywhere: beside the bodies, in bores, in
/// copper and in magnets, by closed forms. B errs by less than 1e-9 of the largest flux density near a body, the
/// gradient by 1e-6 of that over the body's radius. On a surface, where B jumps, it is that just outside. On an edge of
/// a magnet, where it is infinite, and within 1e-12 of its size of one, it is a finite number without meaning. Theory
/// and sources: docs/theory/magnetics.md, "Field". Throws std::invalid_argument for a body that breaks a rule, and for
/// a point that is not finite.
[[nodiscard]] std::vector<FieldSample> field(std::span<const Body> bodies, std::span<const Eigen::Vector3d> points);

/// Flux density B alone, T: the same numbers in half the time.
[[nodiscard]] std::vector<Eigen::Vector3d> flux_density(std::span<const Body> bodies,
                                                        std::span<const Eigen::Vector3d> points);

/// Whether a point lies on an edge of a body, within 1e-12 of its size, where field() is infinite: the edge of a
/// magnet's face through which it is magnetised.
[[nodiscard]] bool is_on_edge(const Body& body, const Eigen::Vector3d& point);

/// Whether a point lies in a body's copper or magnet, excluding its surface.
[[nodiscard]] bool is_inside(const Body& body, const Eigen::Vector3d& point);

}  // namespace coilwright::magnetics
