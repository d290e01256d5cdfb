#include "measurement/identification/local_optima.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "measurement/fit/parallel.hpp"
#include "measurement/identification/model_error.hpp"
#include "measurement/identification/profile_likelihood.hpp"
#include "measurement/identification/search_effort.hpp"
#include "measurement/identification/staged_fit.hpp"

namespace coilwright::measurement::identification {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

// Where a fit began, and where it ended.
struct ScanFit {
  double start{};
  double end{};
  double objective = unbounded;  // infinite where the model cannot be simulated
  Eigen::VectorXd values{};
};

// The search along one number, whose absence is at `absent`.
struct ScanLine {
  std::span<const replay::PreparedRun> runs;
  const FittedHypothesis& fitted;
  Eigen::Index parameter;
  double absent;

  [[nodiscard]] double estimate() const { return fitted.fit.values[parameter]; }
  // So many steps from the estimate, within the bounds.
  [[nodiscard]] double start(int steps) const {
    const fit::FitParameter& number = fitted.hypothesis.parameters()[static_cast<std::size_t>(parameter)];
    const double wanted = absent + (estimate() - absent) * std::pow(1.0 + search_effort.scan_step, steps);
    return std::clamp(wanted, number.lower, number.upper);
  }
  [[nodiscard]] ScanFit tried(double start) const {
    PlannedFit plan{.hypothesis = fitted.hypothesis,
                    .start = fitted.fit.values,
                    .local_numbers_from = &fitted.fit,
                    .derivatives_from = &fitted.fit};
    plan.start[parameter] = start;
    fit::FitRequest request = fit_request_of(runs, plan);
    request.effort = ends_by_what_is_left(search_effort.short_fit, fitted);
    auto ended = fit::fit(request);
    ScanFit out{.start = start};
    if (!ended) return out;
    out.end = ended->values[parameter];
    out.objective = ended->objective();
    out.values = std::move(ended->values);
    return out;
  }
  // A fit that ends nearer to its start than to the estimate is in another local optimum.
  [[nodiscard]] bool stays(const ScanFit& each) const {
    return std::isfinite(each.objective) && std::abs(each.end - each.start) < 0.5 * std::abs(estimate() - each.start);
  }
};

// From starts on both sides of the estimate, in order.
std::vector<ScanFit> tried_on_both_sides(const ScanLine& line) {
  std::vector<double> starts;
  for (int steps = -search_effort.scan_starts; steps <= search_effort.scan_starts; ++steps)
    if (steps != 0) starts.push_back(line.start(steps));
  std::ranges::sort(starts);
  starts.erase(std::unique(starts.begin(), starts.end()), starts.end());
  std::vector<ScanFit> out(starts.size());
  fit::in_parallel(starts.size(), [&](std::size_t i) { out[i] = line.tried(starts[i]); });
  return out;
}

// Standard deviation of the cost from one local optimum to the next, from its second differences along the line: a
// slope is none, and their median is not moved by a few that are far off.
double scatter_of(const std::vector<ScanFit>& line) {
  std::vector<double> bends;
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    const double bend = line[i].objective - 0.5 * (line[i - 1].objective + line[i + 1].objective);
    if (std::isfinite(bend)) bends.push_back(std::abs(bend));
  }
  if (bends.empty()) return 0.0;
  const auto middle = bends.begin() + static_cast<std::ptrdiff_t>(bends.size() / 2);
  std::ranges::nth_element(bends, middle);
  constexpr double deviation_of_median = 1.4826;  // of absolute values of a normal distribution
  return deviation_of_median * *middle / std::sqrt(1.5);
}

// The better optimum that the leading fits end in, if there is one.
std::optional<FittedHypothesis> better_optimum(const ScanLine& line, const std::vector<ScanFit>& fits) {
  std::optional<FittedHypothesis> out;
  std::vector<const ScanFit*> leading;
  for (const ScanFit& each : fits)
    if (std::isfinite(each.objective)) leading.push_back(&each);
  std::ranges::stable_sort(leading, {}, &ScanFit::objective);
  const std::size_t refined_optima = std::min(leading.size(), search_effort.refined_optima);
  for (const ScanFit* each : std::span(leading).first(refined_optima)) {
    auto refined = fit_to_its_end(line.runs,
                                  {.hypothesis = line.fitted.hypothesis,
                                   .start = each->values,
                                   .local_numbers_from = &line.fitted.fit,
                                   .derivatives_from = &line.fitted.fit},
                                  search_effort.converged);
    if (!refined) continue;
    const double best = out ? out->fit.objective() : line.fitted.fit.objective();
    if (refined->fit.objective() < best) out = std::move(refined);
  }
  return out;
}

// Further fits towards the absence of the effect, until a local optimum is worse than `limit`.
std::vector<ScanFit> tried_towards_absent(const ScanLine& line, const std::vector<ScanFit>& fits, double limit) {
  std::vector<ScanFit> out;
  double last = (line.estimate() > line.absent ? fits.front() : fits.back()).objective;
  for (int steps = search_effort.scan_starts; last <= limit && steps < search_effort.farthest_scan;) {
    steps += search_effort.far_scan_steps;
    out.push_back(line.tried(line.start(-steps)));
    last = out.back().objective;
  }
  return out;
}

// The first starts on either side of all local optima that are no worse than `limit`.
LocalOptima::Ends ends_of(const ScanLine& line, const std::vector<ScanFit>& fits, double limit) {
  double lowest = line.estimate();
  double highest = lowest;
  for (const ScanFit& each : fits) {
    if (each.objective > limit) continue;
    lowest = std::min(lowest, each.end);
    highest = std::max(highest, each.end);
  }
  LocalOptima::Ends out{.lower = -unbounded, .upper = unbounded};
  for (const ScanFit& each : fits) {
    if (each.start < lowest) out.lower = std::max(out.lower, each.start);
    if (each.start > highest) out.upper = std::min(out.upper, each.start);
  }
  return out;
}

}  // namespace

bool is_suspiciously_narrow(const Estimate& estimate, double absent) {
  const double near = search_effort.too_narrow * std::abs(estimate.value - absent);
  return estimate.value - estimate.lower < near || estimate.upper - estimate.value < near;
}

LocalOptima local_optima_along(std::span<const replay::PreparedRun> runs, const FittedHypothesis& fitted,
                               Eigen::Index parameter, double absent, double overdispersion) {
  LocalOptima out;
  if (is_far_from_noise(fitted)) return out;
  const ScanLine line{.runs = runs, .fitted = fitted, .parameter = parameter, .absent = absent};
  std::vector<ScanFit> fits = tried_on_both_sides(line);
  const auto staying = std::ranges::count_if(fits, [&](const ScanFit& each) { return line.stays(each); });
  if (2 * staying < std::ssize(fits)) return out;

  auto better = better_optimum(line, fits);
  const double best = better ? better->fit.objective() : fitted.fit.objective();
  if (fitted.fit.objective() - best >= search_effort.better_optimum * overdispersion) out.better = std::move(better);

  constexpr double deviations_of_difference = 2.0 * std::numbers::sqrt2;
  const double limit = best + chi_square_95 * overdispersion + deviations_of_difference * scatter_of(fits);
  std::ranges::move(tried_towards_absent(line, fits, limit), std::back_inserter(fits));
  out.ends = ends_of(line, fits, limit);
  return out;
}

std::optional<FittedHypothesis> OptimaAlongNumbers::look_for(std::span<const replay::PreparedRun> runs,
                                                             const FittedHypothesis& fitted,
                                                             const std::vector<Estimate>& estimates,
                                                             double overdispersion) {
  std::optional<FittedHypothesis> out;
  if (searches_ == search_effort.optima_searches) return out;
  ++searches_;
  for (std::size_t effect = 0; effect < fitted.hypothesis.effects().size(); ++effect) {
    const auto numbers = fitted.hypothesis.effects()[effect].kind->parameters();
    const fit::Hypothesis::EffectParameters& varied = fitted.hypothesis.parameters_of(effect);
    for (std::size_t k = 0; k < varied.numbers.size(); ++k) {
      const Eigen::Index parameter = varied.first + static_cast<Eigen::Index>(k);
      const double absent = numbers[varied.numbers[k]].absent.value_or(0.0);
      if (!are_along(parameter) && !is_suspiciously_narrow(estimates[static_cast<std::size_t>(parameter)], absent))
        continue;
      LocalOptima found = local_optima_along(runs, fitted, parameter, absent, overdispersion);
      if (found.ends) ends_.insert_or_assign(parameter, *found.ends);
      if (!found.better) continue;
      if (!out || found.better->fit.objective() < out->fit.objective()) out = std::move(found.better);
    }
  }
  return out;
}

void OptimaAlongNumbers::set_intervals(std::vector<Estimate>& estimates) const {
  for (const auto& [parameter, ends] : ends_) {
    Estimate& estimate = estimates[static_cast<std::size_t>(parameter)];
    estimate.lower = std::min(estimate.value, ends.lower);
    estimate.upper = std::max(estimate.value, ends.upper);
    estimate.determined = std::isfinite(estimate.lower) || std::isfinite(estimate.upper);
    estimate.has_many_optima = true;
  }
}

}  // namespace coilwright::measurement::identification
