#include "coilwright/measurement/experiment/synthetic_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "coilwright/simulation/initial_state.hpp"
#include "measurement/experiment/apply_instrument.hpp"
#include "measurement/replay/prediction.hpp"
#include "measurement/replay/prepared_run.hpp"

namespace coilwright::measurement::experiment {
namespace {

using actuator::Model;

std::size_t samples_of(const PlannedRun& planned) {
  // The last sample is at the end of the duration, or the last one before it.
  return static_cast<std::size_t>(std::floor(planned.duration * planned.rate * (1.0 + 1e-12))) + 1;
}

// One row of inputs from a level: one value for all coils, or one value for each.
std::vector<double> row_of(const PlannedRun& planned, double level, const Model& model) {
  const bool torque = planned.plan.drive == data::Drive::torque;
  if (!torque && !planned.only) return {level};
  std::vector<double> row(static_cast<std::size_t>(torque ? model.joints() : model.coils()), 0.0);
  if (!planned.only) {
    std::ranges::fill(row, level);
    return row;
  }
  const auto driven = static_cast<std::size_t>(*planned.only);
  if (driven >= row.size())
    throw std::invalid_argument(fmt::format("{}: drives {} {}, and the model has {}", planned.plan.name,
                                            torque ? "joint" : "coil", driven + 1, row.size()));
  row[driven] = level;
  return row;
}

std::vector<double> held_row(const TableShape& table, double time) {
  const auto after = std::ranges::upper_bound(table.times, table.times.front() + time);
  return table.rows[static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - table.times.begin(), 1) - 1)];
}

// The planned run with its inputs and with values that are still zero.
data::Run with_inputs(const PlannedRun& planned, const Model& model) {
  data::Run run = planned.plan;
  const bool timed = run.kind == data::RunKind::transient || run.kind == data::RunKind::temperature;
  const auto* table = std::get_if<TableShape>(&planned.input);
  for (std::size_t i = 0; timed && i < samples_of(planned); ++i) {
    // A quotient, not a product, so that 0.3 s is the same number as the 0.3 in the time of a step.
    const double time = static_cast<double>(i) / planned.rate;
    run.times.push_back(time);
    run.inputs.push_back(table == nullptr ? row_of(planned, level_at(planned.input, time, planned.duration), model)
                                          : held_row(*table, time));
  }
  const std::size_t samples = timed ? run.times.size() : std::max(run.angles.size(), run.inputs.size());
  for (data::Channel& channel : run.channels) channel.values.assign(samples, 0.0);
  return run;
}

// The run as it is simulated: in one piece, from its start, with a given noise level, because none can be estimated
// from zeros. The planned window, start and noise level concern a later fit only.
data::Run as_simulated(data::Run run) {
  run.window.reset();
  run.start = data::Start::at_rest;
  run.sigma = 1.0;
  return run;
}

simulation::State initial_state_of(const PlannedRun& planned, const Model& model, const replay::Window& window) {
  if (!planned.start_angles.empty()) {
    if (static_cast<int>(planned.start_angles.size()) != model.joints())
      throw std::invalid_argument(fmt::format("{}: needs a start angle for each of the {} joints; got {}",
                                              planned.plan.name, model.joints(), planned.start_angles.size()));
    const Eigen::Map<const Eigen::VectorXd> angles(planned.start_angles.data(), model.joints());
    return {.angles = angles, .rates = mechanics::JointVector::Zero(model.joints())};
  }
  if (const auto rest = simulation::equilibrium_at_first_input(model, window.input)) return *rest;
  throw std::runtime_error(
      fmt::format("{}: has no stable pose under the first input to start from", planned.plan.name));
}

Eigen::VectorXd true_values(const PlannedRun& planned, const data::Run& run, const replay::DeclaredModel& rig,
                            const Model& model) {
  const replay::PreparedRun prepared = replay::prepare_run(run, rig, model);
  if (!prepared.is_motion()) {
    if (const auto values = replay::predict_bench(model, prepared, rig)) return *values;
    throw std::runtime_error(fmt::format("{}: the finger has no equilibrium on this bench", run.name));
  }
  const replay::Window& window = prepared.windows.front();
  if (const auto predicted = replay::predict_window(model, prepared, window, initial_state_of(planned, model, window)))
    return predicted->values;
  throw std::runtime_error(fmt::format("{}: the motion leaves the model", run.name));
}

Model with_effects(const replay::DeclaredModel& rig, std::span<const actuator::Effect> hidden) {
  std::vector<double> declared;
  for (const replay::CalibrationParameter& each : rig.calibration) declared.push_back(each.declared);
  actuator::ModelSpec spec = rig.build(declared);
  spec.effects.insert(spec.effects.end(), hidden.begin(), hidden.end());
  return Model(std::move(spec));
}

}  // namespace

std::vector<data::Run> simulate_experiment(const Experiment& experiment, const replay::DeclaredModel& rig,
                                           std::span<const actuator::Effect> hidden, std::uint64_t seed) {
  const Model model = with_effects(rig, hidden);
  std::vector<data::Run> out;
  for (const PlannedRun& planned : experiment.runs) {
    data::Run run = with_inputs(planned, model);
    const Eigen::VectorXd values = true_values(planned, as_simulated(run), rig, model);
    const auto samples = static_cast<Eigen::Index>(run.samples());
    for (std::size_t c = 0; c < run.channels.size(); ++c) {
      const auto of_channel = values.segment(static_cast<Eigen::Index>(c) * samples, samples);
      run.channels[c].values =
          apply_instrument(experiment.instruments.of(run.channels[c].kind),
                           {.seed = seed, .run = out.size(), .channel = c}, {of_channel.begin(), of_channel.end()});
    }
    out.push_back(std::move(run));
  }
  return out;
}

}  // namespace coilwright::measurement::experiment
