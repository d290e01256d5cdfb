#include "coilwright/measurement/whiteness/whiteness_test.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

#include "measurement/whiteness/band_tests.hpp"
#include "measurement/whiteness/block_tests.hpp"
#include "measurement/whiteness/line_tests.hpp"
#include "measurement/whiteness/normalised_run.hpp"
#include "measurement/whiteness/worst_test.hpp"

namespace coilwright::measurement::whiteness {
namespace {

constexpr std::size_t shortest_tested_run = 4;  // samples

}  // namespace

WhitenessResult whiteness_test(std::span<const ScaledResidual> residuals, int fitted_parameters) {
  validate_residuals(residuals);
  if (fitted_parameters < 0)
    throw std::invalid_argument(fmt::format("fitted_parameters must be >= 0; got {}", fitted_parameters));
  std::vector<NormalisedRun> runs;
  double energy = 0.0;
  double samples = 0.0;
  for (const ScaledResidual& residual : residuals) {
    for (const double value : residual.values) energy += value * value;
    samples += static_cast<double>(residual.values.size());
    if (residual.values.size() >= shortest_tested_run) runs.push_back(normalised(residual));
  }
  WhitenessResult result;
  const double free = samples - fitted_parameters;
  if (samples > 0.0) result.level = std::sqrt(energy / (free >= 1.0 ? free : samples));

  WorstTest worst;
  test_pooled_bands(runs, worst);
  test_bands_of_each_run(runs, worst);
  const std::vector<LineSpectrum> spectra = line_spectra(runs);
  test_lines_of_each_run(spectra, worst);
  test_pooled_lines(spectra, worst);
  test_blocks(runs, worst);
  result.whiteness_ratio = worst.ratio();
  result.where = worst.where();
  return result;
}

}  // namespace coilwright::measurement::whiteness
