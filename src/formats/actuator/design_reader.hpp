#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "coilwright/actuator/calibrate.hpp"
#include "coilwright/actuator/design/design.hpp"
#include "coilwright/actuator/design/parameters.hpp"
#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "coilwright/actuator/operating_point.hpp"
#include "coilwright/formats/actuator/parameter_rule.hpp"
#include "coilwright/text/json/object_reader.hpp"

namespace coilwright::formats {

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

/// A row of coils and magnets: "configuration", or "layout" with an optional "polarity".
[[nodiscard]] actuator::Layout read_layout(text::ObjectReader& in);

/// ["coil", "magnet", ...], every polarity 1 where no other is given.
[[nodiscard]] actuator::Layout read_row(const text::Node& list, const std::optional<text::Node>& polarity);

/// [1, -1, ...], one for each component, into a row.
void read_polarity(const text::Node& node, actuator::Layout& layout);

/// The value of a parameter that has names, from one of them.
[[nodiscard]] double read_name(const text::Node& node, const actuator::Parameter& parameter);

/// What a text must be that is to name a value of it: `must be one of "none", "N35", ...`, with the nearest.
[[nodiscard]] std::string name_rule(const actuator::Parameter& parameter, std::string_view text);

}  // namespace coilwright::formats
