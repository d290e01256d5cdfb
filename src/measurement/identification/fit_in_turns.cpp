#include "measurement/identification/fit_in_turns.hpp"

#include <algorithm>
#include <utility>

#include "coilwright/algebra/minimum_norm.hpp"
#include "measurement/identification/search_effort.hpp"

namespace coilwright::measurement::identification {
namespace {

// The step to the least objective, where that is as the derivatives say, and by how much it falls there.
struct PredictedStep {
  Eigen::VectorXd step{};
  double fall{};
};

PredictedStep predicted_step(const fit::Fit& fitted) {
  Eigen::MatrixXd jacobian = fitted.jacobian;
  for (std::size_t i = 0; i < fitted.at_bound.size(); ++i)
    if (fitted.at_bound[i]) jacobian.col(static_cast<Eigen::Index>(i)).setZero();
  const Eigen::VectorXd slope = jacobian.transpose() * fitted.stacked_residuals;
  const Eigen::MatrixXd curvature = jacobian.transpose() * jacobian;
  Eigen::VectorXd step = -algebra::minimum_norm(curvature, slope);
  const double fall = -slope.dot(step);
  return {.step = std::move(step), .fall = fall};
}

}  // namespace

double promised_fall(const fit::Fit& fitted) {
  return predicted_step(fitted).fall;
}

bool has_slow_derivatives(std::span<const replay::PreparedRun> runs, const replay::DeclaredModel& declared) {
  const auto& numbers = declared.calibration;
  if (!std::ranges::all_of(numbers, &replay::CalibrationParameter::calibrated)) return true;
  return std::ranges::any_of(runs, [](const replay::PreparedRun& run) {
    return std::ranges::any_of(run.windows, [&](const replay::Window& window) {
      return run.fits_initial_state(window) || !window.edges.empty() || !window.bend.times.empty() ||
             !window.errors.empty();
    });
  });
}

fit::FitRequest fit_request_of(std::span<const replay::PreparedRun> runs, const PlannedFit& plan) {
  return {.hypothesis = &plan.hypothesis,
          .runs = runs,
          .start = plan.start,
          .local_numbers_from = plan.local_numbers_from,
          .derivatives_from = plan.derivatives_from};
}

FitInTurns::FitInTurns(std::span<const replay::PreparedRun> runs, PlannedFit plan, const fit::FitEffort& effort)
    : runs_(runs), plan_(std::move(plan)), effort_(effort) {}

bool FitInTurns::turn() {
  ++turns_;
  return has_slow_derivatives(runs_, plan_.hypothesis.declared()) ? turn_with_kept_derivatives() : whole_fit();
}

void FitInTurns::finish() {
  while (turn()) {
  }
}

bool FitInTurns::whole_fit() {
  fit::FitRequest request = fit_request_of(runs_, plan_);
  request.effort = effort_;
  auto fitted = fit::fit(request);
  reached_ = std::move(fitted);
  return false;
}

bool FitInTurns::turn_with_kept_derivatives() {
  fit::FitRequest request = fit_request_of(runs_, plan_);
  request.effort = effort_;
  request.updates_derivatives = true;
  const std::optional<fit::Fit> behind_kink = std::exchange(behind_kink_, std::nullopt);
  if (const std::optional<fit::Fit>& from = behind_kink ? behind_kink : reached_) {
    request.start = from->values;
    request.local_numbers_from = request.derivatives_from = &*from;
  }
  const auto fitted = fit::fit(request);
  if (!fitted) return false;
  auto anew = fit::evaluate_with_jacobian({.hypothesis = &plan_.hypothesis,
                                           .runs = runs_,
                                           .start = fitted->values,
                                           .local_numbers_from = &*fitted,
                                           .effort = {.iterations = 0}});
  if (!anew) return false;
  const double notable = effort_.tolerance * anew->objective();
  if (behind_kink && anew->objective() >= reached_->objective()) return false;
  const bool has_stalled = !behind_kink && reached_ && reached_->objective() - anew->objective() <= notable;
  reached_ = std::move(anew);
  const PredictedStep next = predicted_step(*reached_);
  if (next.fall <= notable || turns_ >= search_effort.most_turns) return false;
  return !has_stalled || (next.fall >= search_effort.worth_a_leap && leap(next.step));
}

// False if there is no model.
bool FitInTurns::leap(const Eigen::VectorXd& step) {
  Eigen::VectorXd there = reached_->values + step;
  for (Eigen::Index i = 0; i < there.size(); ++i) {
    const fit::FitParameter& number = plan_.hypothesis.parameters()[static_cast<std::size_t>(i)];
    there[i] = std::clamp(there[i], number.lower, number.upper);
  }
  behind_kink_ = fit::evaluate_with_jacobian({.hypothesis = &plan_.hypothesis,
                                              .runs = runs_,
                                              .start = there,
                                              .local_numbers_from = &*reached_,
                                              .effort = {.iterations = 0}});
  return behind_kink_.has_value();
}

std::optional<FittedHypothesis> FitInTurns::result() && {
  if (!reached_) return std::nullopt;
  return score(runs_, std::move(plan_.hypothesis), std::move(*reached_));
}

}  // namespace coilwright::measurement::identification
