#pragma once

#include <string>

#include "truth/finger.hpp"

namespace truth {

/// The declared model, Table II of the paper, as the text of a lumped-model/1. With faces of a stiffness above zero
/// both joints have them.
[[nodiscard]] std::string declared_finger(const Faces& faces = {});

}  // namespace truth
