#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "coilwright/magnetics/field.hpp"
#include "coilwright/magnetics/plate.hpp"

namespace coilwright::magnetics {

/// The field of bodies beside a plate at many points, and the places of these points.
struct FieldPlaces {
  std::vector<FieldSample> samples{};
  std::vector<std::size_t> within{};   ///< number of the body that a point lies in, from 1 on; 0 for none
  std::vector<std::size_t> on_edge{};  ///< number of the magnet on whose edge a point lies, where B is infinite; or 0
  std::vector<bool> in_iron{};  ///< whether the point is behind the face of the plate, where its mirror does not hold
};

/// Computes the field. Without `gradient` the gradients are 0. Throws as field().
[[nodiscard]] FieldPlaces field_places(std::span<const Body> bodies, const std::optional<Plate>& plate,
                                       std::span<const Eigen::Vector3d> points, bool gradient);

}  // namespace coilwright::magnetics
