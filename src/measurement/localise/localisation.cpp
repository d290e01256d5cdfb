#include "measurement/localise/localisation.hpp"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "measurement/replay/prediction.hpp"
#include "measurement/replay/rig_change.hpp"
#include "measurement/replay/window_input.hpp"

namespace coilwright::measurement::localise {
namespace {

struct MeasuredAngles {
  std::vector<std::vector<double>> series{};
  std::vector<double> sigma{};
};

// Measured angles of one kind over the windows of a run, with the offset and the scale of the camera removed. A delay
// of the camera is not removed: it causes no torque, and appears as one that depends on the rate.
MeasuredAngles angles_of(const replay::PreparedRun& prepared, data::ChannelKind kind, const actuator::Model& model) {
  // The camera's offset and scale form a linear function.
  const double offset = model.observed(0.0);
  const double scale = model.observed(1.0) - offset;
  MeasuredAngles out;
  for (std::size_t c = 0; c < prepared.run->channels.size(); ++c) {
    const data::Channel& channel = prepared.run->channels[c];
    if (channel.kind != kind) continue;
    std::vector<double> values;
    for (const replay::Window& window : prepared.windows)
      for (std::size_t i = window.range.first; i < window.range.last; ++i)
        values.push_back((channel.values[i] - offset) / scale);
    out.series.push_back(std::move(values));
    out.sigma.push_back(prepared.noise[c].sigma / scale);
  }
  return out;
}

// The angles of all joints if each was measured, or the bending angle.
MeasuredAngles angles_of(const replay::PreparedRun& prepared, const actuator::Model& model) {
  MeasuredAngles joints = angles_of(prepared, data::ChannelKind::joint_angle, model);
  if (joints.series.size() == static_cast<std::size_t>(model.joints())) return joints;
  return angles_of(prepared, data::ChannelKind::bending_angle, model);
}

void append(const simulation::ModelInput& more, simulation::ModelInput& all) {
  all.times.insert(all.times.end(), more.times.begin(), more.times.end());
  all.currents.insert(all.currents.end(), more.currents.begin(), more.currents.end());
  all.joint_torques.insert(all.joint_torques.end(), more.joint_torques.begin(), more.joint_torques.end());
}

// The measured motion beside that of the model, window by window from the initial states that the fit found. Nothing if
// no angle was measured or the model cannot be simulated.
std::optional<MeasuredMotion> motion_of(const replay::PreparedRun& prepared, const fit::RunFit& fitted,
                                        const actuator::Model& model) {
  MeasuredAngles measured = angles_of(prepared, model);
  if (measured.series.empty()) return std::nullopt;
  MeasuredMotion motion{.run = prepared.run->name,
                        .model = &model,
                        .angles = std::move(measured.series),
                        .sigma = std::move(measured.sigma),
                        .starts = {}};
  actuator::InternalStates internal;
  for (std::size_t w = 0; w < prepared.windows.size(); ++w) {
    const replay::Window& window = prepared.windows[w];
    const replay::LocalNumbers numbers(prepared, window);
    const replay::LocalValues local{.numbers = &numbers, .values = fitted.local_numbers[w]};
    const auto found = replay::simulate_window(model, window, local, internal);
    if (!found) return std::nullopt;
    motion.starts.push_back(motion.simulated.size());
    for (std::size_t i = window.range.first; i < window.range.last; ++i) {
      const double stamp = prepared.run->times[i];
      const double since = stamp - prepared.run->times[window.range.first];
      motion.simulated.push_back(
          found->at(stamp + numbers.clock_rate(local.values) * since + numbers.clock_offset(local.values)));
    }
    internal = motion.simulated.back().internal;
    append(replay::at_samples(window, *prepared.run), motion.input);
  }
  return motion;
}

// Those motions that are measured in the same way as most samples, either by the angles of all joints or by their sum:
// residual_torque() needs one way.
std::vector<MeasuredMotion> measured_alike(std::vector<MeasuredMotion> motions) {
  std::map<std::size_t, std::size_t> samples;  // by the number of measured series
  for (const MeasuredMotion& motion : motions) samples[motion.angles.size()] += motion.simulated.size();
  const auto most = std::ranges::max_element(samples, {}, [](const auto& each) { return each.second; });
  if (most == samples.end()) return motions;
  std::erase_if(motions, [&](const MeasuredMotion& motion) { return motion.angles.size() != most->first; });
  return motions;
}

}  // namespace

std::optional<ResidualTorque> localise(std::span<const replay::PreparedRun> runs,
                                       const identification::FittedHypothesis& fitted) {
  const actuator::ModelSpec spec = fitted.hypothesis.spec_at(fitted.fit.values);
  std::vector<actuator::Model> models;
  for (const replay::PreparedRun& run : runs) models.emplace_back(replay::on_changed_rig(spec, run.run->rig));
  std::vector<MeasuredMotion> motions;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    if (!runs[r].is_motion()) continue;
    if (auto motion = motion_of(runs[r], fitted.fit.runs[r], models[r])) motions.push_back(std::move(*motion));
  }
  motions = measured_alike(std::move(motions));
  if (motions.empty()) return std::nullopt;
  return residual_torque(motions);
}

}  // namespace coilwright::measurement::localise
