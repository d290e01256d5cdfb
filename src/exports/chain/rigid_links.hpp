#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "coilwright/actuator/model/model.hpp"

namespace coilwright::exports {

/// What a joint is called in every format: "joint1" is the first.
[[nodiscard]] std::string joint_name(int joint);

/// A link of a planar chain as a body in space. Its frame is at its joint; at angle 0 it is that of the world, z up, so
/// that the link hangs along -z. Joints turn about -y: a positive angle bends the chain towards +x, and opens the slits
/// on its -x side.
struct RigidLink {
  Eigen::Vector3d joint;   ///< own joint in the frame of the link before, m
  Eigen::Vector3d centre;  ///< of mass, m
  double mass{};           ///< kg
  /// About the centre of mass, of every axis, kg m^2: what the plane tells of y. A point mass has the least that a
  /// simulator takes for a body, 1e-7 of mass times distance squared.
  double inertia{};
  Eigen::Vector3d box_centre;  ///< of a box to look at, m
  Eigen::Vector3d box_size;    ///< whole lengths, m
};

/// The links of a chain, base to tip.
[[nodiscard]] std::vector<RigidLink> rigid_links(const mechanics::PlanarChain& chain);

/// A point of a link in its frame, m.
[[nodiscard]] Eigen::Vector3d in_frame(double along, double offset);

/// Numbers with spaces between them, each with the fewest digits that read back as the same double.
[[nodiscard]] std::string words(const std::vector<double>& numbers);
/// The same for a vector.
[[nodiscard]] std::string coordinates(const Eigen::Vector3d& vector);

/// Why such a body is not all that a segment is: one line.
[[nodiscard]] std::string planar_inertia_remark();

}  // namespace coilwright::exports
