#pragma once

#include <span>

#include "coilwright/report/simulation/document.hpp"
#include "coilwright/sizing/search/pareto.hpp"
#include "coilwright/sizing/study/broken_part_limits.hpp"
#include "coilwright/sizing/study/study.hpp"

namespace coilwright::report {

/// What `pareto` says: the ends of the front and its middle, and the limits of parts that its designs break (`broken`);
/// or the design nearest to feasible.
[[nodiscard]] Document document_of(const sizing::Study& study, const sizing::ParetoResult& result,
                                   std::span<const sizing::BrokenPartLimit> broken);

}  // namespace coilwright::report
