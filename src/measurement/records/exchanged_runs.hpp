#pragma once

#include <span>
#include <vector>

#include "coilwright/measurement/data/dataset.hpp"
#include "coilwright/measurement/replay/declared_model.hpp"

namespace coilwright::measurement::records {

/// Pairs of motions from rest whose readings stand beside each other's inputs: each is nearer to what the declared
/// model, as it is, shows of the other's. A warning under the name of the first for each pair. Both differences must be
/// significant: the ratio of the mean squares that the model misses by Fisher's F, each with as many degrees of freedom
/// as it has independent samples (signals::correlation_time), at 1 % shared among all pairs.
[[nodiscard]] std::vector<data::Warning> exchanged_runs(std::span<const data::Run> runs,
                                                        const replay::DeclaredModel& declared);

}  // namespace coilwright::measurement::records
