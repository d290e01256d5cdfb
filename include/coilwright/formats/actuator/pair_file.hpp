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

/// What the commands `force` and `field` ask about: bodies, and poses of the last one.
struct PairFile {
  std::vector<magnetics::Body> bodies;      ///< at least one; the last one's pose is poses[0]
  std::vector<std::string> names;           ///< of each, for people: "coil 1" where the file gives none
  std::vector<magnetics::Pose> poses{};     ///< of the last body; at least one
  std::optional<magnetics::Plate> plate{};  ///< beside them
  std::optional<double> plate_radius{};     ///< m; how far the plate extends about its position, where that is told
  /// Whether the file lists its bodies, and asks for what acts on each; otherwise it is a pair, and asks for what acts
  /// on the second one.
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
/// or "magnets": [.., ..] or "coils": [.., ..] instead of one of each; two coils have "current_A" for both or
/// "currents_A": [.., ..]. "winding" is paper_shells, layer_centres or uniform (the default). Or any number of bodies
///
///     {"bodies": [{"name", "coil" or "magnet", "current_A", "winding", "position_mm", "axis", "x_axis"}], "poses"}
///
/// of which the last one has "poses" of its own or a pose like the others. A magnet is a cylinder, a ring with
/// "inner_radius_mm" and "outer_radius_mm" or a block with "size_mm", "magnetised_along" [x, y, z] of its axes (z if
/// absent). Beside either "plate": {"position_mm", "normal", "thickness_mm", "relative_permeability", "radius_mm"}.
/// docs/formats.md has every key. Throws InputError.
[[nodiscard]] PairFile read_pair(const std::filesystem::path& path);

/// The same for a text in memory; `file` is the name its errors carry.
[[nodiscard]] PairFile parse_pair(std::string_view text, std::string file);

/// Throws InputError of the pair called `who` where one of `bodies`, which are those of the file in pose number `pose`,
/// from `first` on is in the same place as one before it, and the force there would mean nothing: all but coils and
/// round magnets magnetised along their axis.
void require_apart(const PairFile& file, std::span<const magnetics::Body> bodies, std::size_t first, std::size_t pose,
                   const std::string& who);

/// The forces on these bodies. Throws InputError where they are beyond what can be computed.
[[nodiscard]] magnetics::Forces forces_on(const PairFile& file, const std::vector<magnetics::Body>& bodies,
                                          std::size_t pose, const std::string& who);

/// A coil and a magnet with the poses of the magnet as the file of the command `force`: read back, they are the same.
[[nodiscard]] text::Json to_json(const magnetics::DrivenCoil& coil, const magnetics::CylinderMagnet& magnet,
                                 std::span<const magnetics::Pose> poses);

}  // namespace coilwright::formats
