#include "measurement/final_errors.hpp"

#include <tbb/parallel_for.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

namespace coilwright::measurement {
namespace {

// Values of one model on one run, channel after channel over the samples that were simulated.
using Channels = std::vector<std::vector<double>>;
struct RunPrediction {
  Channels values;
  Channels deviations;  // what the uncertainty of the fitted numbers leaves open, over the noise; empty if not asked
};

// One vector a channel over the run.
Channels by_channel(const replay::Record& record, const Eigen::VectorXd& predictions) {
  const std::size_t channels = record.run->channels.size();
  Channels out(channels);
  Eigen::Index at = 0;
  for (const replay::SampleRange& stretch : record.stretches())
    for (std::size_t c = 0; c < channels; ++c)
      for (std::size_t i = 0; i < stretch.samples(); ++i) out[c].push_back(predictions[at++]);
  return out;
}

// Covariance of the fitted numbers. What the data leave open is open as far as a usual change goes.
Eigen::MatrixXd covariance(const compare::Scored& model, double unit) {
  const Eigen::VectorXd scales = model.hypothesis.scales();
  Eigen::MatrixXd scaled = scales.asDiagonal() * model.fit.normal * scales.asDiagonal();
  scaled /= unit;
  scaled.diagonal().array() += 1.0;
  const Eigen::MatrixXd inverse = scaled.llt().solve(Eigen::MatrixXd::Identity(scaled.rows(), scaled.cols()));
  return scales.asDiagonal() * inverse * scales.asDiagonal();
}

// Standard deviations of the predictions of one record over its noise, to first order.
Eigen::VectorXd deviations(const replay::Record& record, const fit::Fit& fitted, const Eigen::MatrixXd& spread) {
  const Eigen::VectorXd all = (fitted.slopes * spread).cwiseProduct(fitted.slopes).rowwise().sum().cwiseSqrt();
  const Eigen::Index size = fitted.runs.front().residuals.size();
  const std::vector<replay::SampleRange> stretches = record.stretches();
  // The pull of a window's start stands behind its residuals.
  const Eigen::Index pulls = (all.size() - size) / static_cast<Eigen::Index>(stretches.size());
  Eigen::VectorXd out(size);
  Eigen::Index at = 0;
  Eigen::Index row = 0;
  for (const replay::SampleRange& stretch : stretches) {
    const auto n = static_cast<Eigen::Index>(stretch.samples() * record.run->channels.size());
    out.segment(at, n) = all.segment(row, n);
    at += n;
    row += n + pulls;
  }
  return out;
}

std::optional<RunPrediction> predict(const replay::Record& record, const compare::Scored& model) {
  const auto fitted =
      fit::evaluate_at({.hypothesis = &model.hypothesis, .records = std::span(&record, 1), .start = model.fit.values});
  if (!fitted) return std::nullopt;
  return RunPrediction{.values = by_channel(record, fitted->runs.front().predictions), .deviations = {}};
}

std::optional<RunPrediction> predict_with_spread(const replay::Record& record, const compare::Scored& model,
                                                 const Eigen::MatrixXd& spread) {
  const auto fitted = fit::evaluate_with_slopes(
      {.hypothesis = &model.hypothesis, .records = std::span(&record, 1), .start = model.fit.values});
  if (!fitted) return std::nullopt;
  return RunPrediction{.values = by_channel(record, fitted->runs.front().predictions),
                       .deviations = by_channel(record, deviations(record, *fitted, spread))};
}

// Sums of one quantity over all its channels.
struct Tally {
  std::array<double, 3> absolute{}, square{}, largest{};
  double noise_square{};
  double open_square{};
  std::size_t samples{};
};

void add(Tally& tally, const Replay& replay, const std::vector<double>& deviations, double sigma) {
  const std::array models{&replay.declared, &replay.before, &replay.after};
  for (std::size_t m = 0; m < models.size(); ++m) {
    for (std::size_t i = 0; i < replay.measured.size(); ++i) {
      const double error = std::abs(replay.measured[i] - (*models[m])[i]);
      tally.absolute[m] += error;
      tally.square[m] += error * error;
      tally.largest[m] = std::max(tally.largest[m], error);
    }
  }
  tally.noise_square += sigma * sigma * static_cast<double>(replay.measured.size());
  for (const double deviation : deviations) tally.open_square += sigma * sigma * deviation * deviation;
  tally.samples += replay.measured.size();
}

ErrorComparison comparison(data::Quantity quantity, const Tally& tally) {
  const auto n = static_cast<double>(tally.samples);
  const auto errors = [&](std::size_t m) {
    return Errors{.mae = tally.absolute[m] / n, .rmse = std::sqrt(tally.square[m] / n), .max = tally.largest[m]};
  };
  return {.quantity = quantity,
          .samples = tally.samples,
          .declared = errors(0),
          .before = errors(1),
          .after = errors(2),
          .noise_floor_rmse = std::sqrt(tally.noise_square / n),
          .uncertainty_rmse = std::sqrt(tally.open_square / n)};
}

// A bending angle and a joint's angle are one kind of error: degrees.
data::Quantity error_kind(data::Quantity quantity) {
  return quantity == data::Quantity::bending_angle ? data::Quantity::joint_angle : quantity;
}

std::vector<double> abscissa(const replay::Record& record) {
  const data::Run& run = *record.run;
  if (!run.times.empty()) {
    const std::size_t last = record.windows.empty() ? run.samples() : record.windows.back().last;
    return {run.times.begin(), run.times.begin() + static_cast<std::ptrdiff_t>(last)};
  }
  if (!run.angles.empty()) return run.angles;
  std::vector<double> out;
  for (const auto& row : run.inputs) out.push_back(row.front());
  return out;
}

}  // namespace

void FinalErrors::check(const data::SealedRuns& runs, const replay::DeclaredModel& declared,
                        const actuator::Model& nominal) {
  for (const data::Run& run : runs.runs_) (void)replay::prepare(run, declared, nominal);
}

FinalErrors::FinalErrors(const data::SealedRuns& runs, const replay::DeclaredModel& declared,
                         const ThreeModels& models) {
  take(runs.runs_, declared, models, true);
}

FinalErrors::FinalErrors(const std::vector<data::Run>& runs, const replay::DeclaredModel& declared,
                         const ThreeModels& models) {
  take(runs, declared, models, false);
}

void FinalErrors::take(const std::vector<data::Run>& runs, const replay::DeclaredModel& declared,
                       const ThreeModels& models, bool validate) {
  const actuator::Model nominal = models.before.hypothesis.model_at(models.before.fit.values);
  std::vector<replay::Record> records;
  for (const data::Run& run : runs) records.push_back(replay::prepare(run, declared, nominal));
  const Eigen::MatrixXd spread = covariance(models.after, models.unit);
  const std::array three{&models.declared, &models.before, &models.after};
  std::vector<std::array<std::optional<RunPrediction>, 3>> predictions(records.size());
  tbb::parallel_for(std::size_t{0}, 3 * records.size(), [&](std::size_t task) {
    const replay::Record& record = records[task / 3];
    const std::size_t m = task % 3;
    predictions[task / 3][m] = m == 2 ? predict_with_spread(record, models.after, spread) : predict(record, *three[m]);
  });
  std::vector<data::Quantity> order;
  std::vector<Tally> tallies;
  for (std::size_t r = 0; r < records.size(); ++r) {
    const replay::Record& record = records[r];
    if (!predictions[r][0] || !predictions[r][1] || !predictions[r][2]) {
      warnings_.push_back({.run = record.run->name, .text = "one of the models cannot be simulated here; left out"});
      continue;
    }
    const std::vector<double> at = abscissa(record);
    for (std::size_t c = 0; c < record.run->channels.size(); ++c) {
      const data::Channel& channel = record.run->channels[c];
      Replay replay{
          .run = record.run->name,
          .validate = validate,
          .quantity = channel.quantity,
          .channel = channel.name,
          .at = at,
          .measured = {channel.values.begin(), channel.values.begin() + static_cast<std::ptrdiff_t>(at.size())},
          .declared = predictions[r][0]->values[c],
          .before = predictions[r][1]->values[c],
          .after = predictions[r][2]->values[c]};
      const data::Quantity kind = error_kind(channel.quantity);
      auto found = std::ranges::find(order, kind);
      if (found == order.end()) {
        order.push_back(kind);
        tallies.emplace_back();
        found = order.end() - 1;
      }
      add(tallies[static_cast<std::size_t>(found - order.begin())], replay, predictions[r][2]->deviations[c],
          record.noise[c].sigma);
      replays_.push_back(std::move(replay));
    }
  }
  for (std::size_t i = 0; i < order.size(); ++i) errors_.push_back(comparison(order[i], tallies[i]));
}

}  // namespace coilwright::measurement
