#include "coilwright/simulation/commanded_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>

namespace coilwright::simulation {
namespace {

void require_interval(double interval) {
  if (!std::isfinite(interval) || interval <= 0.0)
    throw std::invalid_argument(fmt::format("interval must be finite and > 0; got {}", interval));
}

void require_few(std::string_view what, double count, std::string_view cure) {
  if (count > most_samples)
    throw std::invalid_argument(
        fmt::format("{} must be at most {} samples; got {}: {}", what, most_samples, count, cure));
}

std::vector<double> sample_times(double duration, double interval) {
  if (!std::isfinite(duration) || duration <= 0.0)
    throw std::invalid_argument(fmt::format("duration must be finite and > 0; got {}", duration));
  require_interval(interval);
  const double count = std::floor(duration / interval * (1.0 + 1e-12));
  require_few("duration / interval", count, "a longer interval, or a shorter duration");
  std::vector<double> times;
  times.reserve(static_cast<std::size_t>(count) + 1);
  for (std::size_t i = 0; i <= static_cast<std::size_t>(count); ++i) times.push_back(static_cast<double>(i) * interval);
  return times;
}

}  // namespace

std::string_view name_of(Drive drive) {
  switch (drive) {
    case Drive::current:
      return "current";
    case Drive::voltage:
      return "voltage";
    case Drive::torque:
      return "torque";
  }
  return "";
}

CommandedInput step_command(const StepInput& step) {
  if (!std::isfinite(step.current))
    throw std::invalid_argument(fmt::format("current must be finite; got {}", step.current));
  CommandedInput command{.times = sample_times(step.duration, step.interval)};
  command.rows.assign(command.times.size(), {step.current});
  return command;
}

CommandedInput sine_command(const SineInput& sine) {
  // Held samples of a faster sine are another motion; at that frequency they all are alike.
  const double fastest = 0.5 / sine.interval;
  if (!(sine.frequency >= 0.0 && sine.frequency < fastest) && std::isfinite(sine.interval) && sine.interval > 0.0)
    throw std::invalid_argument(
        fmt::format("frequency must be at least 0 and below {:.6g} Hz, half of the samples a second; got {:.6g}",
                    fastest, sine.frequency));
  CommandedInput command{.times = sample_times(sine.duration, sine.interval)};
  command.rows.reserve(command.times.size());
  for (const double t : command.times)
    command.rows.push_back({sine.offset + sine.amplitude * std::sin(2.0 * std::numbers::pi * sine.frequency * t)});
  return command;
}

CommandedInput sampled_at_least_every(const CommandedInput& command, double interval) {
  require_interval(interval);
  const auto gap_after = [&](std::size_t i) { return command.times[i + 1] - command.times[i]; };
  const auto pieces_of = [&](double gap) { return std::ceil(gap / interval * (1.0 - 1e-12)); };
  double samples = 0.0;
  for (std::size_t i = 0; i + 1 < command.times.size(); ++i) samples += std::max(1.0, pieces_of(gap_after(i)));
  require_few("the input at this interval", samples, "a longer interval, or a shorter input");
  CommandedInput out{.drive = command.drive, .addressing = command.addressing};
  for (std::size_t i = 0; i < command.times.size(); ++i) {
    out.times.push_back(command.times[i]);
    out.rows.push_back(command.rows[i]);
    if (i + 1 == command.times.size()) break;
    const double gap = gap_after(i);
    const double pieces = pieces_of(gap);
    for (double k = 1.0; k < pieces; k += 1.0) {
      out.times.push_back(command.times[i] + gap * k / pieces);
      out.rows.push_back(command.rows[i]);
    }
  }
  return out;
}

}  // namespace coilwright::simulation
