#pragma once

#include <string>

#include "coilwright/actuator/model/lumped_model.hpp"
#include "coilwright/text/json/json.hpp"

namespace coilwright::formats {

/// A model given by its numbers as a `lumped-model/1` file under `name`, with a `description` for people (left out
/// where it is empty). Read back, it is the same model to rounding. A table is written over angle_deg and torque_Nmm_A,
/// a pair by its dimensions; a joint without a pair has null. Throws std::invalid_argument where a pair has no joint
/// among the links, or two have the same.
[[nodiscard]] text::Json to_json(const actuator::LumpedModel& model, const std::string& name,
                                 const std::string& description = "");

}  // namespace coilwright::formats
