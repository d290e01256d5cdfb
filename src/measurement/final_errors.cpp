#include "final_errors.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

namespace coilwright::measurement {
namespace {

// Values of one model on one run, channel after channel over the samples that were simulated.
struct RunPrediction {
  std::vector<std::vector<double>> channels;
};

// One vector a channel over the run.
RunPrediction by_channel(const Record& record, const Eigen::VectorXd& predictions) {
  const std::size_t channels = record.run->channels.size();
  RunPrediction out{.channels = std::vector<std::vector<double>>(channels)};
  Eigen::Index at = 0;
  for (const Stretch& stretch : record.stretches())
    for (std::size_t c = 0; c < channels; ++c)
      for (std::size_t i = 0; i < stretch.samples(); ++i) out.channels[c].push_back(predictions[at++]);
  return out;
}

std::optional<RunPrediction> predict(const Record& record, const Scored& model) {
  const std::span<const Record> one(&record, 1);
  const auto fitted = evaluate_at({.hypothesis = &model.hypothesis, .records = one, .start = model.fit.values});
  if (!fitted) return std::nullopt;
  return by_channel(record, fitted->runs.front().predictions);
}

// Sums of one quantity over all its channels.
struct Tally {
  std::array<double, 3> absolute{}, square{}, largest{};
  double noise_square{};
  std::size_t samples{};
};

void add(Tally& tally, const Replay& replay, double sigma) {
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
  tally.samples += replay.measured.size();
}

ErrorComparison comparison(Quantity quantity, const Tally& tally) {
  const auto n = static_cast<double>(tally.samples);
  const auto errors = [&](std::size_t m) {
    return Errors{.mae = tally.absolute[m] / n, .rmse = std::sqrt(tally.square[m] / n), .max = tally.largest[m]};
  };
  return {.quantity = quantity,
          .samples = tally.samples,
          .declared = errors(0),
          .before = errors(1),
          .after = errors(2),
          .noise_floor_rmse = std::sqrt(tally.noise_square / n)};
}

// A bending angle and a joint's angle are one kind of error: degrees.
Quantity error_kind(Quantity quantity) {
  return quantity == Quantity::bending_angle ? Quantity::joint_angle : quantity;
}

std::vector<double> abscissa(const Record& record) {
  const Run& run = *record.run;
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

void FinalErrors::check(const SealedRuns& runs, const DeclaredModel& declared, const actuator::Model& nominal) {
  for (const Run& run : runs.runs_) (void)prepare(run, declared, nominal);
}

FinalErrors::FinalErrors(const SealedRuns& runs, const DeclaredModel& declared, const ThreeModels& models) {
  take(runs.runs_, declared, models, true);
}

FinalErrors::FinalErrors(const std::vector<Run>& runs, const DeclaredModel& declared, const ThreeModels& models) {
  take(runs, declared, models, false);
}

void FinalErrors::take(const std::vector<Run>& runs, const DeclaredModel& declared, const ThreeModels& models,
                       bool validate) {
  const actuator::Model nominal = models.before.hypothesis.model_at(models.before.fit.values);
  std::vector<Record> records;
  for (const Run& run : runs) records.push_back(prepare(run, declared, nominal));
  const std::array three{&models.declared, &models.before, &models.after};
  std::vector<std::array<std::optional<RunPrediction>, 3>> predictions(records.size());
  tbb::parallel_for(std::size_t{0}, 3 * records.size(), [&](std::size_t task) {
    predictions[task / 3][task % 3] = predict(records[task / 3], *three[task % 3]);
  });
  std::vector<Quantity> order;
  std::vector<Tally> tallies;
  for (std::size_t r = 0; r < records.size(); ++r) {
    const Record& record = records[r];
    if (!predictions[r][0] || !predictions[r][1] || !predictions[r][2]) {
      warnings_.push_back({.run = record.run->name, .text = "one of the models cannot be simulated here; left out"});
      continue;
    }
    const std::vector<double> at = abscissa(record);
    for (std::size_t c = 0; c < record.run->channels.size(); ++c) {
      const Channel& channel = record.run->channels[c];
      Replay replay{
          .run = record.run->name,
          .validate = validate,
          .quantity = channel.quantity,
          .channel = channel.name,
          .at = at,
          .measured = {channel.values.begin(), channel.values.begin() + static_cast<std::ptrdiff_t>(at.size())},
          .declared = predictions[r][0]->channels[c],
          .before = predictions[r][1]->channels[c],
          .after = predictions[r][2]->channels[c]};
      const Quantity kind = error_kind(channel.quantity);
      auto found = std::ranges::find(order, kind);
      if (found == order.end()) {
        order.push_back(kind);
        tallies.emplace_back();
        found = order.end() - 1;
      }
      add(tallies[static_cast<std::size_t>(found - order.begin())], replay, record.noise[c].sigma);
      replays_.push_back(std::move(replay));
    }
  }
  for (std::size_t i = 0; i < order.size(); ++i) errors_.push_back(comparison(order[i], tallies[i]));
}

}  // namespace coilwright::measurement
