#pragma once

#include "coilwright/control/reach.hpp"
#include "coilwright/text/json/json.hpp"

namespace coilwright::formats {

/// The answer of `reach` as reach/1: every profile with its levels and its arrivals; keys end in their unit. A settling
/// time is null if the motion was still outside the band at the end.
[[nodiscard]] text::Json to_json(const control::Reach& reach);

}  // namespace coilwright::formats
