#include "measurement/compare/valleys.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "measurement/compare/model_error.hpp"
#include "measurement/compare/profile_likelihood.hpp"
#include "measurement/compare/search_effort.hpp"
#include "measurement/compare/staged_fit.hpp"

namespace coilwright::measurement::compare {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

// Where a fit began, and where it ended.
struct Trial {
  double start{};
  double end{};
  double objective = unbounded;  // infinite where the model cannot be simulated
  Eigen::VectorXd values{};
  long simulated_runs{};
};

// The search along one number, whose absence is at `absent`.
struct Row {
  std::span<const replay::PreparedRun> runs;
  const FittedHypothesis& fitted;
  Eigen::Index parameter;
  double absent;

  [[nodiscard]] double estimate() const { return fitted.fit.values[parameter]; }
  // So many steps from the estimate, within the bounds.
  [[nodiscard]] double start(int steps) const {
    const fit::FitParameter& number = fitted.hypothesis.parameters()[static_cast<std::size_t>(parameter)];
    const double wanted = absent + (estimate() - absent) * std::pow(1.0 + search_effort.valley_step, steps);
    return std::clamp(wanted, number.lower, number.upper);
  }
  [[nodiscard]] Trial tried(double start) const {
    PlannedFit plan{.hypothesis = fitted.hypothesis,
                    .start = fitted.fit.values,
                    .local_numbers_from = &fitted.fit,
                    .derivatives_from = &fitted.fit};
    plan.start[parameter] = start;
    fit::FitRequest request = fit_request_of(runs, plan);
    request.effort = ends_by_what_is_left(search_effort.short_fit, fitted);
    auto ended = fit::fit(request);
    Trial out{.start = start, .simulated_runs = ended.simulated_runs};
    if (!ended.value) return out;
    out.end = ended.value->values[parameter];
    out.objective = ended.value->objective();
    out.values = std::move(ended.value->values);
    return out;
  }
  // A fit that ends nearer to its start than to the estimate is in another valley.
  [[nodiscard]] bool stays(const Trial& trial) const {
    return std::isfinite(trial.objective) &&
           std::abs(trial.end - trial.start) < 0.5 * std::abs(estimate() - trial.start);
  }
};

// From starts on both sides of the estimate, in order.
std::vector<Trial> tried_on_both_sides(const Row& row) {
  std::vector<double> starts;
  for (int steps = -search_effort.valley_starts; steps <= search_effort.valley_starts; ++steps)
    if (steps != 0) starts.push_back(row.start(steps));
  std::ranges::sort(starts);
  starts.erase(std::unique(starts.begin(), starts.end()), starts.end());
  std::vector<Trial> out(starts.size());
  tbb::parallel_for(std::size_t{0}, starts.size(), [&](std::size_t i) { out[i] = row.tried(starts[i]); });
  return out;
}

// Standard deviation of the cost from one valley to the next, from its second differences along the row: a slope is
// none, and their median is not moved by a few that are far off.
double scatter_of(const std::vector<Trial>& row) {
  std::vector<double> bends;
  for (std::size_t i = 1; i + 1 < row.size(); ++i) {
    const double bend = row[i].objective - 0.5 * (row[i - 1].objective + row[i + 1].objective);
    if (std::isfinite(bend)) bends.push_back(std::abs(bend));
  }
  if (bends.empty()) return 0.0;
  const auto middle = bends.begin() + static_cast<std::ptrdiff_t>(bends.size() / 2);
  std::ranges::nth_element(bends, middle);
  constexpr double deviation_of_median = 1.4826;  // of absolute values of a normal distribution
  return deviation_of_median * *middle / std::sqrt(1.5);
}

// The better optimum that the leading trials end in, if there is one; their simulated runs.
fit::Counted<std::optional<FittedHypothesis>> better_optimum(const Row& row, const std::vector<Trial>& trials) {
  fit::Counted<std::optional<FittedHypothesis>> out;
  std::vector<const Trial*> leading;
  for (const Trial& trial : trials)
    if (std::isfinite(trial.objective)) leading.push_back(&trial);
  std::ranges::stable_sort(leading, {}, &Trial::objective);
  const std::size_t refined_valleys = std::min(leading.size(), search_effort.refined_valleys);
  for (const Trial* trial : std::span(leading).first(refined_valleys)) {
    auto refined = fit_to_convergence(row.runs, {.hypothesis = row.fitted.hypothesis,
                                                 .start = trial->values,
                                                 .local_numbers_from = &row.fitted.fit,
                                                 .derivatives_from = &row.fitted.fit});
    out.simulated_runs += refined.simulated_runs;
    if (!refined.value) continue;
    const double best = out.value ? out.value->fit.objective() : row.fitted.fit.objective();
    if (refined.value->fit.objective() < best) out.value = std::move(refined.value);
  }
  return out;
}

// Further trials towards the absence of the effect, until a valley is worse than `limit`.
std::vector<Trial> tried_towards_absent(const Row& row, const std::vector<Trial>& trials, double limit) {
  std::vector<Trial> out;
  double last = (row.estimate() > row.absent ? trials.front() : trials.back()).objective;
  for (int steps = search_effort.valley_starts; last <= limit && steps < search_effort.farthest_valley;) {
    steps += search_effort.far_valley_steps;
    out.push_back(row.tried(row.start(-steps)));
    last = out.back().objective;
  }
  return out;
}

// The first starts on either side of all valleys that are no worse than `limit`.
Valleys::Ends ends_of(const Row& row, const std::vector<Trial>& trials, double limit) {
  double lowest = row.estimate();
  double highest = lowest;
  for (const Trial& trial : trials) {
    if (trial.objective > limit) continue;
    lowest = std::min(lowest, trial.end);
    highest = std::max(highest, trial.end);
  }
  Valleys::Ends out{.lower = -unbounded, .upper = unbounded};
  for (const Trial& trial : trials) {
    if (trial.start < lowest) out.lower = std::max(out.lower, trial.start);
    if (trial.start > highest) out.upper = std::min(out.upper, trial.start);
  }
  return out;
}

}  // namespace

bool is_suspiciously_narrow(const Estimate& estimate, double absent) {
  const double near = search_effort.too_narrow * std::abs(estimate.value - absent);
  return estimate.value - estimate.lower < near || estimate.upper - estimate.value < near;
}

Valleys valleys_along(std::span<const replay::PreparedRun> runs, const FittedHypothesis& fitted, Eigen::Index parameter,
                      double absent, double overdispersion) {
  Valleys out;
  if (is_far_from_noise(fitted)) return out;
  const Row row{.runs = runs, .fitted = fitted, .parameter = parameter, .absent = absent};
  std::vector<Trial> trials = tried_on_both_sides(row);
  for (const Trial& trial : trials) out.simulated_runs += trial.simulated_runs;
  const auto staying = std::ranges::count_if(trials, [&](const Trial& trial) { return row.stays(trial); });
  if (2 * staying < std::ssize(trials)) return out;

  auto better = better_optimum(row, trials);
  out.simulated_runs += better.simulated_runs;
  const double best = better.value ? better.value->fit.objective() : fitted.fit.objective();
  if (fitted.fit.objective() - best >= search_effort.better_optimum * overdispersion)
    out.better = std::move(better.value);

  constexpr double deviations_of_difference = 2.0 * std::numbers::sqrt2;
  const double limit = best + chi_square_95 * overdispersion + deviations_of_difference * scatter_of(trials);
  for (Trial& further : tried_towards_absent(row, trials, limit)) {
    out.simulated_runs += further.simulated_runs;
    trials.push_back(std::move(further));
  }
  out.ends = ends_of(row, trials, limit);
  return out;
}

}  // namespace coilwright::measurement::compare
