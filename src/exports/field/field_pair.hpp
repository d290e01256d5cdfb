#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "coilwright/actuator/model/model.hpp"
#include "coilwright/exports/exported_file.hpp"
#include "coilwright/exports/settings.hpp"
#include "coilwright/exports/subject.hpp"

namespace coilwright::exports {

/// A coil and the magnet beside it on one axis, as a program for fields of axial symmetry takes them. SI.
struct FieldPair {
  magnetics::ThickCoil::Spec coil{};  ///< its current is uniform over the section
  magnetics::CylinderMagnet::Spec magnet{};
  double gap{};      ///< between their faces, m; > 0
  double current{};  ///< A; positive repels the magnet
  /// Half of the largest extent of both together, m: what meshes and boundaries are in proportion to.
  double size{};
};

/// The first coil and magnet on the two sides of a joint, with the joint straight. Throws std::invalid_argument naming
/// the rule where the model has no such pair (a table of torque alone) or no air between the two.
[[nodiscard]] FieldPair field_pair(const actuator::Model& model, const ExportSettings& settings);

/// Distance from the centre of the coil to the centre of the magnet, m.
[[nodiscard]] double centre_distance(const FieldPair& pair);

/// Force on the magnet by Coilwright, N, away from the coil, under the pair's current.
[[nodiscard]] double force_on_magnet(const FieldPair& pair);

/// A number of a pair as files of field programs write it: lengths in mm, the rest in SI.
struct FieldNumber {
  std::string_view name;
  double value{};
  std::string_view meaning;
};
/// The coil and the shape of the magnet.
[[nodiscard]] std::vector<FieldNumber> shape_numbers(const FieldPair& pair);
/// Where they are, and under which current.
[[nodiscard]] std::vector<FieldNumber> place_numbers(const FieldPair& pair);

/// The same pair as the file of the command `force`: pair.json.
[[nodiscard]] ExportedFile pair_file(const FieldPair& pair);

/// What a field of axial symmetry does not have of the model: one line each.
[[nodiscard]] std::vector<std::string> beyond_the_pair(const actuator::Model& model);

/// Two lines for the head of a file: what it is, and the force that Coilwright computes.
[[nodiscard]] std::vector<std::string> about(const FieldPair& pair, const Origin& origin);

}  // namespace coilwright::exports
