#pragma once

#include <span>

#include "coilwright/measurement/signals/noise_level.hpp"

namespace coilwright::measurement::signals {

/// Draws the levels of one instrument in several runs towards each other as far as they agree.
///
/// A run of twenty pictures tells its noise to a third only: weighed by its own estimate it counts nine times as much
/// as it should, or nothing. `levels` are estimates of the runs' own (sigma and freedom) of the same instrument. Those
/// that lie outside of what chance lets chi-square scatter about the level that all have together stay as they are: 1 %
/// that any of them does, in both tails, because a short run left out would weigh by its own estimate again. For the
/// others the variance is s² = (f0 s0² + f s²)/(f0 + f): s0² is their mean weighed by their freedom, and f0 what is
/// left of the scatter of log s² beyond chance, so that runs that truly differ are drawn less; without any, all have
/// s0². Their freedom is f0 + f, at most that of all together. `pooled` is set where the others tell more than the run
/// itself. Does nothing for fewer than three levels. Source: G. K. Smyth, "Linear models and empirical Bayes methods
/// for assessing differential expression in microarray experiments", Stat. Appl. Genet. Mol. Biol. 3 (2004), article 3,
/// section 6.
void pool_levels(std::span<NoiseLevel* const> levels);

}  // namespace coilwright::measurement::signals
