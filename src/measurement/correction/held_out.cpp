#include "measurement/correction/held_out.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "measurement/fit/part_of_fit.hpp"

namespace coilwright::measurement::correction {
namespace {

constexpr std::size_t most_groups = 5;
// From the fit to all runs to that without a group it is not far.
constexpr fit::FitEffort short_effort{.iterations = 2, .tolerance = 1e-2};

}  // namespace

std::vector<double> held_out_squares(std::span<const replay::PreparedRun> runs,
                                     const identification::FittedHypothesis& fitted) {
  std::vector<double> out(runs.size(), std::numeric_limits<double>::infinity());
  const std::size_t groups = std::min(most_groups, runs.size());
  for (std::size_t group = 0; group < groups; ++group) {
    const fit::PartOfFit others = fit::part_of(runs, fitted.fit, [&](std::size_t r) { return r % groups != group; });
    const auto refitted = fit::fit({.hypothesis = &fitted.hypothesis,
                                    .runs = others.runs,
                                    .start = fitted.fit.values,
                                    .local_numbers_from = &others.fit,
                                    .derivatives_from = &others.fit,
                                    .updates_derivatives = true,
                                    .effort = short_effort});
    if (!refitted) continue;
    const fit::PartOfFit left_out = fit::part_of(runs, fitted.fit, [&](std::size_t r) { return r % groups == group; });
    const auto there = fit::evaluate_at({.hypothesis = &fitted.hypothesis,
                                         .runs = left_out.runs,
                                         .start = refitted->values,
                                         .local_numbers_from = &left_out.fit});
    if (!there) continue;
    std::size_t at = 0;
    for (std::size_t r = group; r < runs.size(); r += groups) out[r] = there->runs[at++].residuals.squaredNorm();
  }
  return out;
}

double mean_gain(std::span<const replay::PreparedRun> runs, const std::vector<double>& without,
                 const std::vector<double>& with) {
  double sum = 0.0;
  double motions = 0.0;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    if (!runs[r].is_motion()) continue;
    motions += 1.0;
    if (!std::isfinite(with[r]) || !std::isfinite(without[r])) {
      sum += std::isfinite(with[r]) ? 1.0 : -1.0;
      continue;
    }
    const auto noise = static_cast<double>(runs[r].values() - runs[r].values_set_aside());
    // Less than three standard deviations of the noise's own is no excess.
    const double excess = std::max({without[r] - noise, with[r] - noise, 3.0 * std::sqrt(2.0 * noise)});
    sum += (without[r] - with[r]) / excess;
  }
  return motions > 0.0 ? sum / motions : 0.0;
}

}  // namespace coilwright::measurement::correction
