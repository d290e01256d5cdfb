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
#include "coilwright/text/json/object_reader.hpp"
#include "formats/actuator/part_numbers.hpp"

namespace coilwright::formats {

/// A current in every coil, A, as files and the command line take it: nothing computed from it overflows.
inline constexpr text::Rule current_rule = text::Rule::between(-1e6, 1e6);

/// Every key of an operating point but its current, which a study may vary; what is absent stays as it is in `point`.
void read_operating_conditions(text::ObjectReader& in, actuator::OperatingPoint& point);

/// The key "effects" of an actuator file, `[{"id": "dry_friction", "parameters": {"torque_Nmm": 0.61}}]`: effects that
/// the model has beside its stages. Empty where the key is absent. An effect is one of `known`.
[[nodiscard]] std::vector<actuator::Effect> read_effects(text::ObjectReader& in,
                                                         const actuator::EffectCatalogue& known);

/// A key of "measured".
struct MeasuredKey {
  std::string_view key;  ///< its unit at its end
  std::optional<double> actuator::Measured::*member{};
};
inline constexpr std::array measured_keys = {
    MeasuredKey{"coil_outer_radius_mm", &actuator::Measured::coil_outer_radius},
    MeasuredKey{"coil_length_mm", &actuator::Measured::coil_length},
    MeasuredKey{"joint_stiffness_Nmm_rad", &actuator::Measured::joint_stiffness},
    MeasuredKey{"joint_damping_Nmms_rad", &actuator::Measured::joint_damping},
    MeasuredKey{"axis_offset_mm", &actuator::Measured::axis_offset},
    MeasuredKey{"magnet_segment_mass_g", &actuator::Measured::magnet_segment_mass},
    MeasuredKey{"tip_segment_mass_g", &actuator::Measured::tip_segment_mass},
    MeasuredKey{"tip_com_mm", &actuator::Measured::tip_com},
    MeasuredKey{"coil_resistance_Ohm", &actuator::Measured::coil_resistance},
    MeasuredKey{"continuous_current_A", &actuator::Measured::continuous_current},
};

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

inline constexpr std::array link_numbers = {
    PartKey<mechanics::Link>{"length_m", text::non_negative, &mechanics::Link::length},
    PartKey<mechanics::Link>{"com_along_m", text::finite, &mechanics::Link::com_along},
    PartKey<mechanics::Link>{"com_offset_m", text::finite, &mechanics::Link::com_offset},
    PartKey<mechanics::Link>{"mass_kg", text::positive, &mechanics::Link::mass},
    PartKey<mechanics::Link>{"inertia_kgm2", text::non_negative, &mechanics::Link::inertia},
};
/// Of the chain, and written with the joint: a rotor turns with that.
inline constexpr std::array rotor_numbers = {
    PartKey<mechanics::Link>{"rotor_inertia_kgm2", text::non_negative, &mechanics::Link::rotor_inertia, 0.0},
};
inline constexpr std::array joint_numbers = {
    PartKey<actuator::Hinge>{"stiffness_Nm_rad", text::non_negative, &actuator::Hinge::stiffness},
    PartKey<actuator::Hinge>{"damping_Nms_rad", text::non_negative, &actuator::Hinge::damping},
    PartKey<actuator::Hinge>{"torque_offset_Nm", text::finite, &actuator::Hinge::torque_offset, 0.0},
};
inline constexpr std::array contact_numbers = {
    PartKey<mechanics::FaceContact>{"closing_angle_deg", text::finite, &mechanics::FaceContact::closing_angle},
    PartKey<mechanics::FaceContact>{"stiffness_Nm_rad", text::positive, &mechanics::FaceContact::stiffness},
    PartKey<mechanics::FaceContact>{"damping_Nms_rad", text::non_negative, &mechanics::FaceContact::damping, 0.0},
};

/// A length of a pair, which has a name of ours and the paper's: "coil_offset_mm" or "l_a_mm", in any unit of length.
struct GeometryKey {
  std::string_view ours;
  std::string_view paper;
  double magnetics::HingeGeometry::*member{};
};
inline constexpr std::array geometry_keys = {
    GeometryKey{"coil_offset_mm", "l_a_mm", &magnetics::HingeGeometry::coil_offset},
    GeometryKey{"magnet_offset_mm", "l_b_mm", &magnetics::HingeGeometry::magnet_offset},
    GeometryKey{"axis_offset_mm", "h_mm", &magnetics::HingeGeometry::axis_offset},
};

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
