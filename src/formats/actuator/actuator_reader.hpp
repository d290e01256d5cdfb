#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "coilwright/actuator/calibrate.hpp"
#include "coilwright/actuator/design/design.hpp"
#include "coilwright/actuator/design/parameters.hpp"
#include "coilwright/actuator/design/value_limits.hpp"
#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "coilwright/actuator/model/lumped_model.hpp"
#include "coilwright/actuator/model/model_spec.hpp"
#include "coilwright/actuator/operating_point.hpp"
#include "coilwright/formats/actuator/parameter_rule.hpp"
#include "coilwright/text/json/document.hpp"
#include "coilwright/text/json/rows.hpp"
#include "formats/actuator/choice_words.hpp"
#include "formats/actuator/magnetic_parts.hpp"

namespace coilwright::formats {

/// Every key of an operating point but its current, which a study may vary; what is absent stays as it is in `point`.
void read_operating_conditions(text::ObjectReader& in, actuator::OperatingPoint& point);

/// The key "effects" of an actuator file, `[{"id": "dry_friction", "parameters": {"torque_Nmm": 0.61}}]`: effects that
/// the model has beside its stages. Empty where the key is absent. An effect is one of `known`.
[[nodiscard]] std::vector<actuator::Effect> read_effects(text::ObjectReader& in,
                                                         const actuator::EffectCatalogue& known);

/// Far beyond any hardware, and near enough that nothing overflows or takes for ever.
inline constexpr double largest_number = 1e6;
/// The rule of what was measured, but for lengths.
inline constexpr text::Rule measurement_rule = text::positive.and_also(text::Rule::at_most(largest_number));
/// The numbers of "measured". That of `fixed` says how another was measured.
inline constexpr std::array measured_rows = [] {
  using actuator::Measured;
  using enum text::Need;
  using text::row;
  return std::array{
      row<&Measured::coil_outer_radius>("coil_outer_radius_mm", part_dimension, "Of the winding"),
      row<&Measured::coil_length>("coil_length_mm", part_dimension, "Of the winding"),
      row<&Measured::joint_stiffness>("joint_stiffness_Nmm_rad", measurement_rule, "Of one hinge"),
      row<&Measured::joint_damping>("joint_damping_Nmms_rad", measurement_rule, "Of one hinge"),
      row<&Measured::axis_offset>("axis_offset_mm", part_dimension, "Hinge line to coil axis"),
      row<&Measured::magnet_segment_mass>("magnet_segment_mass_g", measurement_rule,
                                          "Of a segment with a magnet that is not the last"),
      row<&Measured::tip_segment_mass>("tip_segment_mass_g", measurement_rule,
                                       "Of a last segment with a coil, front part included"),
      row<&Measured::tip_com>("tip_com_mm", part_dimension, "Centre of mass of the last segment from its joint"),
      row<&Measured::coil_resistance>("coil_resistance_Ohm", measurement_rule, "Of one coil at 20 degC"),
      row<&Measured::continuous_current>("continuous_current_A", measurement_rule,
                                         "The current that, held, brings the hottest coil to its limit"),
      // A posture, not a size: closed joints are at 0.
      row<&Measured::continuous_current_joint_angle>("continuous_current_joint_angle_deg", text::Rule::between(0, 180),
                                                     "Angle of every joint while continuous_current_A was held, 30 "
                                                     "where it is not said",
                                                     fixed),
  };
}();

/// Where stiffness and damping were measured, all of it or none.
inline constexpr std::array hinge_reference_rows = [] {
  using actuator::HingeReference;
  using enum text::Need;
  using text::row;
  return std::array{
      row<&HingeReference::width>("width_mm", part_dimension, "Of the cross-section", required),
      row<&HingeReference::bottom_layer>("bottom_layer_mm", part_dimension, "The silicone below the cut", required),
      row<&HingeReference::stiffness>("joint_stiffness_Nmm_rad", measurement_rule, "Of one hinge", required),
      row<&HingeReference::damping>("joint_damping_Nmms_rad", text::Rule::between(0, largest_number), "Of one hinge",
                                    required),
      row<&HingeReference::first_mode>("first_mode_Hz", measurement_rule,
                                       "Of the finger, hanging straight, without magnets", required),
  };
}();

/// What an `actuator/1` file says.
struct DesignContent {
  actuator::Design design;                                    ///< calibrated by what was measured
  actuator::Measured measured;                                ///< empty where the file has no "measured"
  std::optional<actuator::OperatingPoint> operating_point{};  ///< for which it was sized
};

/// The keys of `actuator/1` but format and name; its effects are of `known`.
[[nodiscard]] DesignContent read_design(text::ObjectReader& in, const actuator::EffectCatalogue& known);

/// One of "A" to "D".
[[nodiscard]] actuator::Configuration read_configuration(const text::Node& node);

/// ["coil", "magnet", ...], every polarity 1 where no other is given.
[[nodiscard]] actuator::Layout read_row(const text::Node& list, const std::optional<text::Node>& polarity);

/// [1, -1, ...], one for each component, into a row.
void read_polarity(const text::Node& node, actuator::Layout& layout);

/// The value of a parameter that has names, from one of them.
[[nodiscard]] double read_name(const text::Node& node, const actuator::Parameter& parameter);

/// What a text must be that is to name a value of it: `must be one of "none", "N35", ...`, with the nearest.
[[nodiscard]] std::string name_rule(const actuator::Parameter& parameter, std::string_view text);

/// What a `lumped-model/1` file says, and what was computed of it to see that it makes a model.
struct LumpedModelContent {
  actuator::LumpedModel model;
  actuator::LumpedMagnetics magnetics;
};

inline constexpr std::string_view gravity_key = "gravity_m_s2";
inline constexpr double usual_gravity = 9.81;  // m/s^2
inline constexpr text::Rule gravity_rule = text::Rule::between(0, actuator::most_gravity);

inline constexpr std::array link_rows = [] {
  using mechanics::Link;
  using enum text::Need;
  using text::row;
  return std::array{
      row<&Link::length>("length_m", text::non_negative, "This joint to the next, the last one to the tip", required),
      row<&Link::com_along>("com_along_m", text::finite, "Centre of mass along the link", required),
      row<&Link::com_offset>("com_offset_m", text::finite,
                             "Centre of mass across the link, towards the side on which the joints open", required),
      row<&Link::mass>("mass_kg", text::positive, "Of the link", required),
      row<&Link::inertia>("inertia_kgm2", text::non_negative, "About the centre of mass", required),
  };
}();
/// Of the chain, and written with the joint: a rotor turns with that.
inline constexpr std::array rotor_rows = {text::row<&mechanics::Link::rotor_inertia>(
    "rotor_inertia_kgm2", text::non_negative,
    "Of a rotor that a gear turns with the joint, as the joint feels it: gear ratio squared times the rotor's")};
inline constexpr std::array joint_rows = [] {
  using actuator::Hinge;
  using enum text::Need;
  using text::row;
  return std::array{
      row<&Hinge::stiffness>("stiffness_Nm_rad", text::non_negative, "Of the spring", required),
      row<&Hinge::damping>("damping_Nms_rad", text::non_negative, "Of the damper", required),
      row<&Hinge::torque_offset>("torque_offset_Nm", text::finite, "Added at every angle"),
  };
}();
inline constexpr std::array contact_rows = [] {
  using mechanics::FaceContact;
  using enum text::Need;
  using text::row;
  return std::array{
      row<&FaceContact::closing_angle>("closing_angle_deg", text::finite, "Where it begins", required),
      row<&FaceContact::stiffness>("stiffness_Nm_rad", text::positive, "Of the stop", required),
      row<&FaceContact::damping>("damping_Nms_rad", text::non_negative, "Of the stop"),
  };
}();

/// The lengths of a pair, which have names of ours and the paper's, in any unit of length.
inline constexpr std::array geometry_rows = [] {
  using magnetics::HingeGeometry;
  std::array rows{
      text::row<&HingeGeometry::coil_offset>("coil_offset_mm", part_dimension,
                                             "Joint to the centre of the coil, along"),
      text::row<&HingeGeometry::magnet_offset>("magnet_offset_mm", part_dimension,
                                               "Joint to the centre of the magnet, along"),
      text::row<&HingeGeometry::axis_offset>("axis_offset_mm", part_dimension,
                                             "Hinge line to the axis of coil and magnet, across"),
  };
  rows[0].also = "l_a_mm";
  rows[1].also = "l_b_mm";
  rows[2].also = "h_mm";
  return rows;
}();

/// The keys of `lumped-model/1` but format and name.
[[nodiscard]] LumpedModelContent read_lumped_model(text::ObjectReader& in, const actuator::EffectCatalogue& known);

/// An actuator file in terms of its own numbers.
struct ActuatorContent {
  std::string name;
  std::variant<DesignContent, LumpedModelContent> content;
};

/// Its effects are of `known`.
[[nodiscard]] ActuatorContent read_actuator_content(const text::Document& document,
                                                    const actuator::EffectCatalogue& known);

}  // namespace coilwright::formats
