#include "measurement/replay/prepared_run.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "coilwright/algebra/least_squares.hpp"
#include "measurement/replay/input_noise.hpp"
#include "measurement/replay/window_input.hpp"

namespace coilwright::measurement::replay {
namespace {

using mechanics::JointVector;
using simulation::State;

// Standard deviations of an initial state of which the measurement tells little, rad and rad/s: they alone bound a free
// initial state in directions that the cameras do not see.
constexpr double free_angle = 0.5;
constexpr double free_rate = 20.0;
// A parabola through so many of the first samples gives angle and rate at the first one.
constexpr std::size_t parabola_samples = 15;

struct ChannelStart {
  double value{}, rate{}, value_sigma{}, rate_sigma{};
};

// Value and slope at the first sample of a parabola through the first few, with their standard deviations.
ChannelStart start_of(const data::Run& run, const data::Channel& channel, double sigma, SampleRange range) {
  const std::size_t first = range.first;
  const std::size_t count = std::min(parabola_samples, range.samples());
  Eigen::MatrixXd powers(static_cast<Eigen::Index>(count), 3);
  Eigen::VectorXd values(static_cast<Eigen::Index>(count));
  const double duration = run.times[first + count - 1] - run.times[first];
  for (std::size_t i = 0; i < count; ++i) {
    const double t = (run.times[first + i] - run.times[first]) / duration;
    powers.row(static_cast<Eigen::Index>(i)) << 1.0, t, t * t;
    values[static_cast<Eigen::Index>(i)] = channel.values[first + i];
  }
  const Eigen::VectorXd fitted = algebra::least_squares(powers, values);
  const Eigen::Matrix3d covariance = (powers.transpose() * powers).inverse() * sigma * sigma;
  return {.value = fitted[0],
          .rate = fitted[1] / duration,
          .value_sigma = std::sqrt(covariance(0, 0)),
          .rate_sigma = std::sqrt(covariance(1, 1)) / duration};
}

// What the first samples of a range tell of the state in which it starts. The noise levels of `prepared` must be
// there.
InitialStatePrior initial_state_prior(const PreparedRun& prepared, SampleRange range, const actuator::Model& nominal) {
  const data::Run& run = *prepared.run;
  const int n = nominal.joints();
  InitialStatePrior prior;
  State& mean = prior.mean;
  State& sigma = prior.sigma;
  mean = {.angles = JointVector::Zero(n), .rates = JointVector::Zero(n)};
  sigma = {.angles = JointVector::Constant(n, free_angle), .rates = JointVector::Constant(n, free_rate)};
  const bool measured = run.start == data::Start::measured;
  for (std::size_t c = 0; c < run.channels.size(); ++c) {
    const data::Channel& channel = run.channels[c];
    const ChannelStart start = start_of(run, channel, prepared.noise[c].sigma, range);
    switch (channel.kind) {
      case data::ChannelKind::bending_angle:
        // Shared equally between the joints unless a joint is measured itself.
        if (n > 1 && sigma.angles.maxCoeff() < free_angle) break;
        mean.angles.setConstant(start.value / n);
        mean.rates.setConstant(start.rate / n);
        if (measured && n == 1) sigma.angles.setConstant(start.value_sigma);
        if (measured && n == 1) sigma.rates.setConstant(start.rate_sigma);
        break;
      case data::ChannelKind::joint_angle:
        mean.angles[channel.joint] = start.value;
        mean.rates[channel.joint] = start.rate;
        if (measured) sigma.angles[channel.joint] = start.value_sigma;
        if (measured) sigma.rates[channel.joint] = start.rate_sigma;
        break;
      default:
        break;
    }
  }
  for (const data::Channel& channel : run.channels)
    if (channel.kind == data::ChannelKind::joint_rate) mean.rates[channel.joint] = channel.values[range.first];
  return prior;
}

using actuator::Model;

constexpr std::size_t fewest_samples_of_window = 5;  // in a window

std::invalid_argument misfit(const data::Run& run, const std::string& rule) {
  return std::invalid_argument(fmt::format("{}: {}", run.name, rule));
}

void require_joints(const data::Run& run, const Model& nominal) {
  for (const data::Channel& channel : run.channels) {
    if (channel.joint >= nominal.joints())
      throw misfit(run, fmt::format("{} is of joint {}, and the model has {}", channel.name, channel.joint + 1,
                                    nominal.joints()));
  }
}

void require_drive(const data::Run& run, const Model& nominal) {
  try {
    simulation::require_can_drive(nominal, run.command());
  } catch (const std::invalid_argument& rule) {
    throw misfit(run, rule.what());
  }
}

void require_contact(const data::Run& run, const Model& nominal) {
  const double tip = nominal.tip().along * (1.0 + 1e-9);  // rounding of a length in millimetres aside
  for (const double height : run.heights)
    if (height > tip)
      throw misfit(run, fmt::format("height_mm must not lie beyond the tip, {:.6g} mm from its joint; got {:.6g}",
                                    nominal.tip().along * 1e3, height * 1e3));
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
    out.push_back({.range = {.first = first, .last = last}});
    first = last;
  }
  // A remainder too short to determine its initial state is left out.
  if (out.size() > 1 && out.back().samples() < 2 * fewest_samples_of_window) out.pop_back();
  for (const Window& window : out)
    if (window.samples() < fewest_samples_of_window)
      throw misfit(run, fmt::format("needs at least {} samples in a window; got {}", fewest_samples_of_window,
                                    window.samples()));
  return out;
}

}  // namespace

std::vector<SampleRange> PreparedRun::sample_ranges() const {
  if (!is_motion()) return {{.first = 0, .last = run->samples()}};
  std::vector<SampleRange> out;
  for (const Window& window : windows) out.push_back(window.range);
  return out;
}

Eigen::Index PreparedRun::values_in(SampleRange range) const {
  return static_cast<Eigen::Index>(range.samples() * run->channels.size());
}

Eigen::Index PreparedRun::values() const {
  Eigen::Index count = 0;
  for (const SampleRange range : sample_ranges()) count += values_in(range);
  return count;
}

Eigen::Index PreparedRun::values_set_aside() const {
  Eigen::Index count = 0;
  for (const std::vector<char>& channel : set_aside)
    for (const SampleRange range : sample_ranges())
      if (!channel.empty())
        count += std::count(channel.begin() + static_cast<std::ptrdiff_t>(range.first),
                            channel.begin() + static_cast<std::ptrdiff_t>(range.last), 1);
  return count;
}

const InputWhitener* PreparedRun::input_whitener(SampleRange range) const {
  const auto window = std::ranges::find(windows, range.first, [](const Window& each) { return each.range.first; });
  return window == windows.end() ? nullptr : window->input_whitener.get();
}

bool weighs_input_errors(std::span<const PreparedRun> runs) {
  return std::ranges::any_of(runs, [](const PreparedRun& run) {
    return std::ranges::any_of(run.windows, [](const Window& window) { return window.input_whitener != nullptr; });
  });
}

void require_fits_model(const data::Run& run, const DeclaredModel& declared, const Model& nominal) {
  require_joints(run, nominal);
  require_drive(run, nominal);
  require_contact(run, nominal);
  if (run.kind == data::RunKind::temperature && !declared.heat)
    throw misfit(run, "is a temperature, and a lumped model has no heat paths");
}

PreparedRun prepare_run(const data::Run& run, const DeclaredModel& declared, const Model& nominal) {
  require_fits_model(run, declared, nominal);
  PreparedRun prepared{.run = &run};
  for (const data::Channel& channel : run.channels) prepared.noise.push_back(signals::noise_of(run, channel));
  if (!prepared.is_motion()) return prepared;
  prepared.windows = windows_of(run);
  // An input whose errors are declared is taken as it was recorded.
  const std::optional<CleanInput> clean =
      run.input_uncertainty.sigma.empty() ? without_noise(run) : std::optional<CleanInput>();
  if (clean) prepared.input_noise = clean->sigma;
  const CleanInput input = clean ? *clean : CleanInput{.rows = run.inputs};
  for (Window& window : prepared.windows) {
    set_input(window, run, input, nominal);
    if (prepared.fits_initial_state(window)) window.prior = initial_state_prior(prepared, window.range, nominal);
  }
  return prepared;
}

}  // namespace coilwright::measurement::replay
