#include "coilwright/measurement/twin.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "noise_source.hpp"
#include "prediction.hpp"
#include "record.hpp"

namespace coilwright::measurement {
namespace {

using actuator::Model;

std::size_t samples_of(const PlannedRun& planned) {
  // The last sample is at the end of the duration, or the last one before it.
  return static_cast<std::size_t>(std::floor(planned.duration * planned.rate * (1.0 + 1e-12))) + 1;
}

// A row of inputs out of one level: one value for all, or one each.
std::vector<double> row_of(const PlannedRun& planned, double level, const Model& model) {
  const bool torque = planned.plan.drive == Drive::torque;
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

void fill_inputs(const PlannedRun& planned, const Model& model, Run& run) {
  const std::size_t samples = samples_of(planned);
  const auto* table = std::get_if<TableShape>(&planned.input);
  for (std::size_t i = 0; i < samples; ++i) {
    // A quotient, not a product: 0.3 s is then the 0.3 of a step's time.
    const double time = static_cast<double>(i) / planned.rate;
    run.times.push_back(time);
    if (table == nullptr)
      run.inputs.push_back(row_of(planned, level_at(planned.input, time, planned.duration), model));
    else
      run.inputs.push_back(held_row(*table, time));
  }
}

// The run with its inputs, its values still zero.
Run prepared(const PlannedRun& planned, const Model& model) {
  Run run = planned.plan;
  const bool timed = run.kind == RunKind::transient || run.kind == RunKind::temperature;
  if (timed) fill_inputs(planned, model, run);
  const std::size_t samples = timed ? run.times.size() : std::max(run.angles.size(), run.inputs.size());
  for (Channel& channel : run.channels) channel.values.assign(samples, 0.0);
  // What concerns a later fit alone: the rig moves in one go, from where it stands, and does not know its noise (which
  // would be looked for in the zeros).
  run.window.reset();
  run.start = Start::at_rest;
  run.sigma = 1.0;
  return run;
}

simulation::State start_of(const PlannedRun& planned, const Model& model, const Window& window) {
  if (!planned.start_angles.empty()) {
    if (static_cast<int>(planned.start_angles.size()) != model.joints())
      throw std::invalid_argument(fmt::format("{}: needs a start angle for each of the {} joints; got {}",
                                              planned.plan.name, model.joints(), planned.start_angles.size()));
    const Eigen::Map<const Eigen::VectorXd> angles(planned.start_angles.data(), model.joints());
    return {.angles = angles, .rates = mechanics::JointVector::Zero(model.joints())};
  }
  if (const auto rest = rest_start(model, window)) return *rest;
  throw std::runtime_error(
      fmt::format("{}: has no stable pose under the first input to start from", planned.plan.name));
}

Eigen::VectorXd true_values(const PlannedRun& planned, const Run& run, const DeclaredModel& rig, const Model& model) {
  const Record record = prepare(run, rig, model);
  if (!record.is_motion()) {
    if (const auto values = predict_bench(model, record, rig)) return *values;
    throw std::runtime_error(fmt::format("{}: the finger has no equilibrium on this bench", run.name));
  }
  const Window& window = record.windows.front();
  if (const auto seen = predict_window(model, record, window, start_of(planned, model, window))) return seen->values;
  throw std::runtime_error(fmt::format("{}: the motion leaves the model", run.name));
}

Model with_effects(const DeclaredModel& rig, std::span<const actuator::Effect> hidden) {
  std::vector<double> declared;
  for (const CalibrationParameter& each : rig.calibration) declared.push_back(each.declared);
  actuator::ModelSpec spec = rig.build(declared);
  spec.effects.insert(spec.effects.end(), hidden.begin(), hidden.end());
  return Model(std::move(spec));
}

}  // namespace

const Instrument& Instruments::of(Quantity quantity) const {
  switch (quantity) {
    case Quantity::bending_angle:
    case Quantity::joint_angle:
      return angle;
    case Quantity::joint_rate:
      return rate;
    case Quantity::torque:
      return torque;
    case Quantity::force:
      return force;
    case Quantity::temperature:
      break;
  }
  return temperature;
}

std::vector<Run> act_out(const Experiment& experiment, const DeclaredModel& rig,
                         std::span<const actuator::Effect> hidden, std::uint64_t seed) {
  const Model model = with_effects(rig, hidden);
  std::vector<Run> out;
  for (const PlannedRun& planned : experiment.runs) {
    Run run = prepared(planned, model);
    const Eigen::VectorXd values = true_values(planned, run, rig, model);
    const auto samples = static_cast<Eigen::Index>(run.samples());
    for (std::size_t c = 0; c < run.channels.size(); ++c) {
      std::vector<double>& readings = run.channels[c].values;
      const auto of_channel = values.segment(static_cast<Eigen::Index>(c) * samples, samples);
      std::copy(of_channel.begin(), of_channel.end(), readings.begin());
      read_by(experiment.instruments.of(run.channels[c].quantity), {.seed = seed, .run = out.size(), .channel = c},
              readings);
    }
    run.window = planned.plan.window;
    run.start = planned.plan.start;
    run.sigma = planned.plan.sigma;
    out.push_back(std::move(run));
  }
  return out;
}

}  // namespace coilwright::measurement
