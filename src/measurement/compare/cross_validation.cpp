#include "measurement/compare/cross_validation.hpp"

#include <tbb/parallel_for.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "coilwright/algebra/minimum_norm.hpp"
#include "measurement/compare/fit_in_turns.hpp"
#include "measurement/compare/search_effort.hpp"
#include "measurement/fit/part_of_fit.hpp"
#include "measurement/fit/scales.hpp"

namespace coilwright::measurement::compare {
namespace {

// The way from the fit to all runs to the fit without one of them, by the derivatives of the former.
struct StepWithout {
  Eigen::VectorXd values;
  double chi_square{};  // of the run left out, as the derivatives say
  bool is_whole{};      // nothing on the way is too far for them
};

StepWithout step_without(const FittedHypothesis& fitted, std::size_t run) {
  const fit::RunFit& left_out = fitted.fit.runs[run];
  const Eigen::MatrixXd others = fitted.fit.normal_matrix - left_out.normal_matrix;
  const Eigen::VectorXd scales = fit::scales_at(fitted.hypothesis, fitted.fit.values);
  const Eigen::MatrixXd scaled = scales.asDiagonal() * others * scales.asDiagonal();
  // With the gradient g of the run left out and the normal matrix N of the others, the optimum of the others is at
  // +N^-1 g, because at the common optimum all gradients add up to zero.
  const Eigen::VectorXd step = algebra::minimum_norm(scaled, scales.asDiagonal() * left_out.gradient);
  const Eigen::VectorXd shortened = step.cwiseMax(-1.0).cwiseMin(1.0);
  StepWithout out{.values = fitted.hypothesis.clamped(fitted.fit.values + scales.asDiagonal() * shortened),
                  .is_whole = shortened == step};
  const Eigen::VectorXd moved = out.values - fitted.fit.values;
  out.chi_square =
      left_out.residuals.squaredNorm() + moved.dot(2.0 * left_out.gradient + left_out.normal_matrix * moved);
  return out;
}

// Whether the derivatives have told what the step does to the run left out: to half of its rise, or to what noise does.
bool linearisation_holds(const StepWithout& step, const fit::RunFit& at_fit, double chi_square) {
  const double noise = std::sqrt(2.0 * static_cast<double>(at_fit.residuals.size()));
  const double rise = std::max(0.0, step.chi_square - at_fit.residuals.squaredNorm());
  return std::abs(chi_square - step.chi_square) <= 0.5 * rise + noise;
}

// Chi-square of a run at parameters on which it had no influence. One step leads there where the fit hardly depends on
// one run. Where it depends on it, with few runs or numbers that the others hardly tell, the others are fitted.
double held_out_chi_square(std::span<const replay::PreparedRun> runs, const FittedHypothesis& fitted, std::size_t run) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double out = infinity;
  const auto chi_square_at = [&](const Eigen::VectorXd& values) {
    const auto there =
        fit::evaluate_at({.hypothesis = &fitted.hypothesis, .runs = runs.subspan(run, 1), .start = values});
    return there ? there->chi_square : infinity;
  };
  if (fitted.fit.values.size() == 0) {
    out = chi_square_at(fitted.fit.values);
    return out;
  }
  const StepWithout step = step_without(fitted, run);
  out = chi_square_at(step.values);
  if (step.is_whole && linearisation_holds(step, fitted.fit.runs[run], out)) return out;
  const fit::PartOfFit others = fit::part_of(runs, fitted.fit, [&](std::size_t r) { return r != run; });
  FitInTurns refitted(others.runs,
                      {.hypothesis = fitted.hypothesis,
                       .start = fitted.fit.values,
                       .local_numbers_from = &others.fit,
                       .derivatives_from = &others.fit},
                      search_effort.converged);
  refitted.finish();
  if (refitted.reached() != nullptr) out = chi_square_at(refitted.reached()->values);
  return out;
}

// How much of the squared residual of a run the others leave open: what its scatter is expected to be where their fit
// puts the parameters, each within its standard deviation. With the normal matrix M of the run and N of the others it
// is trace(N^-1 M), about the number of parameters over that of the others where all runs tell alike.
double left_open(const FittedHypothesis& fitted, std::size_t run) {
  if (fitted.hypothesis.size() == 0) return 0.0;
  constexpr double untold = 1e-12;  // of the best told direction: keeps the others' matrix regular
  const Eigen::VectorXd scales = fit::scales_at(fitted.hypothesis, fitted.fit.values);
  const Eigen::MatrixXd own = scales.asDiagonal() * fitted.fit.runs[run].normal_matrix * scales.asDiagonal();
  const Eigen::MatrixXd all = scales.asDiagonal() * fitted.fit.normal_matrix * scales.asDiagonal();
  Eigen::MatrixXd others = all - own;
  others.diagonal().array() += untold * std::max(others.diagonal().maxCoeff(), std::numeric_limits<double>::min());
  return others.ldlt().solve(own).trace();
}

// Whether the others tell enough of a run to predict it.
bool predictable_from_others(const FittedHypothesis& without, const FittedHypothesis& with, std::size_t run,
                             double overdispersion) {
  const fit::RunFit& here = with.fit.runs[run];
  const double taken_away = without.fit.runs[run].residuals.squaredNorm() - here.residuals.squaredNorm();
  const double scatter = overdispersion * std::sqrt(2.0 * static_cast<double>(here.residuals.size()));
  return overdispersion * left_open(with, run) <= std::max(taken_away, scatter);
}

}  // namespace

CrossValidation cross_validated(std::span<const replay::PreparedRun> runs, const FittedHypothesis& without,
                                const FittedHypothesis& with, double overdispersion) {
  CrossValidation out;
  if (runs.size() < 2) return out;
  std::vector<std::size_t> counted;
  for (std::size_t r = 0; r < runs.size(); ++r)
    (predictable_from_others(without, with, r, overdispersion) ? counted : out.unpredictable_runs).push_back(r);
  std::vector<double> chi_square_with(counted.size());
  std::vector<double> chi_square_without(counted.size());
  tbb::parallel_for(std::size_t{0}, counted.size(), [&](std::size_t i) {
    chi_square_without[i] = held_out_chi_square(runs, without, counted[i]);
    chi_square_with[i] = held_out_chi_square(runs, with, counted[i]);
  });
  double fall = 0.0;
  double above_noise = 0.0;
  double values = 0.0;
  for (std::size_t i = 0; i < counted.size(); ++i) {
    const auto noise = static_cast<double>(without.fit.runs[counted[i]].residuals.size());
    fall += chi_square_without[i] - chi_square_with[i];
    above_noise += chi_square_without[i] - noise;
    values += noise;
  }
  // Of a model that nearly reaches the noise, what is above it may be less than nothing: its standard deviation is the
  // least that a share can be taken of.
  if (!counted.empty()) out.gain = fall / std::max(above_noise, std::sqrt(2.0 * values));
  return out;
}

}  // namespace coilwright::measurement::compare
