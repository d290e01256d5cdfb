#pragma once

#include "coilwright/actuator/model/model.hpp"

namespace coilwright::actuator {

/// Throws std::invalid_argument where the parts of `spec` do not fit together: links, joints and coils that do not
/// exist, curves that are missing, a stiffness or damping below 0.
void require_consistent(const Model::Spec& spec);

}  // namespace coilwright::actuator
