#pragma once

#include <span>

#include "measurement/whiteness/normalised_run.hpp"
#include "measurement/whiteness/worst_test.hpp"

namespace coilwright::measurement::whiteness {

/// Tests the energy at all wavelengths longer than 2, 4, 8, ... samples, of all runs pooled.
void test_pooled_bands(std::span<const NormalisedRun> runs, WorstTest& worst);
/// Tests the same energies of each run alone.
void test_bands_of_each_run(std::span<const NormalisedRun> runs, WorstTest& worst);

}  // namespace coilwright::measurement::whiteness
