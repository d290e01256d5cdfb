#pragma once

#include <span>
#include <string_view>

#include "coilwright/page/page.hpp"
#include "coilwright/validation/paper_comparison.hpp"

namespace coilwright::page {

/// The page of a comparison of the model with the figures of the paper: every difference with the band in which it
/// must lie. `made_by` is program and version.
[[nodiscard]] Page comparison_page(std::span<const validation::Comparison> rows, std::string_view made_by);

}  // namespace coilwright::page
