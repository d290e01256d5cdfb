#pragma once

#include <array>
#include <string_view>

#include "coilwright/actuator/design/value_limits.hpp"
#include "coilwright/magnetics/cylinder_magnet.hpp"
#include "coilwright/magnetics/thick_coil.hpp"
#include "coilwright/text/json/rows.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::formats {

/// The rule of a part's length in the unit of its key, "gap_mm" or "gap_m".
[[nodiscard]] inline text::Rule part_length(std::string_view key) {
  return text::Rule::between(units::from_memory(actuator::shortest_length, key),
                             units::from_memory(actuator::longest_length, key));
}
/// The same in mm.
inline constexpr text::Rule part_dimension =
    text::Rule::between(1e3 * actuator::shortest_length, 1e3 * actuator::longest_length);
/// The same of an outer radius, which no inner one can equal.
inline constexpr text::Rule outer_dimension =
    text::Rule::above(part_dimension.lower()).and_also(text::Rule::at_most(part_dimension.upper()));
/// Whether a wall (m) is thinner than any part; the least one that a file can say is not, for all that the difference
/// of 5.05 and 5 mm is a little less than 0.05 mm.
[[nodiscard]] constexpr bool is_thinner_than_any(double wall) {
  constexpr double rounding = 1e-9;
  return wall < (1.0 - rounding) * actuator::shortest_length;
}
inline constexpr text::Rule design_remanence =
    text::positive.and_also(text::Rule::at_most(actuator::most_remanence));  // T
inline constexpr text::Rule effective_remanence =
    text::positive.and_also(text::Rule::at_most(actuator::most_effective_remanence));  // T

inline constexpr text::Rule recoil_rule = text::Rule::between(1, magnetics::CylinderMagnet::most_recoil_permeability);

/// Of layers, or of turns in a layer.
inline constexpr text::Rule turns_rule = text::Rule::between(1, 10'000);

inline constexpr std::array magnet_rows = [] {
  using Spec = magnetics::CylinderMagnet::Spec;
  using enum text::Need;
  using text::row;
  return std::array{
      row<&Spec::radius>("radius_mm", part_dimension, "Of the cylinder", required),
      row<&Spec::length>("length_mm", part_dimension, "Along the axis", required),
      row<&Spec::remanence>("remanence_T", effective_remanence, "Of the material", required),
      row<&Spec::recoil_permeability>("recoil_permeability", recoil_rule, "Relative; NdFeB 1.05"),
  };
}();
inline constexpr std::array coil_rows = [] {
  using Spec = magnetics::ThickCoil::Spec;
  using enum text::Need;
  using text::row;
  return std::array{
      row<&Spec::inner_radius>("inner_radius_mm", part_dimension, "Of the winding", required),
      row<&Spec::outer_radius>("outer_radius_mm", outer_dimension, "Of the winding; beyond the inner one", required),
      row<&Spec::length>("length_mm", part_dimension, "Along the axis", required),
      row<&Spec::turns_radial>("turns_radial", turns_rule, "Layers", required),
      row<&Spec::turns_axial>("turns_axial", turns_rule, "Turns in a layer", required),
  };
}();

/// {"radius_mm", "length_mm", "remanence_T", "recoil_permeability" (1 if absent)}, of which a CylinderMagnet can be
/// made; its remanence keeps the rule: of a material, or of what a fit may find.
[[nodiscard]] magnetics::CylinderMagnet::Spec read_magnet(const text::Node& node, const text::Rule& remanence);

/// {"inner_radius_mm", "outer_radius_mm", "length_mm", "turns_radial", "turns_axial"}, of which a ThickCoil can be
/// made.
[[nodiscard]] magnetics::ThickCoil::Spec read_coil(const text::Node& node, magnetics::CurrentDistribution winding);

/// "winding", one of paper_shells, layer_centres, uniform; `otherwise` when it is not there.
[[nodiscard]] magnetics::CurrentDistribution read_winding(
    text::ObjectReader& in, magnetics::CurrentDistribution otherwise = magnetics::CurrentDistribution::uniform);

/// The key "magnet" of a pair.
[[nodiscard]] text::Json magnet_json(const magnetics::CylinderMagnet::Spec& magnet);

/// The key "coil" of a pair; where its current flows stands beside it (`winding_words`).
[[nodiscard]] text::Json coil_json(const magnetics::ThickCoil::Spec& coil);

}  // namespace coilwright::formats
