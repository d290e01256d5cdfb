#include "measurement/replay/prepared_run.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace coilwright::measurement::replay {
namespace {

using actuator::Model;
using mechanics::JointVector;
using simulation::State;

// How far a start may lie from where the data put it when they say little, rad and rad/s: a free start is held by this
// alone in directions that the cameras do not see.
constexpr double free_angle = 0.5;
constexpr double free_rate = 20.0;
// A parabola through this many samples is what the first of them tells of angle and rate.
constexpr std::size_t samples_of_a_start = 15;
constexpr std::size_t fewest_samples = 5;

std::invalid_argument misfit(const data::Run& run, const std::string& rule) {
  return std::invalid_argument(fmt::format("{}: {}", run.name, rule));
}

void check_channels(const data::Run& run, const Model& nominal) {
  for (const data::Channel& channel : run.channels) {
    if (channel.joint >= nominal.joints())
      throw misfit(run, fmt::format("{} is of joint {}, and the model has {}", channel.name, channel.joint + 1,
                                    nominal.joints()));
  }
}

void check_inputs(const data::Run& run, const Model& nominal) {
  try {
    simulation::require_can_drive(nominal, run.command());
  } catch (const std::invalid_argument& rule) {
    throw misfit(run, rule.what());
  }
}

struct StartOfChannel {
  double value{}, rate{}, value_sigma{}, rate_sigma{};
};

// Value and slope at the first sample of a parabola through the first few, and how well they are known.
StartOfChannel start_of(const data::Run& run, const data::Channel& channel, double sigma, std::size_t first,
                        std::size_t last) {
  const std::size_t count = std::min(samples_of_a_start, last - first);
  Eigen::MatrixXd powers(static_cast<Eigen::Index>(count), 3);
  Eigen::VectorXd values(static_cast<Eigen::Index>(count));
  const double unit = run.times[first + count - 1] - run.times[first];
  for (std::size_t i = 0; i < count; ++i) {
    const double t = (run.times[first + i] - run.times[first]) / unit;
    powers.row(static_cast<Eigen::Index>(i)) << 1.0, t, t * t;
    values[static_cast<Eigen::Index>(i)] = channel.values[first + i];
  }
  const Eigen::VectorXd fitted = powers.householderQr().solve(values);
  const Eigen::Matrix3d covariance = (powers.transpose() * powers).inverse() * sigma * sigma;
  return {.value = fitted[0],
          .rate = fitted[1] / unit,
          .value_sigma = std::sqrt(covariance(0, 0)),
          .rate_sigma = std::sqrt(covariance(1, 1)) / unit};
}

void set_start(const Record& record, Window& window, const Model& nominal) {
  const data::Run& run = *record.run;
  const int n = nominal.joints();
  State& guess = window.guess;
  State& sigma = window.guess_sigma;
  guess = {.angles = JointVector::Zero(n), .rates = JointVector::Zero(n)};
  sigma = {.angles = JointVector::Constant(n, free_angle), .rates = JointVector::Constant(n, free_rate)};
  const bool held = run.start == data::Start::measured;
  for (std::size_t c = 0; c < run.channels.size(); ++c) {
    const data::Channel& channel = run.channels[c];
    const StartOfChannel start = start_of(run, channel, record.noise[c].sigma, window.first, window.last);
    switch (channel.quantity) {
      case data::Quantity::bending_angle:
        // Shared between the joints alike where nothing else tells.
        if (n > 1 && sigma.angles.maxCoeff() < free_angle) break;
        guess.angles.setConstant(start.value / n);
        guess.rates.setConstant(start.rate / n);
        if (held && n == 1) sigma.angles.setConstant(start.value_sigma);
        if (held && n == 1) sigma.rates.setConstant(start.rate_sigma);
        break;
      case data::Quantity::joint_angle:
        guess.angles[channel.joint] = start.value;
        guess.rates[channel.joint] = start.rate;
        if (held) sigma.angles[channel.joint] = start.value_sigma;
        if (held) sigma.rates[channel.joint] = start.rate_sigma;
        break;
      default:
        break;
    }
  }
  for (std::size_t c = 0; c < run.channels.size(); ++c) {
    const data::Channel& channel = run.channels[c];
    if (channel.quantity == data::Quantity::joint_rate) guess.rates[channel.joint] = channel.values[window.first];
  }
}

std::vector<Window> windows_of(const data::Run& run) {
  std::vector<Window> out;
  const std::size_t samples = run.samples();
  std::size_t first = 0;
  while (first < samples) {
    std::size_t last = samples;
    if (run.window) {
      const double end = run.times[first] + *run.window * (1.0 - 1e-9);
      last = static_cast<std::size_t>(
          std::lower_bound(run.times.begin() + static_cast<std::ptrdiff_t>(first), run.times.end(), end) -
          run.times.begin());
    }
    out.push_back({.first = first, .last = last});
    first = last;
  }
  // A remainder too short to tell its own start is left out.
  if (out.size() > 1 && out.back().samples() < 2 * fewest_samples) out.pop_back();
  for (const Window& window : out)
    if (window.samples() < fewest_samples)
      throw misfit(run, fmt::format("needs at least {} samples in a window; got {}", fewest_samples, window.samples()));
  return out;
}

}  // namespace

std::vector<SampleRange> Record::stretches() const {
  if (!is_motion()) return {{.first = 0, .last = run->samples()}};
  std::vector<SampleRange> out;
  for (const Window& window : windows) out.push_back({.first = window.first, .last = window.last});
  return out;
}

void check(const data::Run& run, const DeclaredModel& declared, const Model& nominal) {
  check_channels(run, nominal);
  check_inputs(run, nominal);
  if (run.kind == data::RunKind::temperature && !declared.heat)
    throw misfit(run, "is a temperature, and a lumped model has no heat paths");
}

Record prepare(const data::Run& run, const DeclaredModel& declared, const Model& nominal) {
  check(run, declared, nominal);
  Record record{.run = &run};
  for (const data::Channel& channel : run.channels) record.noise.push_back(noise::noise_of(run, channel));
  if (!record.is_motion()) return record;
  record.windows = windows_of(run);
  const simulation::ModelInput input = simulation::model_input(nominal, run.command());
  for (Window& window : record.windows) {
    window.input = input.part(window.first, window.last);
    if (run.start != data::Start::at_rest) set_start(record, window, nominal);
  }
  return record;
}

}  // namespace coilwright::measurement::replay
