#pragma once

#include <array>
#include <string_view>

#include "coilwright/actuator/design/value_limits.hpp"
#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "coilwright/actuator/model/lumped_model.hpp"
#include "coilwright/actuator/model/model_spec.hpp"
#include "coilwright/text/json/object_reader.hpp"
#include "formats/actuator/part_numbers.hpp"

namespace coilwright::formats {

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

}  // namespace coilwright::formats
