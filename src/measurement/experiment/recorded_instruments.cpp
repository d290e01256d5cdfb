#include "measurement/experiment/recorded_instruments.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "measurement/replay/prediction.hpp"

namespace coilwright::measurement::experiment {
namespace {

using replay::PreparedRun;

// Sum of the squared distances of the bands from a spectrum whose level is free, each with its number of coefficients.
template <class Density>
double distance(const std::vector<noise::NoiseColour::Band>& bands, const Density& density) {
  double weights = 0.0;
  double sum = 0.0;
  double squares = 0.0;
  for (const noise::NoiseColour::Band& band : bands) {
    if (band.density <= 0.0 || band.to <= 0.0) continue;
    const double apart = std::log(band.density / density(0.5 * (band.from + band.to)));
    weights += band.freedom;
    sum += band.freedom * apart;
    squares += band.freedom * apart * apart;
  }
  return weights > 0.0 ? squares - sum * sum / weights : 0.0;
}

struct Median {
  std::vector<double> values{};
  [[nodiscard]] double value() {
    if (values.empty()) return 0.0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  }
};

// Which instrument measures a channel.
Instrument Instruments::*instrument_of(data::ChannelKind kind) {
  switch (kind) {
    case data::ChannelKind::bending_angle:
    case data::ChannelKind::joint_angle:
      break;
    case data::ChannelKind::joint_rate:
      return &Instruments::rate;
    case data::ChannelKind::torque:
      return &Instruments::torque;
    case data::ChannelKind::force:
      return &Instruments::force;
    case data::ChannelKind::temperature:
      return &Instruments::temperature;
  }
  return &Instruments::angle;
}

// How far the samples of one channel that were set aside lie from the model.
std::vector<double> sizes_of_outliers(const PreparedRun& prepared, const fit::RunFit& fitted, std::size_t channel) {
  std::vector<double> out;
  if (channel >= prepared.set_aside.size() || prepared.set_aside[channel].empty()) return out;
  const auto channels = static_cast<Eigen::Index>(prepared.run->channels.size());
  Eigen::Index at = 0;
  for (const replay::SampleRange& range : prepared.sample_ranges()) {
    const auto n = static_cast<Eigen::Index>(range.samples());
    const Eigen::VectorXd measured = replay::measured_values(*prepared.run, range);
    for (Eigen::Index i = 0; i < n; ++i) {
      const Eigen::Index row = static_cast<Eigen::Index>(channel) * n + i;
      if (prepared.is_set_aside(channel, range.first + static_cast<std::size_t>(i)))
        out.push_back(std::abs(measured[row] - fitted.predictions[at + row]));
    }
    at += channels * n;
  }
  return out;
}

// One instrument, from all channels that it measured.
Instrument recorded_instrument(std::span<const PreparedRun> runs, const fit::Fit& fit,
                               Instrument Instruments::*member) {
  Instrument out;
  Median sigma;
  std::vector<double> off;
  double samples = 0.0;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const PreparedRun& prepared = runs[r];
    for (std::size_t c = 0; c < prepared.noise.size(); ++c) {
      if (instrument_of(prepared.run->channels[c].kind) != member) continue;
      sigma.values.push_back(prepared.noise[c].sigma);
      if (c < prepared.whiteners.size() && prepared.whiteners[c] != nullptr)
        out.colour = nearest_colour(prepared.whiteners[c]->colour());
      if (!prepared.lines.empty() && member == &Instruments::angle) {
        out.hum_frequency = prepared.lines.front();
        out.hum = prepared.line_sizes.front();
      }
      samples += static_cast<double>(prepared.run->samples());
      if (r >= fit.runs.size()) continue;
      const std::vector<double> some = sizes_of_outliers(prepared, fit.runs[r], c);
      off.insert(off.end(), some.begin(), some.end());
    }
  }
  out.noise = sigma.value();
  if (off.empty()) return out;
  out.outlier_share = static_cast<double>(off.size()) / samples;
  out.smallest_outlier = std::ranges::min(off);
  out.largest_outlier = std::ranges::max(off);
  return out;
}

}  // namespace

NoiseColour nearest_colour(const noise::NoiseColour& recorded) {
  using enum NoiseColour::Kind;
  if (recorded.is_white || recorded.bands.empty()) return {};
  NoiseColour out;
  double least = distance(recorded.bands, [](double) { return 1.0; });
  const auto try_out = [&](NoiseColour colour, const auto& density) {
    const double apart = distance(recorded.bands, density);
    if (apart >= least) return;
    least = apart;
    out = colour;
  };
  try_out({.kind = one_over_f}, [](double frequency) { return 1.0 / frequency; });
  // Up to half the sampling rate. What lies above it is folded down: the spectrum of a low pass that is sampled is that
  // of an autoregression of first order.
  const double rate = 2.0 * recorded.bands.back().to;
  constexpr double ratio = 1.1;
  for (double corner = 0.005 * rate; corner < 0.5 * rate; corner *= ratio) {
    const double kept = std::exp(-2.0 * std::numbers::pi * corner / rate);
    try_out({.kind = low_pass, .frequency = std::round(1000.0 * corner) / 1000.0}, [&](double frequency) {
      return 1.0 / (1.0 - 2.0 * kept * std::cos(2.0 * std::numbers::pi * frequency / rate) + kept * kept);
    });
  }
  return out;
}

Instruments recorded_instruments(std::span<const PreparedRun> runs, const fit::Fit& fit) {
  Instruments out;
  for (Instrument Instruments::*member :
       {&Instruments::angle, &Instruments::rate, &Instruments::torque, &Instruments::force, &Instruments::temperature})
    out.*member = recorded_instrument(runs, fit, member);
  for (const PreparedRun& prepared : runs) out.input_noise = std::max(out.input_noise, prepared.input_noise);
  return out;
}

}  // namespace coilwright::measurement::experiment
