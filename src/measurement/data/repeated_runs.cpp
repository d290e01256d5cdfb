#include "coilwright/measurement/data/repeated_runs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "coilwright/units/angle.hpp"

namespace coilwright::measurement::data {
namespace {

constexpr double most_spread = 5.0 / units::degrees_per_radian;
// Of the standard deviation of the noise in a quarter of the record, which slow noise changes, too.
constexpr double most_drift = 4.0;
constexpr double most_change = 2.5;
constexpr double still_input = 0.02;  // of its size, what a sensor of the current reads beside it

constexpr double like_input = 0.1, like_readings = 1.0 / 6.0;  // rms, of the range
constexpr double like_length = 1.4;
constexpr double like_size = 1.4;  // of the ranges of a reading: a motion that is soon over differs little in rms
constexpr int points = 200;
constexpr int farthest_shift = points / 3;

bool is_angle(const Channel& channel) {
  return channel.kind == ChannelKind::bending_angle || channel.kind == ChannelKind::joint_angle;
}

// By column; nothing where there is no input.
std::vector<double> column_of(const std::vector<std::vector<double>>& rows, std::size_t column) {
  std::vector<double> out;
  for (const std::vector<double>& row : rows) out.push_back(row[column]);
  return out;
}

struct Spread {
  double mean{}, deviation{};
};

Spread spread_of(std::span<const double> values) {
  Spread out;
  for (const double value : values) out.mean += value / static_cast<double>(values.size());
  for (const double value : values)
    out.deviation += (value - out.mean) * (value - out.mean) / static_cast<double>(values.size());
  out.deviation = std::sqrt(out.deviation);
  return out;
}

bool rests(const std::vector<double>& values) {
  const auto [least, most] = std::ranges::minmax(values);
  if (values.size() < 8 || most - least > most_spread) return false;
  const std::size_t quarter = values.size() / 4;
  const Spread begin = spread_of(std::span(values).first(quarter)), end = spread_of(std::span(values).last(quarter));
  const double noise = 0.5 * (begin.deviation + end.deviation);
  return std::abs(begin.mean - end.mean) <= most_drift * noise && begin.deviation <= most_change * end.deviation &&
         end.deviation <= most_change * begin.deviation;
}

// A record at even times from its first one on: each column at the last sample before.
std::vector<std::vector<double>> evenly(const std::vector<double>& times,
                                        const std::vector<std::vector<double>>& columns, double from, double interval) {
  std::vector<std::vector<double>> out(columns.size());
  std::size_t at = 0;
  for (int i = 0; i < points; ++i) {
    while (at + 1 < times.size() && times[at + 1] <= from + interval * i) ++at;
    for (std::size_t c = 0; c < columns.size(); ++c) out[c].push_back(columns[c][at]);
  }
  return out;
}

// Rms of their difference over their common range, where `b` is shifted, by the column that is worst. The range is at
// least `share` of the size: that of an input that stays where it is.
double distance(const std::vector<std::vector<double>>& a, const std::vector<std::vector<double>>& b, int shift,
                double share) {
  double worst = 0.0;
  for (std::size_t c = 0; c < a.size(); ++c) {
    const auto [least_a, most_a] = std::ranges::minmax(a[c]);
    const auto [least_b, most_b] = std::ranges::minmax(b[c]);
    const double range = std::max(
        {std::max(most_a, most_b) - std::min(least_a, least_b), share * std::abs(most_a), share * std::abs(most_b)});
    if (range == 0.0) continue;
    double sum = 0.0;
    int count = 0;
    for (int i = std::max(0, -shift); i < points && i + shift < points; ++i, ++count) {
      const double miss = a[c][static_cast<std::size_t>(i)] - b[c][static_cast<std::size_t>(i + shift)];
      sum += miss * miss;
    }
    worst = std::max(worst, std::sqrt(sum / count) / range);
  }
  return worst;
}

bool are_alike_in_size(const Run& run, const Run& other) {
  for (std::size_t c = 0; c < run.channels.size(); ++c) {
    const auto [least, most] = std::ranges::minmax(run.channels[c].values);
    const auto [other_least, other_most] = std::ranges::minmax(other.channels[c].values);
    const auto [smaller, larger] = std::minmax({most - least, other_most - other_least});
    if (larger > like_size * smaller) return false;
  }
  return true;
}

struct Evenly {
  std::vector<std::vector<double>> inputs, readings;
};

Evenly evenly(const Run& run, double interval) {
  const double from = run.times.front();
  std::vector<std::vector<double>> inputs, readings;
  for (std::size_t c = 0; !run.inputs.empty() && c < run.inputs.front().size(); ++c)
    inputs.push_back(column_of(run.inputs, c));
  for (const Channel& channel : run.channels) readings.push_back(channel.values);
  return {.inputs = evenly(run.times_of_inputs(), inputs, from, interval),
          .readings = evenly(run.times, readings, from, interval)};
}

}  // namespace

bool nothing_moves(const Run& run) {
  for (std::size_t c = 0; !run.inputs.empty() && c < run.inputs.front().size(); ++c) {
    const std::vector<double> input = column_of(run.inputs, c);
    const auto [least, most] = std::ranges::minmax(input);
    if (most - least > still_input * std::max(std::abs(least), std::abs(most)) && most - least > still_input)
      return false;
  }
  bool has_angle = false;
  for (const Channel& channel : run.channels) {
    if (!is_angle(channel)) continue;
    has_angle = true;
    if (!rests(channel.values)) return false;
  }
  return has_angle;
}

bool is_repeated(const Run& run, const Run& other) {
  if (run.kind != RunKind::transient || other.kind != run.kind || other.drive != run.drive || other.rig != run.rig ||
      run.channels.size() != other.channels.size() || run.inputs.empty() != other.inputs.empty())
    return false;
  if (!run.inputs.empty() && run.inputs.front().size() != other.inputs.front().size()) return false;
  if (std::ranges::equal(run.channels, other.channels, {}, &Channel::values, &Channel::values)) return false;
  const auto [shorter, longer] =
      std::minmax({run.times.back() - run.times.front(), other.times.back() - other.times.front()});
  if (longer > like_length * shorter || !are_alike_in_size(run, other)) return false;
  const Evenly a = evenly(run, shorter / points), b = evenly(other, shorter / points);
  for (int shift = -farthest_shift; shift <= farthest_shift; ++shift)
    if (distance(a.inputs, b.inputs, shift, 0.5) <= like_input &&
        distance(a.readings, b.readings, shift, 0.0) <= like_readings)
      return true;
  return false;
}

std::vector<std::size_t> experiments_of(std::span<const Run> runs) {
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    std::size_t first = 0;
    while (first < i && (out[first] != first || !is_repeated(runs[first], runs[i]))) ++first;
    out.push_back(first);
  }
  return out;
}

}  // namespace coilwright::measurement::data
