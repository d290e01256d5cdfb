#pragma once

#include <functional>
#include <span>
#include <vector>

#include "measurement/fit/fit.hpp"
#include "measurement/replay/prepared_run.hpp"

namespace coilwright::measurement::fit {

/// Some of the runs of a fit, with what a fit of them, or their residuals, can take over of it: its numbers, their
/// local numbers and derivatives.
struct PartOfFit {
  std::vector<replay::PreparedRun> runs{};
  Fit fit{};  ///< as FitRequest::local_numbers_from and derivatives_from need it; no more
};

/// The runs whose index `keep` selects.
[[nodiscard]] PartOfFit part_of(std::span<const replay::PreparedRun> runs, const Fit& fitted,
                                const std::function<bool(std::size_t)>& keep);

}  // namespace coilwright::measurement::fit
