#pragma once

#include <optional>

#include "coilwright/actuator/model/torque_correction.hpp"
#include "coilwright/text/json/json.hpp"
#include "coilwright/text/json/object_reader.hpp"

namespace coilwright::formats {

/// The key of an actuator file under which a torque without a name stands.
inline constexpr const char* torque_correction_key = "torque_correction";

/// The key "torque_correction" of an actuator file:
/// `{"angle_deg": [..], "rate_rad_s": [..], "linear_below_rad_s": 0.5, "torque_Nmm": [[..], ..], "joint": 2}` with one
/// or two of angle_deg, rate_rad_s and current_A; a row of torques for each node of the first of them. Nothing where
/// the key is absent.
[[nodiscard]] std::optional<actuator::TorqueCorrection> read_torque_correction(text::ObjectReader& in);

/// The same key: read back, it is the same correction to rounding.
[[nodiscard]] text::Json to_json(const actuator::TorqueCorrection& correction);

}  // namespace coilwright::formats
