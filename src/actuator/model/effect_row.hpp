#pragma once

#include <vector>

#include "coilwright/actuator/model/model_spec.hpp"

namespace coilwright::actuator {

/// The effects of `spec` in the order in which a model builds them in and passes through them: by stage; within one in
/// the order of standard_effects(), then a program's own in the order given. Throws std::invalid_argument naming the
/// effect where one breaks its rules, is given twice or cannot be in this model.
[[nodiscard]] std::vector<Effect> effect_row(const ModelSpec& spec);

}  // namespace coilwright::actuator
