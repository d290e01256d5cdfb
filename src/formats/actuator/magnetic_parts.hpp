#pragma once

#include "coilwright/magnetics/cylinder_magnet.hpp"
#include "coilwright/magnetics/thick_coil.hpp"
#include "coilwright/text/json/object_reader.hpp"

namespace coilwright::formats {

/// {"radius_mm", "length_mm", "remanence_T"}
[[nodiscard]] magnetics::CylinderMagnet read_magnet(const text::Node& node);

/// {"inner_radius_mm", "outer_radius_mm", "length_mm", "turns_radial", "turns_axial"}
[[nodiscard]] magnetics::ThickCoil read_coil(const text::Node& node, magnetics::CurrentDistribution winding);

/// "winding", one of paper_shells, layer_centres, uniform; uniform when it is not there.
[[nodiscard]] magnetics::CurrentDistribution read_winding(text::ObjectReader& in);

}  // namespace coilwright::formats
