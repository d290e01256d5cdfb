#pragma once

#include "coilwright/sizing/study/yield.hpp"
#include "coilwright/text/json/json.hpp"

namespace coilwright::formats {

/// What `yield --json` prints; its keys are in docs/formats-results.md.
[[nodiscard]] text::Json to_json(const sizing::Yield& yield);

}  // namespace coilwright::formats
