#include "measurement/declared_readings.hpp"

#include <algorithm>
#include <cstddef>

#include "coilwright/simulation/initial_state.hpp"
#include "measurement/replay/prediction.hpp"
#include "measurement/replay/prepared_run.hpp"
#include "measurement/replay/rig_change.hpp"

namespace coilwright::measurement {
namespace {

// Of the samples in `range`, channel after channel; nothing where the model has no answer.
std::optional<Eigen::VectorXd> declared_values(const replay::PreparedRun& prepared, const actuator::Model& model,
                                               const replay::DeclaredModel& declared) {
  if (!prepared.is_motion()) return replay::predict_bench(model, prepared, declared);
  const replay::Window& window = prepared.windows.front();
  const auto rest = simulation::equilibrium_at_first_input(model, window.input);
  if (!rest) return std::nullopt;
  auto predicted = replay::predict_window(model, prepared, window, *rest);
  return predicted ? std::optional(std::move(predicted->values)) : std::nullopt;
}

}  // namespace

bool is_angle(const data::Channel& channel) {
  return channel.kind == data::ChannelKind::bending_angle || channel.kind == data::ChannelKind::joint_angle;
}

bool is_motion_of_angles(const data::Run& run) {
  return run.kind == data::RunKind::transient && run.start == data::Start::at_rest &&
         std::ranges::any_of(run.channels, is_angle);
}

std::optional<std::vector<DeclaredReadings>> declared_readings(const data::Run& run,
                                                               const replay::DeclaredModel& declared,
                                                               const fit::Hypothesis& as_declared) {
  const actuator::ModelSpec spec = as_declared.spec_at(as_declared.start());
  const replay::PreparedRun prepared = replay::prepare_run(run, declared, actuator::Model(spec));
  const actuator::Model model(replay::on_changed_rig(spec, run.rig));
  const auto values = declared_values(prepared, model, declared);
  if (!values) return std::nullopt;
  const replay::SampleRange range = prepared.sample_ranges().front();
  const auto samples = static_cast<Eigen::Index>(range.samples());
  std::vector<DeclaredReadings> out;
  for (std::size_t c = 0; c < run.channels.size(); ++c) {
    const std::vector<double>& measured = run.channels[c].values;
    const auto of_channel = values->segment(static_cast<Eigen::Index>(c) * samples, samples);
    out.push_back({.channel = &run.channels[c],
                   .measured = {measured.begin() + static_cast<std::ptrdiff_t>(range.first),
                                measured.begin() + static_cast<std::ptrdiff_t>(range.last)},
                   .declared = {of_channel.begin(), of_channel.end()}});
  }
  return out;
}

}  // namespace coilwright::measurement
