#pragma once

#include <span>
#include <string>

#include "coilwright/sizing/search/pareto.hpp"
#include "coilwright/sizing/study/broken_part_limits.hpp"
#include "coilwright/sizing/study/study.hpp"

namespace coilwright::report {

/// The ends of the front and its middle as a table, and the limits of parts that its designs break; or the design
/// nearest to feasible.
[[nodiscard]] std::string to_text(const sizing::Study& study, const sizing::ParetoResult& result,
                                  std::span<const sizing::BrokenPartLimit> broken);

}  // namespace coilwright::report
