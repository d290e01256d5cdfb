#include "measurement/compare/intervals.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>
#include <utility>

#include "coilwright/algebra/spectral.hpp"
#include "measurement/compare/profile_likelihood.hpp"
#include "measurement/compare/search_effort.hpp"
#include "measurement/compare/staged_fit.hpp"
#include "measurement/compare/valleys.hpp"

namespace coilwright::measurement::compare {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// The square of Birge's ratio of the declared numbers: 1 as long as chance can have moved them together as far as they
// are.
double squared_birge_ratio(const FittedHypothesis& fitted) {
  if (probability_of_declared_numbers(fitted) >= decision_thresholds.least_probability) return 1.0;
  const auto count = std::ranges::count_if(fitted.hypothesis.parameters(), &fit::FitParameter::has_prior);
  return std::max(1.0, fitted.fit.prior_chi_square / static_cast<double>(count));
}

// What data and priors say together of the numbers. Where some are off by far more than their tolerances, nobody knows
// that of the others to be better: all tolerances are taken larger by Birge's ratio.
Eigen::MatrixXd information(const FittedHypothesis& fitted) {
  const fit::Fit& there = fitted.fit;
  const double squared_ratio = squared_birge_ratio(fitted);
  if (squared_ratio == 1.0) return there.normal_matrix;
  const Eigen::MatrixXd prior = fitted.hypothesis.prior_jacobian(there.values, there.model_error);
  return there.normal_matrix - (1.0 - 1.0 / squared_ratio) * prior.transpose() * prior;
}

// Standard deviations from the curvature at the optimum; infinite for parameters that the data do not determine.
Eigen::VectorXd standard_deviations(const FittedHypothesis& fitted, double overdispersion) {
  const Eigen::Index p = fitted.hypothesis.size();
  const Eigen::VectorXd scales = fitted.hypothesis.scales();
  const Eigen::MatrixXd scaled = scales.asDiagonal() * information(fitted) * scales.asDiagonal();
  Eigen::VectorXd out = Eigen::VectorXd::Constant(p, infinity);
  if (p == 0) return out;
  // A direction that the data do not determine leaves only those parameters undetermined that contribute to it.
  constexpr double undetermined = 1e-12;  // fraction of the largest eigenvalue
  constexpr double contribution = 1e-6;   // squared component of a parameter
  const algebra::SymmetricModes modes = algebra::symmetric_modes(scaled);
  const double least = undetermined * modes.values.maxCoeff();
  for (Eigen::Index i = 0; i < p; ++i) {
    double variance = 0.0;
    double hidden = 0.0;
    for (Eigen::Index k = 0; k < p; ++k) {
      const double share = modes.vectors(i, k) * modes.vectors(i, k);
      if (modes.values[k] > least)
        variance += share / modes.values[k];
      else
        hidden += share;
    }
    if (hidden <= contribution && variance > 0.0) out[i] = scales[i] * std::sqrt(overdispersion * variance);
  }
  return out;
}

Estimate local_estimate(const fit::FitParameter& parameter, double value, double deviation) {
  Estimate out{.key = parameter.key, .value = value};
  out.lower = value - normal_95 * deviation;
  out.upper = value + normal_95 * deviation;
  if (out.lower < parameter.lower) out.lower = -infinity;
  if (out.upper > parameter.upper) out.upper = infinity;
  out.determined = std::isfinite(out.lower) || std::isfinite(out.upper);
  return out;
}

// The estimates at one optimum, and the best parameters that a profile reached.
struct IntervalPass {
  std::vector<Estimate> estimates{};
  double best_chi_square{};
  Eigen::VectorXd best_values{};
  long simulated_runs{};
};

// What was found along the numbers of effects whose intervals are those of one valley among many.
class OtherValleys {
 public:
  // `fitted` and `pass` belong together; the pass takes a better optimum that was seen.
  void look_for(std::span<const replay::PreparedRun> runs, const FittedHypothesis& fitted, IntervalPass& pass,
                double overdispersion) {
    if (searches_ == search_effort.valley_searches) return;
    ++searches_;
    for (std::size_t effect = 0; effect < fitted.hypothesis.effects().size(); ++effect) {
      const auto numbers = fitted.hypothesis.effects()[effect].kind->parameters();
      const fit::Hypothesis::EffectParameters& varied = fitted.hypothesis.parameters_of(effect);
      for (std::size_t k = 0; k < varied.numbers.size(); ++k) {
        const Eigen::Index parameter = varied.first + static_cast<Eigen::Index>(k);
        const double absent = numbers[varied.numbers[k]].absent.value_or(0.0);
        if (!are_along(parameter) &&
            !is_suspiciously_narrow(pass.estimates[static_cast<std::size_t>(parameter)], absent))
          continue;
        const Valleys found = valleys_along(runs, fitted, parameter, absent, overdispersion);
        pass.simulated_runs += found.simulated_runs;
        if (found.ends) ends_.insert_or_assign(parameter, *found.ends);
        if (!found.better || found.better->fit.objective() >= pass.best_chi_square) continue;
        pass.best_chi_square = found.better->fit.objective();
        pass.best_values = found.better->fit.values;
      }
    }
  }

  // Whether the number has many, as far as was looked.
  [[nodiscard]] bool are_along(Eigen::Index parameter) const { return ends_.contains(parameter); }

  void set_intervals(std::vector<Estimate>& estimates) const {
    for (const auto& [parameter, ends] : ends_) {
      Estimate& estimate = estimates[static_cast<std::size_t>(parameter)];
      estimate.lower = std::min(estimate.value, ends.lower);
      estimate.upper = std::max(estimate.value, ends.upper);
      estimate.determined = std::isfinite(estimate.lower) || std::isfinite(estimate.upper);
      estimate.has_many_optima = true;
    }
  }

 private:
  int searches_ = 0;
  std::map<Eigen::Index, Valleys::Ends> ends_{};
};

// A number with many valleys has no profile: its interval is what was found along it.
IntervalPass intervals_at_optimum(std::span<const replay::PreparedRun> runs, const FittedHypothesis& fitted,
                                  double overdispersion, const OtherValleys& valleys,
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
    if (valleys.are_along(static_cast<Eigen::Index>(i))) continue;
    profiled.push_back(i);
    for (int side = 0; side < 2; ++side) sides.emplace_back(runs, fitted, static_cast<Eigen::Index>(i), overdispersion);
  }
  std::mutex reporting;
  std::size_t done = 0;
  tbb::parallel_for(std::size_t{0}, sides.size(), [&](std::size_t side) {
    const std::size_t i = profiled[side / 2];
    Estimate& estimate = out.estimates[i];
    const double deviation = deviations[static_cast<Eigen::Index>(i)];
    (side % 2 == 0 ? estimate.lower : estimate.upper) = sides[side].crossing(side % 2 == 0 ? -1.0 : 1.0, deviation);
    const std::scoped_lock lock(reporting);
    if (++done % 2 == 0 && progress) progress(fmt::format("{} of {} ends of intervals known", done, sides.size()));
  });
  for (const ProfileLikelihood& profile : sides) {
    out.simulated_runs += profile.simulated_runs();
    if (profile.best_chi_square() >= out.best_chi_square) continue;
    out.best_chi_square = profile.best_chi_square();
    out.best_values = profile.best_values();
  }
  for (std::size_t i = calibrated; i < out.estimates.size(); ++i)
    out.estimates[i].determined = std::isfinite(out.estimates[i].lower) || std::isfinite(out.estimates[i].upper);
  return out;
}

}  // namespace

fit::Counted<FittedHypothesis> refitted(std::span<const replay::PreparedRun> runs, FittedHypothesis fitted) {
  fit::Counted<FittedHypothesis> out{.value = std::move(fitted)};
  if (out.value.hypothesis.effects().empty()) return out;
  auto anew = fit_exactly(
      runs, {.hypothesis = out.value.hypothesis, .start = out.value.fit.values, .local_numbers_from = &out.value.fit});
  out.simulated_runs = anew.simulated_runs;
  if (anew.value && anew.value->fit.objective() <= out.value.fit.objective() * (1.0 + 1e-6))
    out.value = std::move(*anew.value);
  return out;
}

EstimatedHypothesis estimated(std::span<const replay::PreparedRun> runs, FittedHypothesis fitted, double overdispersion,
                              const std::function<void(const std::string&)>& progress) {
  EstimatedHypothesis out{.fitted = std::move(fitted)};
  OtherValleys valleys;
  for (int moves = 0;; ++moves) {
    IntervalPass pass = intervals_at_optimum(runs, out.fitted, overdispersion, valleys, progress);
    valleys.look_for(runs, out.fitted, pass, overdispersion);
    out.simulated_runs += pass.simulated_runs;
    out.estimates = std::move(pass.estimates);
    valleys.set_intervals(out.estimates);
    if (moves == search_effort.largest_number_of_moves ||
        out.fitted.fit.objective() - pass.best_chi_square < search_effort.better_optimum * overdispersion)
      return out;
    auto better = fit_exactly(
        runs, {.hypothesis = out.fitted.hypothesis, .start = pass.best_values, .local_numbers_from = &out.fitted.fit});
    out.simulated_runs += better.simulated_runs;
    if (!better.value || better.value->fit.objective() >= out.fitted.fit.objective()) return out;
    out.fitted = std::move(*better.value);
  }
}

void widen_by_rivals(std::vector<Estimate>& estimates, std::span<const FittedHypothesis> rivals,
                     double overdispersion) {
  for (const FittedHypothesis& rival : rivals) {
    const Eigen::VectorXd deviations = standard_deviations(rival, overdispersion);
    for (std::size_t i = 0; i < rival.hypothesis.declared().calibration.size(); ++i) {
      const auto number = static_cast<Eigen::Index>(i);
      const Estimate there =
          local_estimate(rival.hypothesis.parameters()[i], rival.fit.values[number], deviations[number]);
      Estimate& estimate = estimates[i];
      estimate.lower = std::min(estimate.lower, there.lower);
      estimate.upper = std::max(estimate.upper, there.upper);
      estimate.determined = std::isfinite(estimate.lower) || std::isfinite(estimate.upper);
    }
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

bool excludes_absent(const FittedHypothesis& fitted, const std::vector<Estimate>& of_effect, std::size_t effect) {
  const auto numbers = fitted.hypothesis.effects()[effect].kind->parameters();
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    if (!numbers[k].absent) continue;
    const double absent = *numbers[k].absent;
    if (of_effect[k].lower <= absent && absent <= of_effect[k].upper) return false;
  }
  return true;
}

}  // namespace coilwright::measurement::compare
