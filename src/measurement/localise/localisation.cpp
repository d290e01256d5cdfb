#include "measurement/localise/localisation.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "coilwright/simulation/initial_state.hpp"
#include "measurement/replay/prediction.hpp"

namespace coilwright::measurement::localise {
namespace {

using simulation::State;

// Measured angles of `quantity` over the windows of a record, as the model's joints have them: what the camera adds is
// taken off. A delay is left in: it is no torque, and shows as one that goes with the rate.
void add_angles(const replay::Record& record, data::Quantity quantity, const actuator::Model& model,
                MeasuredMotion& motion) {
  // Offset and scale are a straight line.
  const double offset = model.observed(0.0);
  const double scale = model.observed(1.0) - offset;
  for (std::size_t c = 0; c < record.run->channels.size(); ++c) {
    const data::Channel& channel = record.run->channels[c];
    if (channel.quantity != quantity) continue;
    std::vector<double> values;
    for (const replay::Window& window : record.windows)
      for (std::size_t i = window.first; i < window.last; ++i) values.push_back((channel.values[i] - offset) / scale);
    motion.angles.push_back(std::move(values));
    motion.sigma.push_back(record.noise[c].sigma / scale);
  }
}

void append(const simulation::ModelInput& more, simulation::ModelInput& all) {
  all.times.insert(all.times.end(), more.times.begin(), more.times.end());
  all.currents.insert(all.currents.end(), more.currents.begin(), more.currents.end());
  all.joint_torques.insert(all.joint_torques.end(), more.joint_torques.begin(), more.joint_torques.end());
}

// The model's own motion, window by window, from the starts that the fit found.
bool simulate_windows(const replay::Record& record, const fit::RunFit& fitted, const actuator::Model& model,
                      MeasuredMotion& motion) {
  motion.starts.clear();
  Eigen::VectorXd internal;
  for (std::size_t w = 0; w < record.windows.size(); ++w) {
    const replay::Window& window = record.windows[w];
    std::optional<State> start =
        record.has_nuisances() ? fitted.starts[w] : simulation::equilibrium_at_first_input(model, window.input);
    if (!start) return false;
    start->internal = internal;
    std::optional<replay::WindowPrediction> predicted = replay::predict_window(model, record, window, *start);
    if (!predicted) return false;
    if (record.has_nuisances()) internal = predicted->states.back().internal;
    motion.starts.push_back(motion.simulated.size());
    motion.simulated.insert(motion.simulated.end(), predicted->states.begin(), predicted->states.end());
    append(window.input, motion.input);
  }
  return true;
}

// A residual torque is taken either of every joint or of their sum: of what most samples were measured by.
void keep_alike(std::vector<MeasuredMotion>& motions) {
  std::map<std::size_t, std::size_t> samples;
  for (const MeasuredMotion& motion : motions) samples[motion.angles.size()] += motion.simulated.size();
  const auto most = std::ranges::max_element(samples, {}, [](const auto& one) { return one.second; });
  if (most == samples.end()) return;
  std::erase_if(motions, [&](const MeasuredMotion& motion) { return motion.angles.size() != most->first; });
}

}  // namespace

std::optional<ResidualTorque> localise(std::span<const replay::Record> records, const compare::Scored& fitted) {
  const actuator::Model model = fitted.hypothesis.model_at(fitted.fit.values);
  std::vector<MeasuredMotion> motions;
  for (std::size_t r = 0; r < records.size(); ++r) {
    if (!records[r].is_motion()) continue;
    MeasuredMotion& motion = motions.emplace_back();
    motion.run = records[r].run->name;
    add_angles(records[r], data::Quantity::joint_angle, model, motion);
    if (motion.angles.size() != static_cast<std::size_t>(model.joints())) {
      motion.angles.clear();
      motion.sigma.clear();
      add_angles(records[r], data::Quantity::bending_angle, model, motion);
    }
    if (motion.angles.empty() || !simulate_windows(records[r], fitted.fit.runs[r], model, motion)) motions.pop_back();
  }
  keep_alike(motions);
  if (motions.empty()) return std::nullopt;
  return residual_torque(motions, model);
}

}  // namespace coilwright::measurement::localise
