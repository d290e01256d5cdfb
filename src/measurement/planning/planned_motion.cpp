#include "measurement/planning/planned_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include "coilwright/simulation/initial_state.hpp"
#include "measurement/replay/prediction.hpp"
#include "measurement/replay/prepared_run.hpp"
#include "measurement/replay/rig_change.hpp"
#include "measurement/replay/window_input.hpp"

namespace coilwright::measurement::planning {
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

std::vector<double> row_at(const PlannedRun& planned, double time, const Model& model) {
  // What began before the run, or goes on after it, is held.
  const double inside = std::clamp(time, 0.0, planned.duration);
  if (const auto* table = std::get_if<TableShape>(&planned.input)) return held_row(*table, inside);
  return row_of(planned, level_at(planned.input, inside, planned.duration), model);
}

bool has_times(const data::Run& run) {
  return run.kind == data::RunKind::transient || run.kind == data::RunKind::temperature ||
         run.kind == data::RunKind::still;
}

// How far the clocks may be apart, beyond chance, s.
double largest_shift(const PlannedRun& planned) {
  return 4.0 * (planned.plan.clock.offset_sigma + planned.plan.clock.rate_sigma * planned.duration);
}

// Whether the rig sees the shape itself, and not the recorded samples of it.
bool shape_drives(const PlannedRun& planned) {
  return planned.plan.kind == data::RunKind::transient &&
         (planned.input_rate > 0.0 || planned.plan.hold != data::InputHold::zero_order);
}

// When the shape jumps.
std::vector<double> edges(const PlannedRun& planned) {
  std::vector<double> out;
  if (const auto* step = std::get_if<StepShape>(&planned.input)) out = {step->at};
  if (const auto* hold = std::get_if<HoldShape>(&planned.input)) out = {hold->from, hold->until};
  if (const auto* pulse = std::get_if<PulseShape>(&planned.input))
    for (double start = 0.0; start <= planned.duration; start += pulse->period)
      out.insert(out.end(), {start, start + pulse->duty * pulse->period});
  if (const auto* table = std::get_if<TableShape>(&planned.input))
    for (const double time : table->times) out.push_back(time - table->times.front());
  return out;
}

// Times in an exposure at which the motion is looked at, over the exposure, and their weights: Simpson's rule.
constexpr std::array<std::pair<double, double>, 5> exposure_points = {
    {{-0.5, 1.0 / 12.0}, {-0.25, 4.0 / 12.0}, {0.0, 2.0 / 12.0}, {0.25, 4.0 / 12.0}, {0.5, 1.0 / 12.0}}};

// Where the samples of a run lie on the clock of the input.
struct SampleClock {
  const data::Run& run;
  TrueClock clock;

  [[nodiscard]] double at(std::size_t sample, double share) const {
    const double stamp = run.times[sample];
    return stamp + clock.shift + clock.rate * stamp + share * run.clock.exposure;
  }
};

// The run as it is simulated: in one piece, from its start, with a given noise level, because none can be estimated
// from zeros. The planned window, start and noise level concern a later fit only.
data::Run as_simulated(data::Run run) {
  run.window.reset();
  run.start = data::Start::at_rest;
  run.sigma = 1.0;
  run.clock = {};
  run.hold = {};
  run.rig = {};
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
  return simulation::start_of(model, window.input, simulation::Start::first_input, planned.plan.name);
}

Eigen::VectorXd motion(const PlannedRun& planned, const replay::PreparedRun& prepared, const replay::Window& window,
                       const Model& model) {
  if (const auto predicted = replay::predict_window(model, prepared, window, initial_state_of(planned, model, window)))
    return predicted->values;
  double largest = 0.0;
  for (const std::vector<double>& row : prepared.run->inputs)
    for (const double value : row) largest = std::max(largest, std::abs(value));
  throw std::runtime_error(fmt::format("{}: the motion leaves the model under an input of up to {:.4g} {}",
                                       planned.plan.name, largest, unit_of_drive(planned.plan.drive)));
}

// A shape that bends is held for such a piece of a sample at most, at its level in the middle of that.
constexpr double pieces_of_a_sample = 10.0;

// At how many times a run is simulated, at most.
double simulated_times(const PlannedRun& planned) {
  const data::RecordingClock& clock = planned.plan.clock;
  const double samples = planned.duration * planned.rate;
  if (!shape_drives(planned) && clock.exposure == 0.0 && clock.offset_sigma == 0.0 && clock.rate_sigma == 0.0)
    return samples;
  const auto* pulse = std::get_if<PulseShape>(&planned.input);
  return (clock.exposure > 0.0 ? static_cast<double>(exposure_points.size()) : 1.0) * samples +
         pieces_of_a_sample * std::max(planned.rate, planned.input_rate) *
             (planned.duration + 2.0 * largest_shift(planned)) +
         (pulse != nullptr ? 2.0 * planned.duration / pulse->period : 0.0);
}

// The same run sampled where the rig moves: at every look of the camera, at every edge, and between them.
data::Run as_it_moves(const PlannedRun& planned, const data::Run& run, const SampleClock& clock, const Model& model) {
  std::set<double> times;
  for (std::size_t i = 0; i < run.times.size(); ++i)
    for (const auto& [share, weight] : exposure_points) times.insert(clock.at(i, share));
  const double first = std::min(run.times_of_inputs().front(), *times.begin());
  const double last = std::max(run.times_of_inputs().back(), *times.rbegin());
  for (const double edge : edges(planned))
    if (edge > first && edge < last) times.insert(edge);
  const double interval = 1.0 / pieces_of_a_sample / std::max(planned.rate, planned.input_rate);
  for (double i = 0.0; first + i * interval < last; i += 1.0) times.insert(first + i * interval);
  times.insert(last);
  data::Run out = as_simulated(run);
  out.input_times.clear();
  out.times.assign(times.begin(), times.end());
  out.inputs.clear();
  for (std::size_t i = 0; i < out.times.size(); ++i)
    out.inputs.push_back(
        row_at(planned, std::midpoint(out.times[i], out.times[std::min(i + 1, out.times.size() - 1)]), model));
  for (data::Channel& channel : out.channels) channel.values.assign(out.times.size(), 0.0);
  return out;
}

// What the camera sees of a motion on the run's own stamps: means over the exposure.
Eigen::VectorXd seen(const data::Run& run, const data::Run& moving, const SampleClock& clock,
                     const Eigen::VectorXd& values) {
  const auto samples = static_cast<Eigen::Index>(run.samples());
  const auto moments = static_cast<Eigen::Index>(moving.times.size());
  Eigen::VectorXd out = Eigen::VectorXd::Zero(samples * static_cast<Eigen::Index>(run.channels.size()));
  for (Eigen::Index i = 0; i < samples; ++i)
    for (const auto& [share, weight] : exposure_points) {
      const auto found = std::ranges::lower_bound(moving.times, clock.at(static_cast<std::size_t>(i), share));
      const auto at = static_cast<Eigen::Index>(found - moving.times.begin());
      for (std::size_t c = 0; c < run.channels.size(); ++c)
        out[static_cast<Eigen::Index>(c) * samples + i] += weight * values[static_cast<Eigen::Index>(c) * moments + at];
    }
  return out;
}

// Nothing moves: every channel shows the resting angles.
Eigen::VectorXd at_rest(const data::Run& run, const Model& model) {
  const simulation::ModelInput nothing{.times = {0.0}, .currents = {model.all_coils(0.0)}};
  const auto rest = simulation::equilibrium_at_first_input(model, nothing);
  if (!rest) throw std::runtime_error(fmt::format("{}: has no stable pose to rest in", run.name));
  const auto samples = static_cast<Eigen::Index>(run.samples());
  Eigen::VectorXd out(samples * static_cast<Eigen::Index>(run.channels.size()));
  for (std::size_t c = 0; c < run.channels.size(); ++c) {
    const data::Channel& channel = run.channels[c];
    const double angle = channel.kind == data::ChannelKind::bending_angle ? rest->angles.sum()
                         : channel.kind == data::ChannelKind::joint_angle ? rest->angles[channel.joint]
                                                                          : 0.0;
    out.segment(static_cast<Eigen::Index>(c) * samples, samples)
        .setConstant(channel.kind == data::ChannelKind::joint_rate ? 0.0 : model.observed(angle));
  }
  return out;
}

}  // namespace

const char* unit_of_drive(data::Drive drive) {
  switch (drive) {
    case data::Drive::current:
      return "A";
    case data::Drive::voltage:
      return "V";
    case data::Drive::torque:
      return "N m";
  }
  return "";
}

void require_few_samples(const Experiment& experiment) {
  constexpr std::string_view cure = "shorten duration_s, or lower sampling_rate_Hz";
  double together = 0.0;
  for (const PlannedRun& planned : experiment.runs) {
    if (const double times = simulated_times(planned); times > simulation::most_samples)
      throw std::invalid_argument(
          fmt::format("{}: must be simulated at {} times at most (a sample is one; with an exposure, two clocks or an "
                      "input between samples some 10 to 15); got {:.0f}: {}",
                      planned.plan.name, simulation::most_samples, times, cure));
    together += planned.duration * planned.rate;
  }
  if (together > simulation::most_samples)
    throw std::invalid_argument(fmt::format("the runs must have at most {} samples together; got {:.0f}: {}",
                                            simulation::most_samples, together, cure));
}

data::Run with_inputs(const PlannedRun& planned, const actuator::Model& model) {
  data::Run run = planned.plan;
  const bool timed = has_times(run);
  // Quotients, not products, so that 0.3 s is the same number as the 0.3 in the time of a step.
  for (std::size_t i = 0; timed && i < samples_of(planned); ++i)
    run.times.push_back(static_cast<double>(i) / planned.rate);
  if (planned.input_rate > 0.0) {
    const double beyond = std::ceil((largest_shift(planned) + 0.5 * run.clock.exposure) * planned.input_rate) + 1.0;
    const double last = std::ceil(planned.duration * planned.input_rate) + beyond;
    for (double i = -beyond; i <= last; i += 1.0) run.input_times.push_back(i / planned.input_rate);
  }
  if (timed && run.kind != data::RunKind::still)
    for (const double time : run.times_of_inputs()) run.inputs.push_back(row_at(planned, time, model));
  const std::size_t samples = timed ? run.times.size() : std::max(run.angles.size(), run.inputs.size());
  for (data::Channel& channel : run.channels) channel.values.assign(samples, 0.0);
  return run;
}

Eigen::VectorXd true_values(const PlannedRun& planned, const data::Run& recorded, const TrueClock& clock,
                            const replay::DeclaredModel& rig, const actuator::Model& model) {
  if (recorded.kind == data::RunKind::still) return at_rest(recorded, model);
  data::Run run = recorded;
  PlannedRun driven = planned;
  if (!replay::current_flows(run.rig) && run.drive != data::Drive::torque) {
    // Nothing that is commanded reaches the coils.
    driven.plan.drive = run.drive = data::Drive::current;
    driven.input = StepShape{};
    for (std::vector<double>& row : run.inputs) std::ranges::fill(row, 0.0);
  }
  if (run.kind != data::RunKind::transient) {
    const data::Run simulated = as_simulated(run);
    const replay::PreparedRun prepared = replay::prepare_run(simulated, rig, model);
    if (const auto values = replay::predict_bench(model, prepared, rig)) return *values;
    throw std::runtime_error(fmt::format("{}: the finger has no equilibrium on this bench", run.name));
  }
  const bool plain = !shape_drives(planned) && run.clock.exposure == 0.0 && clock.shift == 0.0 && clock.rate == 0.0;
  if (plain) {
    const data::Run simulated = as_simulated(std::move(run));
    replay::require_fits_model(simulated, rig, model);
    // Its rows as they are: a fast sine that is sampled a few times a period would pass as noise of a recorded input,
    // and what a curve makes of steps is for those to judge who replay this record.
    replay::Window window{.range = {.first = 0, .last = simulated.times.size()}};
    replay::set_input(window, simulated, {.rows = simulated.inputs, .as_steps = true}, model);
    return motion(planned, {.run = &simulated}, window, model);
  }
  const SampleClock samples{.run = run, .clock = clock};
  if (!shape_drives(planned)) {
    // The recorded samples themselves drive the rig: a table of them.
    driven.input = TableShape{.times = run.times, .rows = run.inputs};
    driven.only.reset();
  }
  const data::Run moving = as_it_moves(driven, run, samples, model);
  replay::require_fits_model(moving, rig, model);
  const replay::Window window{.range = {.first = 0, .last = moving.times.size()},
                              .input = simulation::model_input(model, moving.command())};
  return seen(run, moving, samples, motion(planned, {.run = &moving}, window, model));
}

}  // namespace coilwright::measurement::planning
