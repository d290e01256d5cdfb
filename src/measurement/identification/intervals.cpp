#include "measurement/identification/intervals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <utility>

#include "measurement/fit/parallel.hpp"
#include "measurement/identification/curvature.hpp"
#include "measurement/identification/local_optima.hpp"
#include "measurement/identification/profile_likelihood.hpp"
#include "measurement/identification/search_effort.hpp"
#include "measurement/identification/staged_fit.hpp"

namespace coilwright::measurement::identification {
namespace {

// The estimates at one optimum, and the best parameters that a profile reached.
struct IntervalPass {
  std::vector<Estimate> estimates{};
  double best_chi_square{};
  Eigen::VectorXd best_values{};
};

// A number with many local optima has no profile: its interval is what was found along it.
IntervalPass intervals_at_optimum(std::span<const replay::PreparedRun> runs, const FittedHypothesis& fitted,
                                  double overdispersion, const OptimaAlongNumbers& optima,
                                  const std::function<void(const std::string&)>& progress) {
  const Eigen::VectorXd deviations = standard_deviations(fitted, overdispersion);
  IntervalPass out{.estimates = {}, .best_chi_square = fitted.fit.objective(), .best_values = fitted.fit.values};
  for (Eigen::Index i = 0; i < fitted.hypothesis.size(); ++i)
    out.estimates.push_back(local_estimate(fitted.hypothesis.parameters()[static_cast<std::size_t>(i)],
                                           fitted.fit.values[i], deviations[i]));
  const std::size_t calibrated = fitted.hypothesis.declared().calibration.size();
  std::vector<std::size_t> profiled;     // numbers of effects
  std::vector<ProfileLikelihood> sides;  // below and above each of them
  for (std::size_t i = calibrated; i < out.estimates.size(); ++i) {
    if (optima.are_along(static_cast<Eigen::Index>(i))) continue;
    profiled.push_back(i);
    for (int side = 0; side < 2; ++side) sides.emplace_back(runs, fitted, static_cast<Eigen::Index>(i), overdispersion);
  }
  std::mutex reporting;
  std::size_t done = 0;
  fit::in_parallel(sides.size(), [&](std::size_t side) {
    const std::size_t i = profiled[side / 2];
    Estimate& estimate = out.estimates[i];
    const double deviation = deviations[static_cast<Eigen::Index>(i)];
    (side % 2 == 0 ? estimate.lower : estimate.upper) = sides[side].crossing(side % 2 == 0 ? -1.0 : 1.0, deviation);
    const std::scoped_lock lock(reporting);
    if (++done % 2 == 0 && progress) progress(fmt::format("{} of {} ends of intervals known", done, sides.size()));
  });
  for (const ProfileLikelihood& profile : sides) {
    if (profile.best_chi_square() >= out.best_chi_square) continue;
    out.best_chi_square = profile.best_chi_square();
    out.best_values = profile.best_values();
  }
  for (std::size_t i = calibrated; i < out.estimates.size(); ++i)
    out.estimates[i].determined = std::isfinite(out.estimates[i].lower) || std::isfinite(out.estimates[i].upper);
  return out;
}

}  // namespace

FittedHypothesis refitted(std::span<const replay::PreparedRun> runs, FittedHypothesis fitted) {
  if (fitted.hypothesis.effects().empty()) return fitted;
  auto anew = fit_exactly(
      runs, {.hypothesis = fitted.hypothesis, .start = fitted.fit.values, .local_numbers_from = &fitted.fit});
  if (anew && anew->fit.objective() <= fitted.fit.objective() * (1.0 + 1e-6)) return std::move(*anew);
  return fitted;
}

EstimatedHypothesis estimated(std::span<const replay::PreparedRun> runs, FittedHypothesis fitted, double overdispersion,
                              const std::function<void(const std::string&)>& progress) {
  EstimatedHypothesis out{.fitted = std::move(fitted)};
  OptimaAlongNumbers optima;
  for (int moves = 0;; ++moves) {
    IntervalPass pass = intervals_at_optimum(runs, out.fitted, overdispersion, optima, progress);
    const auto beside = optima.look_for(runs, out.fitted, pass.estimates, overdispersion);
    if (beside && beside->fit.objective() < pass.best_chi_square) {
      pass.best_chi_square = beside->fit.objective();
      pass.best_values = beside->fit.values;
    }
    out.estimates = std::move(pass.estimates);
    optima.set_intervals(out.estimates);
    if (moves == search_effort.largest_number_of_moves ||
        out.fitted.fit.objective() - pass.best_chi_square < search_effort.better_optimum * overdispersion)
      return out;
    auto better = fit_exactly(
        runs, {.hypothesis = out.fitted.hypothesis, .start = pass.best_values, .local_numbers_from = &out.fitted.fit});
    if (!better || better->fit.objective() >= out.fitted.fit.objective()) return out;
    out.fitted = std::move(*better);
  }
}

std::vector<Estimate> estimates_of_effect(const FittedHypothesis& fitted, const std::vector<Estimate>& estimates,
                                          std::size_t effect) {
  const actuator::Effect found = fitted.hypothesis.effects_at(fitted.fit.values)[effect];
  const fit::Hypothesis::EffectParameters& parameters = fitted.hypothesis.parameters_of(effect);
  std::vector<Estimate> out;
  for (std::size_t k = 0; k < found.values.size(); ++k) {
    const actuator::EffectParameter& number = found.kind->parameters()[k];
    const auto in_fit = std::ranges::find(parameters.numbers, k);
    if (in_fit != parameters.numbers.end()) {
      out.push_back(estimates[static_cast<std::size_t>(parameters.first + (in_fit - parameters.numbers.begin()))]);
    } else {
      out.push_back({.key = std::string(number.key),
                     .value = found.values[k],
                     .lower = found.values[k],
                     .upper = found.values[k],
                     .chosen = true});
    }
  }
  return out;
}

}  // namespace coilwright::measurement::identification
