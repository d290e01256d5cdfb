#include "measurement/final_errors.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>

#include "coilwright/algebra/definite.hpp"
#include "measurement/fit/outliers.hpp"
#include "measurement/record_slips.hpp"
#include "measurement/replay/recorded_noise.hpp"

namespace coilwright::measurement {
namespace {

using compare::FittedHypothesis;
using replay::PreparedRun;

using Channels = std::vector<std::vector<double>>;  // one series per channel

// Values of one model on one run, over the samples that were simulated.
struct RunPrediction {
  Channels values;
  Channels deviations;  // standard deviations due to parameter uncertainty, over the noise; empty if not asked for
};
using CountedPrediction = fit::Counted<std::optional<RunPrediction>>;

Channels by_channel(const PreparedRun& prepared, const Eigen::VectorXd& values) {
  const std::size_t channels = prepared.run->channels.size();
  Channels out(channels);
  Eigen::Index at = 0;
  for (const replay::SampleRange& range : prepared.sample_ranges())
    for (std::size_t c = 0; c < channels; ++c)
      for (std::size_t i = 0; i < range.samples(); ++i) out[c].push_back(values[at++]);
  return out;
}

// Covariance of the fitted parameters. A typical change of each is its prior standard deviation, so that the covariance
// is finite in directions that the data do not determine.
Eigen::MatrixXd parameter_covariance(const FittedHypothesis& model, double overdispersion) {
  const Eigen::VectorXd scales = model.hypothesis.scales();
  Eigen::MatrixXd scaled = scales.asDiagonal() * model.fit.normal_matrix * scales.asDiagonal();
  scaled /= overdispersion;
  scaled.diagonal().array() += 1.0;
  const Eigen::MatrixXd inverse = algebra::inverse_of_definite(scaled);
  return scales.asDiagonal() * inverse * scales.asDiagonal();
}

// Standard deviations of the predictions of one run over its noise, to first order.
Eigen::VectorXd deviations(const PreparedRun& prepared, const fit::Fit& fitted, const Eigen::MatrixXd& covariance) {
  const Eigen::VectorXd all = (fitted.jacobian * covariance).cwiseProduct(fitted.jacobian).rowwise().sum().cwiseSqrt();
  const std::vector<replay::SampleRange> ranges = prepared.sample_ranges();
  Eigen::VectorXd out(prepared.values());
  Eigen::Index at = 0;
  Eigen::Index row = 0;
  for (std::size_t block = 0; block < ranges.size(); ++block) {
    const Eigen::Index n = prepared.values_in(ranges[block]);
    out.segment(at, n) = all.segment(row, n);
    at += n;
    row += fitted.local_bases[block].rows();  // the rows of the prior of its local numbers follow
  }
  return out;
}

fit::FitRequest request_for(const PreparedRun& prepared, const FittedHypothesis& model) {
  return {.hypothesis = &model.hypothesis, .runs = std::span(&prepared, 1), .start = model.fit.values};
}

CountedPrediction predict(const PreparedRun& prepared, const FittedHypothesis& model) {
  const auto found = fit::evaluate_at(request_for(prepared, model));
  if (!found.value) return {.value = std::nullopt, .simulated_runs = found.simulated_runs};
  return {
      .value = RunPrediction{.values = by_channel(prepared, found.value->runs.front().predictions), .deviations = {}},
      .simulated_runs = found.simulated_runs};
}

CountedPrediction predict_with_deviations(const PreparedRun& prepared, const FittedHypothesis& model,
                                          const Eigen::MatrixXd& covariance) {
  const auto found = fit::evaluate_with_jacobian(request_for(prepared, model));
  if (!found.value) return {.value = std::nullopt, .simulated_runs = found.simulated_runs};
  return {.value = RunPrediction{.values = by_channel(prepared, found.value->runs.front().predictions),
                                 .deviations = by_channel(prepared, deviations(prepared, *found.value, covariance))},
          .simulated_runs = found.simulated_runs};
}

// Sums over all channels of one kind.
class ErrorSums {
 public:
  void add(const Replay& replay, const std::vector<double>& deviations, double sigma) {
    const std::array models{&replay.declared, &replay.before, &replay.after, &replay.corrected};
    const auto counts = [&](std::size_t i) { return replay.left_out.empty() || replay.left_out[i] == 0; };
    has_correction_ = !replay.corrected.empty();
    for (std::size_t m = 0; m < models.size() - (has_correction_ ? 0 : 1); ++m) {
      for (std::size_t i = 0; i < replay.measured.size(); ++i) {
        if (!counts(i)) continue;
        const double error = std::abs(replay.measured[i] - (*models[m])[i]);
        absolute_[m] += error;
        square_[m] += error * error;
        largest_[m] = std::max(largest_[m], error);
      }
    }
    for (std::size_t i = 0; i < replay.measured.size(); ++i) {
      if (!counts(i)) continue;
      noise_square_ += sigma * sigma;
      uncertainty_square_ += sigma * sigma * deviations[i] * deviations[i];
      ++samples_;
    }
  }

  [[nodiscard]] ErrorComparison comparison(data::ChannelKind kind) const {
    const auto n = static_cast<double>(samples_);
    const auto errors = [&](std::size_t m) {
      return Errors{.mae = absolute_[m] / n, .rmse = std::sqrt(square_[m] / n), .max = largest_[m]};
    };
    return {.kind = kind,
            .samples = samples_,
            .declared = errors(0),
            .before = errors(1),
            .after = errors(2),
            .corrected = has_correction_ ? std::optional(errors(3)) : std::nullopt,
            .noise_floor_rmse = std::sqrt(noise_square_ / n),
            .uncertainty_rmse = std::sqrt(uncertainty_square_ / n)};
  }

 private:
  std::array<double, 4> absolute_{}, square_{}, largest_{};
  bool has_correction_{};
  double noise_square_{};
  double uncertainty_square_{};
  std::size_t samples_{};
};

// Errors of a bending angle and of a joint angle are one kind of error.
data::ChannelKind error_kind(data::ChannelKind kind) {
  return kind == data::ChannelKind::bending_angle ? data::ChannelKind::joint_angle : kind;
}

std::vector<double> abscissa(const PreparedRun& prepared) {
  const data::Run& run = *prepared.run;
  if (!run.times.empty()) {
    const std::size_t last = prepared.windows.empty() ? run.samples() : prepared.windows.back().range.last;
    return {run.times.begin(), run.times.begin() + static_cast<std::ptrdiff_t>(last)};
  }
  if (!run.angles.empty()) return run.angles;
  std::vector<double> out;
  for (const auto& row : run.inputs) out.push_back(row.front());
  return out;
}

}  // namespace

void FinalErrors::require_fits_model(const data::SealedRuns& runs, const replay::DeclaredModel& declared,
                                     const actuator::Model& nominal) {
  for (const data::Run& run : runs.runs_) (void)replay::prepare_run(run, declared, nominal);
}

void FinalErrors::require_no_slip(const data::SealedRuns& runs, const replay::DeclaredModel& declared) {
  measurement::require_no_slip(runs.runs_, declared);
}

FinalErrors::FinalErrors(const data::SealedRuns& runs, const replay::DeclaredModel& declared, const ThreeModels& models,
                         std::span<const data::Run> still) {
  const actuator::Model nominal = models.before.hypothesis.model_at(models.before.fit.values);
  std::vector<PreparedRun> prepared_runs;
  for (const data::Run& run : runs.runs_) {
    PreparedRun& prepared = prepared_runs.emplace_back(replay::prepare_run(run, declared, nominal));
    replay::give_recorded_noise(prepared, still, {});
    prepared.model_error = models.after.fit.model_error;
    set_outliers_aside(prepared, models.after);
  }
  take(std::move(prepared_runs), models, true);
}

FinalErrors::FinalErrors(std::vector<PreparedRun> runs, const ThreeModels& models) {
  for (PreparedRun& prepared : runs) prepared.model_error = models.after.fit.model_error;
  take(std::move(runs), models, false);
}

// Outliers pull at the run's clock and hum, and hide themselves among what these then leave: after each look they are
// fitted again without whatever is suspected.
void FinalErrors::set_outliers_aside(PreparedRun& prepared, const FittedHypothesis& model) {
  constexpr int most_looks = 4;
  std::vector<PreparedRun> looked_at{prepared};
  for (int look = 0; look < most_looks; ++look) {
    const auto found = fit::evaluate_at(request_for(looked_at.front(), model));
    simulated_runs_ += found.simulated_runs;
    if (!found.value) return;
    const bool any = fit::set_outliers_aside(std::span(&prepared, 1), *found.value);
    if (look > 0 && !any) return;
    auto trimmed = fit::with_suspects_aside(std::span(&prepared, 1), *found.value);
    if (!trimmed) return;
    looked_at = std::move(*trimmed);
  }
}

void FinalErrors::take(std::vector<PreparedRun> prepared_runs, const ThreeModels& models, bool validate) {
  const Eigen::MatrixXd covariance = parameter_covariance(models.after, models.overdispersion);
  std::vector<const FittedHypothesis*> all{&models.declared, &models.before, &models.after};
  if (models.corrected) all.push_back(&*models.corrected);
  std::vector<std::array<CountedPrediction, 4>> predictions(prepared_runs.size());
  tbb::parallel_for(std::size_t{0}, all.size() * prepared_runs.size(), [&](std::size_t task) {
    const PreparedRun& prepared = prepared_runs[task / all.size()];
    const std::size_t m = task % all.size();
    predictions[task / all.size()][m] =
        m == 2 ? predict_with_deviations(prepared, models.after, covariance) : predict(prepared, *all[m]);
  });
  std::vector<data::ChannelKind> order;
  std::vector<ErrorSums> sums;
  for (std::size_t r = 0; r < prepared_runs.size(); ++r) {
    const PreparedRun& prepared = prepared_runs[r];
    for (const CountedPrediction& each : predictions[r]) simulated_runs_ += each.simulated_runs;
    const auto& [as_declared, before, after, corrected] = predictions[r];
    if (!as_declared.value || !before.value || !after.value || (models.corrected && !corrected.value)) {
      warnings_.push_back({.run = prepared.run->name, .text = "one of the models cannot be simulated here; left out"});
      continue;
    }
    const std::vector<double> at = abscissa(prepared);
    for (std::size_t c = 0; c < prepared.run->channels.size(); ++c) {
      const data::Channel& channel = prepared.run->channels[c];
      Replay replay{
          .run = prepared.run->name,
          .validate = validate,
          .kind = channel.kind,
          .channel = channel.name,
          .at = at,
          .measured = {channel.values.begin(), channel.values.begin() + static_cast<std::ptrdiff_t>(at.size())},
          .declared = as_declared.value->values[c],
          .before = before.value->values[c],
          .after = after.value->values[c],
          .corrected = corrected.value ? corrected.value->values[c] : std::vector<double>{}};
      if (c < prepared.set_aside.size() && !prepared.set_aside[c].empty())
        replay.left_out.assign(prepared.set_aside[c].begin(),
                               prepared.set_aside[c].begin() + static_cast<std::ptrdiff_t>(at.size()));
      Outliers outliers{.run = replay.run, .channel = replay.channel, .validate = validate};
      for (std::size_t i = 0; i < replay.left_out.size(); ++i)
        if (replay.left_out[i] != 0) outliers.times.push_back(at[i]);
      if (!outliers.times.empty()) outliers_.push_back(std::move(outliers));
      const data::ChannelKind kind = error_kind(channel.kind);
      auto found = std::ranges::find(order, kind);
      if (found == order.end()) {
        order.push_back(kind);
        sums.emplace_back();
        found = order.end() - 1;
      }
      sums[static_cast<std::size_t>(found - order.begin())].add(replay, after.value->deviations[c],
                                                                prepared.noise[c].sigma);
      replays_.push_back(std::move(replay));
    }
  }
  for (std::size_t i = 0; i < order.size(); ++i) errors_.push_back(sums[i].comparison(order[i]));
}

}  // namespace coilwright::measurement
