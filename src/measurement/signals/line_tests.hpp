#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "measurement/signals/normalised_run.hpp"
#include "measurement/signals/spectrum.hpp"
#include "measurement/signals/test_limits.hpp"

namespace coilwright::measurement::signals {

/// The frequencies of a long run at which spectral lines are tested. Refers to the run.
struct LineSpectrum {
  const NormalisedRun* run{};
  signals::Periodogram spectrum;  ///< over the noise variance
  std::size_t first{};  ///< first tested index: below one and a half cycles per run the bands are tested instead
  std::size_t last{};   ///< last tested index: near the Nyquist frequency the distribution is another
};

/// The spectra of the long runs.
[[nodiscard]] std::vector<LineSpectrum> line_spectra(std::span<const NormalisedRun> runs);

/// Tests the strongest spectral line of each run.
void test_lines_of_each_run(std::span<const LineSpectrum> spectra, WorstTest& worst);
/// Tests lines of one frequency in several runs: periodograms are added on a grid of frequencies that the longest run
/// resolves.
void test_pooled_lines(std::span<const LineSpectrum> spectra, WorstTest& worst);

}  // namespace coilwright::measurement::signals
