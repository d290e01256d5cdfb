#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "coilwright/magnetics/body.hpp"
#include "coilwright/magnetics/plate.hpp"
#include "coilwright/text/json/object_reader.hpp"

namespace coilwright::formats {

/// A magnet of any shape: the keys of a cylinder, a ring or a block, "remanence_T", "recoil_permeability" (1 if absent)
/// and "magnetised_along" (z if absent).
[[nodiscard]] magnetics::Magnet read_magnet(const text::Node& node);

/// {"position_mm", "axis"} and, if it is there, "x_axis".
[[nodiscard]] magnetics::Pose read_pose(const text::Node& node);

/// A body of a list.
struct NamedBody {
  std::string name;  ///< empty where the file gives none
  magnetics::Body body;
};

/// {"name", "coil" with "current_A" and "winding", or "magnet"} and, unless it is posed elsewhere, "position_mm" (the
/// origin if absent), "axis" (+z) and "x_axis".
[[nodiscard]] NamedBody read_body(const text::Node& node, bool posed_here);

/// "coil 1", "magnet 2": what a body is, and its place in the file from 1 on.
[[nodiscard]] std::string usual_name(const magnetics::Body& body, std::size_t index);

/// A plate and how far it extends about its position, m, where the file tells it.
struct PlateContent {
  magnetics::Plate plate;
  std::optional<double> radius;
};

/// {"position_mm" (the origin if absent), "normal" (+z if absent), "thickness_mm", "relative_permeability" (that of a
/// perfect mirror if absent), "radius_mm"}.
[[nodiscard]] PlateContent read_plate(const text::Node& node);

/// Refuses bodies of which some is behind the face of the plate at `node`.
void require_in_front(const text::Node& node, const magnetics::Plate& plate, std::span<const magnetics::Body> bodies);

}  // namespace coilwright::formats
