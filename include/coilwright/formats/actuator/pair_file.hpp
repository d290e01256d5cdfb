#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/magnetics/body.hpp"
#include "coilwright/magnetics/forces.hpp"
#include "coilwright/magnetics/plate.hpp"
#include "coilwright/text/json/json.hpp"

namespace coilwright::formats {

/// The question of the commands `force` and `field`: bodies, and poses of the last one.
struct PairFile {
  std::vector<magnetics::Body> bodies;      ///< at least one; the last one's pose is poses[0]
  std::vector<std::string> names;           ///< of each, for people: "coil 1" where the file gives none
  std::vector<magnetics::Pose> poses{};     ///< of the last body; at least one
  std::optional<magnetics::Plate> plate{};  ///< plate beside the bodies
  std::optional<double> plate_radius{};     ///< extent of the plate about its position, m; absent: endless
  /// Whether the file lists its bodies and asks for the load on each. Otherwise it is a pair, and asks for the load on
  /// the second.
  bool listed{};

  /// The bodies with the last one in a pose of `poses`.
  [[nodiscard]] std::vector<magnetics::Body> bodies_at(const magnetics::Pose& pose) const;
};

/// Reads a pair
///
///     {"magnet": {"radius_mm", "length_mm", "remanence_T"},
///      "coil": {"inner_radius_mm", "outer_radius_mm", "length_mm", "turns_radial", "turns_axial"},
///      "current_A", "winding", "poses": [{"position_mm": [x, y, z], "axis": [x, y, z]}]}
///
/// or a list of bodies
///
///     {"bodies": [{"name", "coil" or "magnet", "current_A", "winding", "position_mm", "axis", "x_axis"}], "poses"}
///
/// either with a "plate". A pair may also be of two "magnets" or two "coils". docs/formats-pair.md explains every key.
/// Throws InputError.
[[nodiscard]] PairFile read_pair(const std::filesystem::path& path);

/// Parses a pair from a text in memory; errors call it `file`.
[[nodiscard]] PairFile parse_pair(std::string_view text, std::string file);

/// Throws InputError of the pair called `who` if one of `bodies` from `first` on is in the same place as one before it,
/// unless both are coils or round magnets magnetised along their axis; the force there would be meaningless. `bodies`
/// are those of the file in pose number `pose`.
void require_apart(const PairFile& file, std::span<const magnetics::Body> bodies, std::size_t first, std::size_t pose,
                   const std::string& who);

/// The forces on these bodies. Throws InputError if they are beyond what can be computed.
[[nodiscard]] magnetics::Forces forces_on(const PairFile& file, const std::vector<magnetics::Body>& bodies,
                                          std::size_t pose, const std::string& who);

/// A coil and a magnet with the poses of the magnet as an input file of the command `force`. Reading it back gives the
/// same pair.
[[nodiscard]] text::Json to_json(const magnetics::DrivenCoil& coil, const magnetics::CylinderMagnet& magnet,
                                 std::span<const magnetics::Pose> poses);

}  // namespace coilwright::formats
