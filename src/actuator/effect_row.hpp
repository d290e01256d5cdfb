#pragma once

#include <vector>

#include "coilwright/actuator/model_spec.hpp"

namespace coilwright::actuator {

/// The effects of `spec` in the order in which a model builds them in and passes through them: by stage; within one as
/// the catalogue has them, then those that it does not have, as given. Throws std::invalid_argument naming the effect
/// where one breaks its rules, is given twice or cannot be in this model.
[[nodiscard]] std::vector<Effect> effect_row(const ModelSpec& spec);

}  // namespace coilwright::actuator
