#pragma once

#include <Eigen/Core>
#include <span>

#include "coilwright/magnetics/body.hpp"
#include "coilwright/magnetics/field.hpp"

namespace coilwright::magnetics {

/// What is asked of a field: the gradient takes as long again.
enum class Wanted { flux_density, gradient };

/// Adds the field of a coil or a round magnet to `samples`, one for each of `points`, all in the body's own axes.
void add_round_field(const DrivenCoil& coil, Wanted wanted, std::span<const Eigen::Vector3d> points,
                     std::span<FieldSample> samples);
void add_round_field(const Ring& ring, const Eigen::Vector3d& polarisation, Wanted wanted,
                     std::span<const Eigen::Vector3d> points, std::span<FieldSample> samples);

/// The same of a block.
void add_cuboid_field(const Cuboid& cuboid, const Eigen::Vector3d& polarisation, Wanted wanted,
                      std::span<const Eigen::Vector3d> points, std::span<FieldSample> samples);

}  // namespace coilwright::magnetics
