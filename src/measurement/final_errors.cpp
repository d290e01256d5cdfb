#include "measurement/final_errors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "coilwright/algebra/definite.hpp"
#include "measurement/error_sums.hpp"
#include "measurement/fit/input_errors.hpp"
#include "measurement/fit/outliers.hpp"
#include "measurement/fit/parallel.hpp"
#include "measurement/fit/scales.hpp"
#include "measurement/records/record_slips.hpp"
#include "measurement/records/suspect_records.hpp"
#include "measurement/records/worst_starts.hpp"
#include "measurement/replay/input_whitener.hpp"
#include "measurement/replay/recorded_noise.hpp"
#include "measurement/replayed_channels.hpp"

namespace coilwright::measurement {
namespace {

using identification::FittedHypothesis;
using replay::PreparedRun;

// Values of one model on one run, over the samples that were simulated.
struct RunPrediction {
  Channels values;
  Channels deviations;  // standard deviations due to parameter uncertainty; empty if not asked for
};
using Prediction = std::optional<RunPrediction>;

// Covariance of the fitted parameters. A typical change of each is its prior standard deviation, so that the covariance
// is finite in directions that the data do not determine.
Eigen::MatrixXd parameter_covariance(const FittedHypothesis& model, double overdispersion) {
  const Eigen::VectorXd scales = fit::scales_at(model.hypothesis, model.fit.values);
  Eigen::MatrixXd scaled = scales.asDiagonal() * model.fit.normal_matrix * scales.asDiagonal();
  scaled /= overdispersion;
  scaled.diagonal().array() += 1.0;
  const Eigen::MatrixXd inverse = algebra::inverse_of_definite(scaled);
  return scales.asDiagonal() * inverse * scales.asDiagonal();
}

// Standard deviations of the predictions of one run, to first order, from derivatives over the noise of its
// instruments.
Eigen::VectorXd deviations(const PreparedRun& prepared, const fit::Fit& fitted, const Eigen::MatrixXd& covariance) {
  const Eigen::VectorXd all = (fitted.jacobian * covariance).cwiseProduct(fitted.jacobian).rowwise().sum().cwiseSqrt();
  const std::vector<replay::SampleRange> ranges = prepared.sample_ranges();
  Eigen::VectorXd out(prepared.values());
  Eigen::Index at = 0;
  Eigen::Index row = 0;
  for (std::size_t block = 0; block < ranges.size(); ++block) {
    const Eigen::Index n = prepared.values_in(ranges[block]);
    out.segment(at, n) = all.segment(row, n);
    const Eigen::Index samples = n / static_cast<Eigen::Index>(prepared.noise.size());
    for (const signals::NoiseLevel& level : prepared.noise) {
      out.segment(at, samples) *= level.sigma;
      at += samples;
    }
    row += fitted.local_bases[block].rows();  // the rows of the prior of its local numbers follow
  }
  return out;
}

Prediction predict(const PreparedRun& prepared, const FittedHypothesis& model) {
  std::optional<Channels> values = shown_of(prepared, model);
  if (!values) return std::nullopt;
  return RunPrediction{.values = std::move(*values), .deviations = {}};
}

Prediction predict_with_deviations(const PreparedRun& prepared, const FittedHypothesis& model,
                                   const Eigen::MatrixXd& covariance) {
  // How much a reading differs because a number does has nothing to do with the errors of the input.
  PreparedRun exact = prepared;
  for (replay::Window& window : exact.windows) window.input_whitener = nullptr;
  const auto found = fit::evaluate_with_jacobian(request_for(exact, model));
  if (!found) return std::nullopt;
  std::optional<Channels> values = replay::weighs_input_errors(std::span(&prepared, 1))
                                       ? shown_of(prepared, model)
                                       : by_channel(prepared, found->runs.front().predictions);
  if (!values) return std::nullopt;
  return RunPrediction{.values = std::move(*values),
                       .deviations = by_channel(prepared, deviations(prepared, *found, covariance))};
}

// Outliers pull at the run's clock and hum, and hide themselves among what these then leave: as long as some are found,
// the run is fitted again without them, and without whatever is suspected besides. Of the few pictures of a short step
// many may be wrong, and the model is fitted no more: what it lacks is not hidden by leaving more out of a clock.
void set_outliers_of_run_aside(PreparedRun& prepared, const FittedHypothesis& model) {
  constexpr int most_looks = 4;
  constexpr double most_suspects = 0.25;
  PreparedRun looked_at = prepared;
  for (int look = 0; look < most_looks; ++look) {
    const auto found = fit::evaluate_at(request_for(looked_at, model));
    if (!found) return;
    const bool any = fit::set_outliers_aside(std::span(&prepared, 1), *found);
    auto trimmed = fit::with_suspects_aside(std::span(&prepared, 1), *found, most_suspects);
    if (!any && (look > 0 || !trimmed)) return;
    looked_at = trimmed ? std::move(trimmed->front()) : prepared;
  }
}

// What a model that is right leaves of each channel: the noise of its instrument, and what the errors of the input do.
Channels noise_left_in(const PreparedRun& prepared) {
  Eigen::VectorXd out(prepared.values());
  Eigen::Index at = 0;
  for (const replay::SampleRange& range : prepared.sample_ranges()) {
    const replay::InputWhitener* whitener = prepared.input_whitener(range);
    const auto samples = static_cast<Eigen::Index>(range.samples());
    for (std::size_t c = 0; c < prepared.noise.size(); ++c, at += samples) {
      out.segment(at, samples).setConstant(prepared.noise[c].sigma);
      if (whitener == nullptr) continue;
      const auto by_input = whitener->deviations().segment(static_cast<Eigen::Index>(c) * samples, samples);
      out.segment(at, samples) = (out.segment(at, samples).cwiseAbs2() + by_input.cwiseAbs2()).cwiseSqrt();
    }
  }
  return by_channel(prepared, out);
}

// Errors of a bending angle and of a joint angle are one kind of error.
data::ChannelKind error_kind(data::ChannelKind kind) {
  return kind == data::ChannelKind::bending_angle ? data::ChannelKind::joint_angle : kind;
}

}  // namespace

void FinalErrors::require_fits_model(const data::SealedRuns& runs, const replay::DeclaredModel& declared,
                                     const actuator::Model& nominal) {
  for (const data::Run& run : runs.runs_) (void)replay::prepare_run(run, declared, nominal);
}

void FinalErrors::require_no_slip(const data::SealedRuns& runs, const replay::DeclaredModel& declared) {
  records::require_no_slip(runs.runs_, declared);
}

std::vector<data::Warning> FinalErrors::unanswered_runs(const data::SealedRuns& runs,
                                                        const replay::DeclaredModel& declared) {
  return records::unanswered_runs(runs.runs_, declared);
}

std::vector<PreparedRun> FinalErrors::prepared(const data::SealedRuns& runs, const replay::DeclaredModel& declared,
                                               const actuator::Model& nominal, const FittedHypothesis& after,
                                               std::span<const data::Run> still,
                                               const replay::SimulationCount& simulations) {
  std::vector<PreparedRun> out;
  for (const data::Run& run : runs.runs_) {
    PreparedRun& prepared = out.emplace_back(replay::prepare_run(run, declared, nominal));
    replay::give_recorded_noise(prepared, still, {}, nominal);
    prepared.simulations = simulations;
    prepared.model_error = after.fit.model_error;
    const std::span<PreparedRun> alone(&prepared, 1);
    fit::weigh_input_errors(alone, after.hypothesis, after.fit.values, nullptr);
    set_outliers_of_run_aside(prepared, after);
    if (!replay::weighs_input_errors(alone)) continue;
    const auto found = fit::evaluate_at(request_for(prepared, after));
    if (found) fit::weigh_input_errors(alone, after.hypothesis, after.fit.values, &*found);
  }
  return out;
}

FinalErrors::FinalErrors(const data::SealedRuns& runs, const replay::DeclaredModel& declared, const ThreeModels& models,
                         std::span<const data::Run> still, const replay::SimulationCount& simulations) {
  const actuator::Model nominal = models.before.hypothesis.model_at(models.before.fit.values);
  take(prepared(runs, declared, nominal, models.after, still, simulations), models, true);
}

FinalErrors::FinalErrors(std::vector<PreparedRun> runs, const ThreeModels& models) {
  for (PreparedRun& prepared : runs) prepared.model_error = models.after.fit.model_error;
  take(std::move(runs), models, false);
}

// What was left out of each channel.
void FinalErrors::list_outliers(const PreparedRun& prepared, bool validate) {
  for (std::size_t c = 0; c < prepared.set_aside.size(); ++c) {
    Outliers found{.run = prepared.run->name, .channel = prepared.run->channels[c].name, .validate = validate};
    for (std::size_t i = 0; i < prepared.set_aside[c].size(); ++i)
      if (prepared.is_set_aside(c, i)) found.times.push_back(prepared.run->times[i]);
    if (!found.times.empty()) outliers_.push_back(std::move(found));
  }
}

void FinalErrors::take(std::vector<PreparedRun> prepared_runs, const ThreeModels& models, bool validate) {
  const Eigen::MatrixXd covariance = parameter_covariance(models.after, models.overdispersion);
  std::vector<const FittedHypothesis*> all{&models.declared, &models.before, &models.after};
  if (models.corrected) all.push_back(&*models.corrected);
  std::vector<std::array<Prediction, 4>> predictions(prepared_runs.size());
  fit::in_parallel(all.size() * prepared_runs.size(), [&](std::size_t task) {
    const PreparedRun& prepared = prepared_runs[task / all.size()];
    const std::size_t m = task % all.size();
    predictions[task / all.size()][m] =
        m == 2 ? predict_with_deviations(prepared, models.after, covariance) : predict(prepared, *all[m]);
  });
  std::vector<data::ChannelKind> order;
  std::vector<ErrorSums> sums;
  std::vector<std::string> worst;
  for (std::size_t r = 0; r < prepared_runs.size(); ++r) {
    const PreparedRun& prepared = prepared_runs[r];
    list_outliers(prepared, validate);
    const auto& [as_declared, before, after, corrected] = predictions[r];
    if (!as_declared || !before || !after || (models.corrected && !corrected)) {
      warnings_.push_back({.run = prepared.run->name, .text = "one of the models cannot be simulated here; left out"});
      continue;
    }
    if (records::is_worst_at_start(prepared, after->values)) worst.push_back(prepared.run->name);
    const Channels noise = noise_left_in(prepared);
    for (std::size_t c = 0; c < prepared.run->channels.size(); ++c) {
      Replay replay = measured_channel(prepared, c, validate);
      replay.declared = as_declared->values[c];
      replay.before = before->values[c];
      replay.after = after->values[c];
      if (corrected) replay.corrected = corrected->values[c];
      const data::ChannelKind kind = error_kind(replay.kind);
      auto found = std::ranges::find(order, kind);
      if (found == order.end()) {
        order.push_back(kind);
        sums.emplace_back();
        found = order.end() - 1;
      }
      sums[static_cast<std::size_t>(found - order.begin())].add(replay, after->deviations[c], noise[c]);
      replays_.push_back(std::move(replay));
    }
  }
  std::ranges::move(records::worst_starts(worst), std::back_inserter(warnings_));
  for (std::size_t i = 0; i < order.size(); ++i) errors_.push_back(sums[i].comparison(order[i]));
}

}  // namespace coilwright::measurement
