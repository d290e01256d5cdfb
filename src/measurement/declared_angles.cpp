#include "measurement/declared_angles.hpp"

#include <algorithm>
#include <cstddef>

#include "coilwright/simulation/initial_state.hpp"
#include "measurement/replay/prediction.hpp"
#include "measurement/replay/prepared_run.hpp"
#include "measurement/replay/rig_change.hpp"

namespace coilwright::measurement {

bool is_angle(const data::Channel& channel) {
  return channel.kind == data::ChannelKind::bending_angle || channel.kind == data::ChannelKind::joint_angle;
}

bool is_motion_of_angles(const data::Run& run) {
  return run.kind == data::RunKind::transient && run.start == data::Start::at_rest &&
         std::ranges::any_of(run.channels, is_angle);
}

std::optional<std::vector<DeclaredAngle>> declared_angles(const data::Run& run, const replay::DeclaredModel& declared,
                                                          const fit::Hypothesis& as_declared) {
  const actuator::ModelSpec spec = as_declared.spec_at(as_declared.start());
  const replay::PreparedRun prepared = replay::prepare_run(run, declared, actuator::Model(spec));
  const actuator::Model model(replay::on_changed_rig(spec, run.rig));
  const replay::Window& window = prepared.windows.front();
  const auto rest = simulation::equilibrium_at_first_input(model, window.input);
  if (!rest) return std::nullopt;
  const auto predicted = replay::predict_window(model, prepared, window, *rest);
  if (!predicted) return std::nullopt;
  const Eigen::VectorXd measured = replay::measured_values(run, window.range);
  const auto samples = static_cast<Eigen::Index>(window.samples());
  std::vector<DeclaredAngle> out;
  for (std::size_t c = 0; c < run.channels.size(); ++c) {
    if (!is_angle(run.channels[c])) continue;
    const auto of_channel = [&](const Eigen::VectorXd& values) {
      const auto part = values.segment(static_cast<Eigen::Index>(c) * samples, samples);
      return std::vector<double>(part.begin(), part.end());
    };
    out.push_back(
        {.channel = &run.channels[c], .measured = of_channel(measured), .declared = of_channel(predicted->values)});
  }
  return out;
}

}  // namespace coilwright::measurement
