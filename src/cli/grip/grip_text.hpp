#pragma once

#include <string>

#include "grip_answer.hpp"

namespace coilwright::cli {

/// The answer of `grip` as a person reads it.
[[nodiscard]] std::string as_text(const GripOptions& options, const GripAnswer& answer);

/// The same as JSON, with the units in the names.
[[nodiscard]] std::string as_json(const GripOptions& options, const GripAnswer& answer);

}  // namespace coilwright::cli
