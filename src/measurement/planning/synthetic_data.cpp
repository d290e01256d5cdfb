#include "coilwright/measurement/planning/synthetic_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "measurement/planning/apply_instrument.hpp"
#include "measurement/planning/planned_motion.hpp"
#include "measurement/replay/rig_change.hpp"

namespace coilwright::measurement::planning {
namespace {

using actuator::Model;

Model with_effects(const replay::DeclaredModel& rig, std::span<const actuator::Effect> hidden,
                   const data::RigChange& change) {
  std::vector<double> declared;
  for (const replay::CalibrationParameter& each : rig.calibration) declared.push_back(each.declared);
  actuator::ModelSpec spec = rig.build(declared);
  spec.effects.insert(spec.effects.end(), hidden.begin(), hidden.end());
  return Model(replay::on_changed_rig(std::move(spec), change));
}

// Noise of the instrument that records the input.
void add_input_noise(data::Run& run, double deviation, const NoiseStream& stream) {
  if (deviation <= 0.0 || run.inputs.empty() || run.kind != data::RunKind::transient) return;
  const std::size_t width = run.inputs.front().size();
  const std::vector<double> noise = normal_numbers(stream, run.inputs.size() * width);
  for (std::size_t i = 0; i < noise.size(); ++i) run.inputs[i / width][i % width] += deviation * noise[i];
}

// What a recorded input is off from what acted.
void add_input_errors(data::Run& run, std::uint64_t seed, std::size_t number) {
  constexpr std::size_t first_column = 1'000'002;
  data::InputUncertainty& uncertainty = run.input_uncertainty;
  if (uncertainty.sigma.empty() || run.inputs.empty()) return;
  const std::size_t width = run.inputs.front().size();
  if (uncertainty.sigma.size() == 1) uncertainty.sigma.assign(width, uncertainty.sigma.front());
  if (uncertainty.sigma.size() != width)
    throw std::invalid_argument(
        fmt::format("{}: input_sigma must be one number, or one for each of the {} columns of the input; got {}",
                    run.name, width, uncertainty.sigma.size()));
  for (std::size_t c = 0; c < width; ++c) {
    Instrument instrument{.noise = uncertainty.sigma[c]};
    if (uncertainty.correlation > 0.0)
      instrument.colour = {.kind = NoiseColour::Kind::low_pass,
                           .frequency = 0.5 / (std::numbers::pi * uncertainty.correlation)};
    std::vector<double> column;
    for (const std::vector<double>& row : run.inputs) column.push_back(row[c]);
    column = apply_instrument(instrument, {.seed = seed, .run = number, .channel = first_column + c},
                              run.times_of_inputs(), std::move(column));
    for (std::size_t i = 0; i < column.size(); ++i) run.inputs[i][c] = column[i];
  }
}

}  // namespace

std::vector<TrueClock> true_clocks(const Experiment& experiment, std::uint64_t seed) {
  constexpr std::size_t clock_stream = 1'000'000;  // beyond any channel
  std::vector<TrueClock> out;
  for (const PlannedRun& planned : experiment.runs) {
    const auto draws = normal_numbers({.seed = seed, .run = out.size(), .channel = clock_stream}, 2);
    const data::RecordingClock& clock = planned.plan.clock;
    // Beyond four deviations a recorded input would not cover the run.
    const auto drawn = [](double sigma, double draw) { return sigma * std::clamp(draw, -4.0, 4.0); };
    out.push_back({.shift = drawn(clock.offset_sigma, draws[0]), .rate = drawn(clock.rate_sigma, draws[1])});
  }
  return out;
}

std::vector<data::Run> simulate_experiment(const Experiment& experiment, const replay::DeclaredModel& rig,
                                           std::span<const actuator::Effect> hidden, std::uint64_t seed) {
  constexpr std::size_t input_stream = 1'000'001;
  require_few_samples(experiment);
  const std::vector<TrueClock> clocks = true_clocks(experiment, seed);
  std::vector<data::Run> out;
  for (const PlannedRun& planned : experiment.runs) {
    const Model model = with_effects(rig, hidden, planned.plan.rig);
    data::Run run = with_inputs(planned, model);
    const Eigen::VectorXd values = true_values(planned, run, clocks[out.size()], rig, model);
    const auto samples = static_cast<Eigen::Index>(run.samples());
    for (std::size_t c = 0; c < run.channels.size(); ++c) {
      const auto of_channel = values.segment(static_cast<Eigen::Index>(c) * samples, samples);
      run.channels[c].values = apply_instrument(experiment.instruments.of(run.channels[c].kind),
                                                {.seed = seed, .run = out.size(), .channel = c}, run.times,
                                                {of_channel.begin(), of_channel.end()});
    }
    add_input_noise(run, experiment.instruments.input_noise,
                    {.seed = seed, .run = out.size(), .channel = input_stream});
    add_input_errors(run, seed, out.size());
    out.push_back(std::move(run));
  }
  return out;
}

}  // namespace coilwright::measurement::planning
