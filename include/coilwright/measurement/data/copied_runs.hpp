#pragma once

#include <span>
#include <vector>

#include "coilwright/measurement/data/dataset.hpp"

namespace coilwright::measurement::data {

/// A warning for each run whose readings are, every one, those of a run before it (of `fit` first, then of `validate`):
/// a file that was copied under another name. It tells nothing new, and held out of the fit it is no test of it. Runs
/// of fewer than 20 samples, or of readings that never change, are no copies.
[[nodiscard]] std::vector<Warning> copied_runs(std::span<const Run> fit, std::span<const Run> validate);

}  // namespace coilwright::measurement::data
