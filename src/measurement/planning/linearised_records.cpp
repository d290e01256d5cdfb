#include "measurement/planning/linearised_records.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "coilwright/algebra/minimum_norm.hpp"
#include "coilwright/measurement/planning/synthetic_data.hpp"
#include "measurement/data/usable_runs.hpp"
#include "measurement/fit/input_errors.hpp"
#include "measurement/fit/outliers.hpp"
#include "measurement/identification/staged_fit.hpp"
#include "measurement/replay/recorded_noise.hpp"

namespace coilwright::measurement::planning {

LinearisedRecords::LinearisedRecords(const Experiment& experiment, const replay::DeclaredModel& rig, std::uint64_t seed,
                                     replay::SimulationCount simulations) {
  const fit::Hypothesis as_declared(rig, {});
  const actuator::Model nominal = as_declared.model_at(as_declared.start());
  for (const PlannedRun& planned : experiment.runs) replay::require_fits_model(planned.plan, rig, nominal);
  std::vector<data::Run> recorded = simulate_experiment(experiment, rig, {}, seed);
  std::vector<data::Run> still;
  std::vector<data::Run> fitted;
  for (std::size_t i = 0; i < recorded.size(); ++i) {
    if (recorded[i].kind == data::RunKind::still)
      still.push_back(std::move(recorded[i]));
    else if (!experiment.runs[i].validate)
      fitted.push_back(std::move(recorded[i]));
  }
  if (fitted.empty()) throw std::invalid_argument("must have a run of role fit that is not still; got none");
  recorded_ = data::usable_runs(fitted).runs;
  for (const data::Run& run : recorded_) {
    prepared_.push_back(replay::prepare_run(run, rig, nominal));
    replay::give_recorded_noise(prepared_.back(), still, recorded_, nominal);
    prepared_.back().simulations = simulations;
  }
  fit::weigh_input_errors(prepared_, as_declared, as_declared.start(), nullptr);
  const identification::PlannedFit plan{.hypothesis = as_declared, .start = as_declared.start()};
  const auto evaluate = [&] {
    auto fitted_locally = fit::evaluate_with_jacobian(identification::fit_request_of(prepared_, plan));
    if (!fitted_locally) throw std::runtime_error("the declared model cannot be simulated in these runs");
    return std::move(*fitted_locally);
  };
  fit::Fit at_truth = evaluate();
  std::vector<Eigen::VectorXd> shown;
  for (const fit::RunFit& each : at_truth.runs) shown.push_back(each.predictions);
  if (replay::give_recorded_noise(prepared_, still, recorded_, nominal, shown)) at_truth = evaluate();
  // It also takes the noise anew that a run's own record told; residuals over two different noises would differ by
  // more than any effect changes.
  (void)fit::set_outliers_aside(prepared_, at_truth);
  fit::weigh_input_errors(prepared_, as_declared, at_truth.values, &at_truth);
  at_truth = evaluate();
  base_ = identification::score(prepared_, as_declared, std::move(at_truth));
}

std::optional<Eigen::VectorXd> LinearisedRecords::change_by(const actuator::Effect& effect) const {
  const identification::PlannedFit plan = identification::with_added_effects(*base_, std::span(&effect, 1));
  const fit::FitRequest request = identification::fit_request_of(prepared_, plan);
  fit::ResidualBlocks blocks(request);
  const auto there = blocks.evaluate(request.start, fit::Derivatives::none);
  if (!there) return std::nullopt;
  return projected_change(*there);
}

Eigen::VectorXd LinearisedRecords::projected_change(const fit::ResidualValues& there) const {
  const fit::Fit& base = base_->fit;
  Eigen::VectorXd out = Eigen::VectorXd::Zero(base.stacked_residuals.size());
  Eigen::Index row = 0;
  for (std::size_t b = 0; b < there.blocks.size(); ++b) {
    const Eigen::Index rows = there.blocks[b].residuals.size();
    Eigen::VectorXd change = there.blocks[b].residuals - base.stacked_residuals.segment(row, rows);
    change -= base.local_bases[b] * (base.local_bases[b].transpose() * change);
    out.segment(row, rows) = change;
    row += rows;
  }
  return out;
}

Eigen::VectorXd LinearisedRecords::beyond_declared(const Eigen::VectorXd& change) const {
  const fit::Fit& base = base_->fit;
  if (base.jacobian.cols() == 0) return change;
  const Eigen::VectorXd absorbed = algebra::minimum_norm(base.normal_matrix, base.jacobian.transpose() * change);
  return change - base.jacobian * absorbed;
}

double LinearisedRecords::length_after_refit(const Eigen::VectorXd& change) const {
  constexpr int most_steps = 12;
  constexpr double shortest_step = 0.05;
  constexpr double notable = 0.01;  // fall of the length
  const fit::Fit& base = base_->fit;
  double out = change.norm();
  if (base.jacobian.cols() == 0) return out;
  const identification::PlannedFit plan{
      .hypothesis = base_->hypothesis, .start = base.values, .local_numbers_from = &base};
  const fit::FitRequest request = identification::fit_request_of(prepared_, plan);
  fit::ResidualBlocks blocks(request);
  const Eigen::VectorXd scales = base_->hypothesis.scales();
  // Derivatives by numbers over their typical changes; each step corrects them along itself (Broyden).
  Eigen::MatrixXd jacobian = base.jacobian * scales.asDiagonal();
  Eigen::VectorXd values = base.values;
  // Records with the effect less those of the model without it: at the declared numbers minus the change.
  Eigen::VectorXd left = -change;
  double share = 1.0;
  for (int step = 0; step < most_steps && share >= shortest_step; ++step) {
    const Eigen::VectorXd direction =
        algebra::minimum_norm(jacobian.transpose() * jacobian, jacobian.transpose() * left);
    const Eigen::VectorXd moved = base_->hypothesis.clamped(values - share * scales.cwiseProduct(direction));
    const auto there = blocks.evaluate(moved, fit::Derivatives::none);
    if (!there) {
      share *= 0.3;
      continue;
    }
    Eigen::VectorXd left_there = projected_change(*there) - change;
    const Eigen::VectorXd prior = base_->hypothesis.prior_residuals(moved);
    left_there.tail(prior.size()) = prior - base.stacked_residuals.tail(prior.size());
    const Eigen::VectorXd way = (moved - values).cwiseQuotient(scales);
    if (way.squaredNorm() == 0.0) break;
    jacobian += (left_there - left - jacobian * way) * way.transpose() / way.squaredNorm();
    if (left_there.norm() >= out) {
      share *= 0.5;
      continue;
    }
    const bool is_end = left_there.norm() > (1.0 - notable) * out;
    out = left_there.norm();
    left = std::move(left_there);
    values = moved;
    share = std::min(1.0, 2.0 * share);
    if (is_end) break;
  }
  return out;
}

Eigen::Index LinearisedRecords::numbers_of(const actuator::Effect& effect) const {
  return identification::with_added_effects(*base_, std::span(&effect, 1)).hypothesis.size() - base_->hypothesis.size();
}

}  // namespace coilwright::measurement::planning
