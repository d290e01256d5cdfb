#pragma once

#include <string>

#include "coilwright/sizing/search/pareto.hpp"
#include "coilwright/sizing/study/study.hpp"

namespace coilwright::report {

/// The ends of the front and its middle as a table, or the design nearest to feasible.
[[nodiscard]] std::string to_text(const sizing::Study& study, const sizing::ParetoResult& result);

}  // namespace coilwright::report
