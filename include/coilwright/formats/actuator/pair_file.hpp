#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "coilwright/magnetics/cylinder_magnet.hpp"
#include "coilwright/magnetics/thick_coil.hpp"
#include "coilwright/magnetics/wrench.hpp"

namespace coilwright::formats {

/// A coil at the origin and a magnet that is posed.
struct CoilAndMagnet {
  magnetics::ThickCoil coil;
  double current{};  ///< A
  magnetics::CylinderMagnet magnet;
};

/// Two coils; the second is posed.
struct TwoCoils {
  magnetics::ThickCoil first;
  double first_current{};  ///< A
  magnetics::ThickCoil second;
  double second_current{};  ///< A
};

/// Two magnets; the second is posed.
struct TwoMagnets {
  magnetics::CylinderMagnet first;
  magnetics::CylinderMagnet second;
};

/// What the command `force` asks: a pair of bodies and the poses of the second one.
struct PairFile {
  std::variant<CoilAndMagnet, TwoCoils, TwoMagnets> bodies;
  std::vector<magnetics::Pose> poses{};  ///< at least one
};

/// Reads
///
///     {"magnet": {"radius_mm", "length_mm", "remanence_T"},
///      "coil": {"inner_radius_mm", "outer_radius_mm", "length_mm", "turns_radial", "turns_axial"},
///      "current_A", "winding", "poses": [{"position_mm": [x, y, z], "axis": [x, y, z]}]}
///
/// or "magnets": [.., ..] or "coils": [.., ..] instead of one of each; two coils have "current_A" for both or
/// "currents_A": [.., ..]. "winding" is paper_shells, layer_centres or uniform (the default). Throws InputError.
[[nodiscard]] PairFile read_pair(const std::filesystem::path& path);

/// The same for a text in memory; `file` is the name its errors carry.
[[nodiscard]] PairFile parse_pair(std::string_view text, std::string file);

}  // namespace coilwright::formats
