#pragma once

#include "coilwright/simulation/linear_model.hpp"
#include "coilwright/text/json/json.hpp"

namespace coilwright::formats {

/// A linear model as linear-model/1: the matrices with the names of their rows and columns, each ending in its unit.
[[nodiscard]] text::Json to_json(const simulation::LinearModel& model);

}  // namespace coilwright::formats
