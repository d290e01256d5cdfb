#pragma once

#include "coilwright/measurement/data/dataset.hpp"

namespace coilwright::measurement::data {

/// The set with every fourth fit run of each kind sealed, from the second on, so that every kind with at least two runs
/// keeps some on both sides; the sealed files are listed in `held_out`. A set that has validate runs, or no kind with
/// two runs, is returned as it is.
[[nodiscard]] Dataset with_runs_held_out(Dataset data);

}  // namespace coilwright::measurement::data
