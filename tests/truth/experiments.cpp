#include "truth/experiments.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace truth {
namespace {

constexpr int rate = 500;  // samples per second

template <typename Current>
Experiment run(std::string name, double duration, Current&& current) {
  Experiment experiment;
  experiment.name = std::move(name);
  const int samples = static_cast<int>(std::lround(duration * rate));
  for (int i = 0; i < samples; ++i) {
    const double time = static_cast<double>(i) / rate;
    experiment.times.push_back(time);
    experiment.currents.push_back(std::round(current(time) * 1e6) / 1e6);
  }
  return experiment;
}

constexpr double begin = 0.05;  // s of rest before the input changes

Experiment step(double current) {
  return run(fmt::format("step_{:g}A", current), 0.7, [=](double t) { return t < begin ? 0.0 : current; });
}

Experiment sine(double mean, double amplitude, double frequency, double duration) {
  return run(fmt::format("sine_{:g}Hz", frequency), duration,
             [=](double t) { return mean + amplitude * std::sin(2.0 * std::numbers::pi * frequency * t); });
}

Experiment release(double current) {
  return run(fmt::format("release_{:g}A", current), 0.7, [=](double t) { return t < begin ? current : 0.0; });
}

// A hold that warms the coils, half a second without current, and a pulse through warm coils.
Experiment hold(double current, double until) {
  return run(fmt::format("hold_{:g}A", current), until + 1.0,
             [=](double t) { return (t >= begin && t < until) || t >= until + 0.5 ? current : 0.0; });
}

Experiment pulses(double current, double frequency) {
  return run(fmt::format("pulses_{:g}Hz", frequency), 1.0,
             [=](double t) { return t >= begin && std::fmod((t - begin) * frequency, 1.0) < 0.5 ? current : 0.0; });
}

// Two minutes between records.
void set_clock(PlannedRuns& planned) {
  int number = 0;
  for (std::vector<Experiment>* runs : {&planned.fit, &planned.validate}) {
    for (Experiment& experiment : *runs) {
      experiment.number = number;
      experiment.session_time = 120.0 * number;
      ++number;
    }
  }
}

}  // namespace

PlannedRuns paper_runs() {
  PlannedRuns planned;
  planned.fit = {step(0.35),
                 step(0.7),
                 step(1.05),
                 step(1.4),
                 sine(0.7, 0.7, 0.5, 2.0),
                 sine(0.7, 0.7, 1, 1),
                 sine(0.7, 0.7, 2, 1),
                 sine(0.7, 0.7, 10, 0.5),
                 release(1.4),
                 hold(1.3, 15.0)};
  planned.validate = {step(0.55), step(1.25), sine(0.6, 0.5, 1.5, 1.4), sine(0.7, 0.6, 4, 0.8), pulses(1.05, 5.0)};
  set_clock(planned);
  return planned;
}

PlannedRuns brief_runs() {
  PlannedRuns planned;
  planned.fit = {step(0.35), step(1.4), sine(0.7, 0.7, 1, 1), sine(0.7, 0.7, 10, 0.5), release(1.4), hold(1.3, 2.0)};
  planned.validate = {step(1.25), pulses(1.05, 5.0)};
  set_clock(planned);
  return planned;
}

}  // namespace truth
