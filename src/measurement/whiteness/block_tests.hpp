#pragma once

#include <span>

#include "measurement/whiteness/normalised_run.hpp"
#include "measurement/whiteness/worst_test.hpp"

namespace coilwright::measurement::whiteness {

/// Tests the means of blocks of 8, 16, ... samples of each long run. A short event (an impact, a stick) disappears in
/// sums over a run, but not in a mean over its own length.
void test_blocks(std::span<const NormalisedRun> runs, WorstTest& worst);

}  // namespace coilwright::measurement::whiteness
