#include "coilwright/measurement/data/data_quality.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <optional>
#include <span>
#include <string>

#include "coilwright/units/angle.hpp"
#include "measurement/data/equal_stretches.hpp"
#include "measurement/data/median_interval.hpp"

namespace coilwright::measurement::data {
namespace {

constexpr double largest_gap = 20.0;  // median intervals
// Factor by which the longest rest at an extreme must exceed that at any other value: a quantised sensor without noise
// rests at every turning point. The extreme must also be reached in full motion: what comes to rest by itself slows
// down before.
constexpr std::size_t unusual_rest = 4;
constexpr std::size_t shortest_rest = 10;  // samples
constexpr std::size_t approach = 5;        // samples
constexpr double full_motion = 0.25;       // fraction of the rms change between samples

// Values that no rig of this kind reaches, and that a unit wrong by a factor of 57 or 1000 exceeds: a camera of 500
// pictures a second whose milliseconds are taken for seconds has one every 2 s.
constexpr double largest_angle = 4.0 * std::numbers::pi;  // rad
constexpr double largest_current = 100.0;                 // A
constexpr double longest_interval = 1.5;                  // s between samples of a motion
constexpr double coldest = -60.0;                         // degC
constexpr double hottest = 400.0;                         // degC

bool constant(std::span<const double> values) {
  return std::ranges::adjacent_find(values, std::ranges::not_equal_to()) == values.end();
}

std::optional<std::string> constant_input(const Run& run) {
  if (run.inputs.size() < 3 || run.start != Start::at_rest) return std::nullopt;
  if (run.kind != RunKind::transient && run.kind != RunKind::blocked_force) return std::nullopt;
  if (std::ranges::adjacent_find(run.inputs, std::ranges::not_equal_to()) != run.inputs.end()) return std::nullopt;
  if (run.kind == RunKind::blocked_force)
    return "the current is the same in every sample: nothing tells force from bias";
  return "the input never moves, and the run starts at rest under it: only slow effects and noise can show; where "
         "nothing moves in it, \"kind\": \"still\" makes it tell the noise of all runs";
}

// Root mean square of the change from one sample to the next.
double rms_change(std::span<const double> values) {
  double sum = 0.0;
  for (std::size_t i = 1; i < values.size(); ++i) sum += (values[i] - values[i - 1]) * (values[i] - values[i - 1]);
  return std::sqrt(sum / static_cast<double>(values.size() - 1));
}

// Mean change from sample to sample just before `start`.
double change_before(std::span<const double> values, std::size_t start) {
  const std::size_t first = start > approach ? start - approach : 1;
  double sum = 0.0;
  for (std::size_t i = first; i < start; ++i) sum += std::abs(values[i] - values[i - 1]);
  return start > first ? sum / static_cast<double>(start - first) : 0.0;
}

struct LongestRests {
  std::size_t extreme{};  // samples in a row at the largest or smallest value, reached in full motion
  std::size_t other{};    // samples in a row at any other value
  double value{};         // the extreme of the first
};

LongestRests longest_rests(std::span<const double> values) {
  const auto [lowest, highest] = std::ranges::minmax(values);
  const double least_change = full_motion * rms_change(values);
  LongestRests rest;
  for (const EqualStretch& each : equal_stretches(values)) {
    const double value = values[each.first];
    if (value != lowest && value != highest) {
      if (each.first > 0) rest.other = std::max(rest.other, each.size);  // before a motion, any reading may rest
    } else if (each.size > rest.extreme && change_before(values, each.first) >= least_change) {
      rest.extreme = each.size;
      rest.value = value;
    }
  }
  return rest;
}

std::string in_unit(double value, const Channel& channel) {
  switch (channel.kind) {
    case ChannelKind::bending_angle:
    case ChannelKind::joint_angle:
      return fmt::format("{:.6g} deg", value * units::degrees_per_radian);
    case ChannelKind::joint_rate:
      return fmt::format("{:.6g} rad/s", value);
    case ChannelKind::torque:
      return fmt::format("{:.6g} N mm", value * 1e3);
    case ChannelKind::force:
      return fmt::format("{:.6g} N", value);
    case ChannelKind::temperature:
      break;
  }
  return fmt::format("{:.6g} degC", value);
}

std::optional<std::string> stuck_sensor(const Channel& channel) {
  if (channel.values.size() < 3) return std::nullopt;
  if (constant(channel.values))
    return fmt::format("{} is {} in every sample", channel.name, in_unit(channel.values.front(), channel));
  const LongestRests rest = longest_rests(channel.values);
  if (rest.extreme < shortest_rest || rest.extreme <= unusual_rest * rest.other) return std::nullopt;
  return fmt::format(
      "{} stays at exactly {}, its extreme, for {} samples, and nowhere else for more than {}: the sensor is "
      "saturated, the camera stopped, or the motion ends at a stop",
      channel.name, in_unit(rest.value, channel), rest.extreme, rest.other);
}

std::optional<std::string> implausible_clock(const Run& run) {
  if (run.kind != RunKind::transient || run.times.size() < 3) return std::nullopt;
  const double interval = median_interval(run);
  if (interval <= longest_interval) return std::nullopt;
  return fmt::format(
      "a sample every {:.3g} s for {:.6g} s shows no motion of such a finger and is long to simulate: is "
      "the unit right? time_ms are milliseconds",
      interval, run.times.back() - run.times.front());
}

std::optional<std::string> gap_in_clock(const Run& run) {
  if (run.times.size() < 3) return std::nullopt;
  std::size_t at = 1;
  for (std::size_t i = 2; i < run.times.size(); ++i)
    if (run.times[i] - run.times[i - 1] > run.times[at] - run.times[at - 1]) at = i;
  const double gap = run.times[at] - run.times[at - 1];
  const double usual = median_interval(run);
  if (gap <= largest_gap * usual) return std::nullopt;
  return fmt::format(
      "the clock jumps by {:.6g} s after {:.6g} s, {:.3g} times the usual interval; the input is held "
      "meanwhile",
      gap, run.times[at - 1], gap / usual);
}

std::optional<std::string> implausible_angle(const std::string& name, std::span<const double> values) {
  const auto [lowest, highest] = std::ranges::minmax(values);
  const double angle = highest > -lowest ? highest : lowest;
  if (std::abs(angle) <= largest_angle) return std::nullopt;
  return fmt::format("{} reaches {:.6g} deg, more than two turns: is the unit right?", name,
                     angle * units::degrees_per_radian);
}

std::optional<std::string> implausible_temperature(const Channel& channel) {
  const auto [lowest, highest] = std::ranges::minmax(channel.values);
  if (lowest >= coldest && highest <= hottest) return std::nullopt;
  return fmt::format("{} goes from {:.6g} to {:.6g} degC: is the unit right?", channel.name, lowest, highest);
}

std::optional<std::string> implausible_current(const Run& run) {
  if (run.drive != Drive::current) return std::nullopt;
  double largest = 0.0;
  for (const std::vector<double>& sample : run.inputs)
    for (const double current : sample) largest = std::max(largest, std::abs(current));
  if (largest <= largest_current) return std::nullopt;
  return fmt::format("a current of {:.6g} A is commanded: is the unit right?", largest);
}

}  // namespace

std::vector<Warning> data_quality_warnings(const Run& run) {
  std::vector<Warning> warnings;
  const auto add = [&](const std::optional<std::string>& text) {
    if (text) warnings.push_back({.run = run.name, .text = *text});
  };
  if (run.samples() == 0) return warnings;
  add(implausible_clock(run));
  add(gap_in_clock(run));
  add(constant_input(run));
  add(implausible_current(run));
  if (!run.angles.empty()) add(implausible_angle("the angle", run.angles));
  for (const Channel& channel : run.channels) {
    if (channel.kind == ChannelKind::bending_angle || channel.kind == ChannelKind::joint_angle)
      add(implausible_angle(channel.name, channel.values));
    if (channel.kind == ChannelKind::temperature) add(implausible_temperature(channel));
    if (run.kind != RunKind::still || constant(channel.values)) add(stuck_sensor(channel));
  }
  return warnings;
}

}  // namespace coilwright::measurement::data
