#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "coilwright/actuator/model/model_spec.hpp"
#include "coilwright/text/json/object_reader.hpp"

namespace coilwright::formats {

/// What a `lumped-model/1` file says, in SI: what may be changed and made a model of again.
struct LumpedModel {
  double gravity{};  ///< m/s^2
  std::vector<mechanics::Link> links{};
  std::vector<actuator::Hinge> hinges{};
  std::vector<actuator::HingePair> pairs{};  ///< one for each joint with a coil; the current of each is its own
  std::shared_ptr<const actuator::CoilRow> coil_row{};  ///< see place_coils()
  std::vector<actuator::Effect> effects{};
};

/// A number of a link, of a hinge or of its contact.
template <class Part>
struct LumpedNumber {
  std::string_view key;
  text::Rule rule;
  double Part::*member{};
  std::optional<double> otherwise{};  ///< SI, where the key may be absent
};

inline constexpr std::string_view gravity_key = "gravity_m_s2";
inline constexpr double usual_gravity = 9.81;  // m/s^2

/// Every number of the file but gravity and magnetics: the reader and the numbers that may be calibrated share these.
inline constexpr std::array link_numbers = {
    LumpedNumber<mechanics::Link>{"length_m", text::non_negative, &mechanics::Link::length},
    LumpedNumber<mechanics::Link>{"com_along_m", text::finite, &mechanics::Link::com_along},
    LumpedNumber<mechanics::Link>{"com_offset_m", text::finite, &mechanics::Link::com_offset},
    LumpedNumber<mechanics::Link>{"mass_kg", text::positive, &mechanics::Link::mass},
    LumpedNumber<mechanics::Link>{"inertia_kgm2", text::non_negative, &mechanics::Link::inertia},
};
inline constexpr std::array joint_numbers = {
    LumpedNumber<actuator::Hinge>{"stiffness_Nm_rad", text::non_negative, &actuator::Hinge::stiffness},
    LumpedNumber<actuator::Hinge>{"damping_Nms_rad", text::non_negative, &actuator::Hinge::damping},
    LumpedNumber<actuator::Hinge>{"torque_offset_Nm", text::finite, &actuator::Hinge::torque_offset, 0.0},
};
inline constexpr std::array contact_numbers = {
    LumpedNumber<mechanics::FaceContact>{"closing_angle_deg", text::finite, &mechanics::FaceContact::closing_angle},
    LumpedNumber<mechanics::FaceContact>{"stiffness_Nm_rad", text::positive, &mechanics::FaceContact::stiffness},
    LumpedNumber<mechanics::FaceContact>{"damping_Nms_rad", text::non_negative, &mechanics::FaceContact::damping, 0.0},
};

/// The keys of `lumped-model/1` but format and name.
[[nodiscard]] LumpedModel read_lumped_model(text::ObjectReader& in, const actuator::EffectCatalogue& known);

/// The entries of "magnetics": one per joint, null for a joint without a coil.
[[nodiscard]] std::vector<actuator::HingePair> read_lumped_magnetics(const text::Node& node, std::size_t joints);

/// Sets `coil_row` anew, as `links` and `pairs` have become. A finger of two joints with a pair on each is taken for
/// configuration B: a coil on the base and one on the last link, the magnet between them. Where the coils of another
/// rig are, its lumps do not say, and there is no row.
void place_coils(LumpedModel& lumped);

/// What a Model is made of. Throws std::invalid_argument where a link breaks its rules.
[[nodiscard]] actuator::ModelSpec spec_of(const LumpedModel& lumped);

}  // namespace coilwright::formats
