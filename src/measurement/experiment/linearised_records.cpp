#include "measurement/experiment/linearised_records.hpp"

#include <Eigen/QR>
#include <stdexcept>
#include <utility>

#include "coilwright/measurement/experiment/synthetic_data.hpp"
#include "measurement/compare/staged_fit.hpp"
#include "measurement/data/usable_runs.hpp"
#include "measurement/fit/outliers.hpp"
#include "measurement/fit/residual_blocks.hpp"
#include "measurement/replay/recorded_noise.hpp"

namespace coilwright::measurement::experiment {

LinearisedRecords::LinearisedRecords(const Experiment& experiment, const replay::DeclaredModel& rig,
                                     std::uint64_t seed) {
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
    replay::give_recorded_noise(prepared_.back(), still, recorded_);
  }
  const compare::PlannedFit plan{.hypothesis = as_declared, .start = as_declared.start()};
  const auto evaluate = [&] {
    auto fitted_locally = fit::evaluate_with_jacobian(compare::fit_request_of(prepared_, plan));
    simulated_runs_ += fitted_locally.simulated_runs;
    if (!fitted_locally.value) throw std::runtime_error("the declared model cannot be simulated in these runs");
    return std::move(*fitted_locally.value);
  };
  fit::Fit at_truth = evaluate();
  // It also takes the noise anew that a run's own record told; residuals over two different noises would differ by
  // more than any effect changes.
  (void)fit::set_outliers_aside(prepared_, at_truth);
  at_truth = evaluate();
  base_ = compare::score(prepared_, as_declared, std::move(at_truth));
}

fit::Counted<std::optional<Eigen::VectorXd>> LinearisedRecords::change_by(const actuator::Effect& effect) const {
  const compare::PlannedFit plan = compare::with_added_effects(*base_, std::span(&effect, 1));
  const fit::FitRequest request = compare::fit_request_of(prepared_, plan);
  fit::ResidualBlocks blocks(request);
  const auto there = blocks.evaluate(request.start, fit::Derivatives::none);
  if (!there.value) return {.value = std::nullopt, .simulated_runs = there.simulated_runs};
  const fit::Fit& base = base_->fit;
  Eigen::VectorXd out = Eigen::VectorXd::Zero(base.stacked_residuals.size());
  Eigen::Index row = 0;
  for (std::size_t b = 0; b < blocks.blocks().size(); ++b) {
    const Eigen::Index rows = blocks.blocks()[b].rows;
    Eigen::VectorXd change = there.value->blocks[b].residuals - base.stacked_residuals.segment(row, rows);
    change -= base.local_bases[b] * (base.local_bases[b].transpose() * change);
    out.segment(row, rows) = change;
    row += rows;
  }
  return {.value = std::move(out), .simulated_runs = there.simulated_runs};
}

Eigen::VectorXd LinearisedRecords::beyond_declared(const Eigen::VectorXd& change) const {
  const fit::Fit& base = base_->fit;
  if (base.jacobian.cols() == 0) return change;
  const Eigen::VectorXd absorbed =
      base.normal_matrix.completeOrthogonalDecomposition().solve(base.jacobian.transpose() * change);
  return change - base.jacobian * absorbed;
}

Eigen::Index LinearisedRecords::numbers_of(const actuator::Effect& effect) const {
  return compare::with_added_effects(*base_, std::span(&effect, 1)).hypothesis.size() - base_->hypothesis.size();
}

}  // namespace coilwright::measurement::experiment
