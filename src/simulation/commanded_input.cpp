#include "coilwright/simulation/commanded_input.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>

namespace coilwright::simulation {
namespace {

constexpr double most_samples = 1e8;

double count_of_intervals(double duration, double interval) {
  if (!std::isfinite(interval) || interval <= 0.0)
    throw std::invalid_argument(fmt::format("interval must be finite and > 0; got {}", interval));
  const double count = std::floor(duration / interval * (1.0 + 1e-12));
  if (count > most_samples)
    throw std::invalid_argument(fmt::format("duration / interval must be at most {}; got {}", most_samples, count));
  return count;
}

std::vector<double> sample_times(double duration, double interval) {
  if (!std::isfinite(duration) || duration <= 0.0)
    throw std::invalid_argument(fmt::format("duration must be finite and > 0; got {}", duration));
  const double count = count_of_intervals(duration, interval);
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
  if (!command.times.empty()) (void)count_of_intervals(command.times.back() - command.times.front(), interval);
  CommandedInput out{.drive = command.drive, .addressing = command.addressing};
  for (std::size_t i = 0; i < command.times.size(); ++i) {
    out.times.push_back(command.times[i]);
    out.rows.push_back(command.rows[i]);
    if (i + 1 == command.times.size()) break;
    const double gap = command.times[i + 1] - command.times[i];
    const double pieces = std::ceil(gap / interval * (1.0 - 1e-12));
    for (double k = 1.0; k < pieces; k += 1.0) {
      out.times.push_back(command.times[i] + gap * k / pieces);
      out.rows.push_back(command.rows[i]);
    }
  }
  return out;
}

}  // namespace coilwright::simulation
