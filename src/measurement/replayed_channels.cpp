#include "measurement/replayed_channels.hpp"

#include <span>

namespace coilwright::measurement {
namespace {

using replay::PreparedRun;

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

Channels by_channel(const PreparedRun& prepared, const Eigen::VectorXd& values) {
  const std::size_t channels = prepared.run->channels.size();
  Channels out(channels);
  Eigen::Index at = 0;
  for (const replay::SampleRange& range : prepared.sample_ranges())
    for (std::size_t c = 0; c < channels; ++c)
      for (std::size_t i = 0; i < range.samples(); ++i) out[c].push_back(values[at++]);
  return out;
}

fit::FitRequest request_for(const PreparedRun& prepared, const identification::FittedHypothesis& model) {
  return {.hypothesis = &model.hypothesis, .runs = std::span(&prepared, 1), .start = model.fit.values};
}

std::optional<Channels> shown_of(const PreparedRun& prepared, const identification::FittedHypothesis& model) {
  const auto found = fit::evaluate_at(request_for(prepared, model));
  if (!found) return std::nullopt;
  return by_channel(prepared, found->runs.front().predictions);
}

Replay measured_channel(const PreparedRun& prepared, std::size_t channel, bool validate) {
  const data::Channel& measured = prepared.run->channels[channel];
  Replay out{.run = prepared.run->name,
             .validate = validate,
             .kind = measured.kind,
             .channel = measured.name,
             .at = abscissa(prepared)};
  const auto samples = static_cast<std::ptrdiff_t>(out.at.size());
  out.measured.assign(measured.values.begin(), measured.values.begin() + samples);
  if (channel < prepared.set_aside.size() && !prepared.set_aside[channel].empty())
    out.left_out.assign(prepared.set_aside[channel].begin(), prepared.set_aside[channel].begin() + samples);
  return out;
}

}  // namespace coilwright::measurement
