#pragma once

#include <string_view>

namespace coilwright::exports {

/// pair.geo: geometry and mesh of a coil and a magnet on one axis, by the numbers of pair_data.pro.
extern const std::string_view getdp_geometry;

/// pair.pro: their static field and the axial force by two routes, on the mesh of pair.geo.
extern const std::string_view getdp_problem;

}  // namespace coilwright::exports
