#pragma once

#include "coilwright/page/page.hpp"
#include "coilwright/text/json/node.hpp"

// What would change the answer of `size`; `result` is the root of its result.json.

namespace coilwright::page {

/// What one step of each variable and each limit relaxed would bring.
[[nodiscard]] Section sensitivity_section(const text::Node& result);

/// What the answer is under each other modelling choice.
[[nodiscard]] Section assumptions_section(const text::Node& result);

}  // namespace coilwright::page
