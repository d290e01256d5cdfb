#include "measurement/first_poses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "coilwright/simulation/initial_state.hpp"
#include "coilwright/units/angle.hpp"
#include "measurement/fit/hypothesis.hpp"
#include "measurement/replay/rig_change.hpp"

namespace coilwright::measurement {
namespace {

constexpr double far = 5.0 / units::degrees_per_radian;
// Of the noise: nearer may be noise.
constexpr double most_deviations = 10.0;
// Of a bend that a current holds: so much may be a stiffness, or a torque, that is off.
constexpr double share_of_bend = 0.25;

// What an angle channel would show of a pose; nothing of another quantity.
std::optional<double> shown(const actuator::Model& model, const data::Channel& channel,
                            const simulation::State& state) {
  if (channel.kind == data::ChannelKind::bending_angle) return model.observed(state.angles.sum());
  if (channel.kind == data::ChannelKind::joint_angle) return model.observed(state.angles[channel.joint]);
  return std::nullopt;
}

// Of the first three the one nearest to what is expected: a picture that was misread is no pose, and the third may be
// of a finger that moves already.
double first_reading(const data::Channel& channel, double expected) {
  const auto first = std::span(channel.values).first(std::min<std::size_t>(3, channel.values.size()));
  return *std::ranges::min_element(first, {}, [&](double value) { return std::abs(value - expected); });
}

}  // namespace

std::optional<data::Warning> far_first_pose(std::span<const replay::PreparedRun> runs,
                                            const replay::DeclaredModel& declared) {
  const fit::Hypothesis as_declared(declared, {});
  std::set<std::string> right;  // channels that begin as straight as they should in a run
  std::vector<std::pair<std::string, data::Warning>> far_ones;
  for (const replay::PreparedRun& prepared : runs) {
    const data::Run& run = *prepared.run;
    if (!prepared.is_motion() || run.start != data::Start::at_rest) continue;
    const actuator::Model model(replay::on_changed_rig(as_declared.spec_at(as_declared.start()), run.rig));
    const auto rest = simulation::equilibrium_at_first_input(model, prepared.windows.front().input);
    if (!rest) continue;
    for (std::size_t c = 0; c < run.channels.size(); ++c) {
      const std::optional<double> expected = shown(model, run.channels[c], *rest);
      if (!expected) continue;
      const double seen = first_reading(run.channels[c], *expected);
      const double near = std::max(far, most_deviations * prepared.noise[c].sigma);
      const double off = std::abs(seen - *expected);
      if (off <= near && std::abs(*expected) <= near) right.insert(run.channels[c].name);
      if (off <= std::max(near, share_of_bend * std::abs(*expected))) continue;
      far_ones.emplace_back(
          run.channels[c].name,
          data::Warning{.run = run.name,
                        .text = fmt::format(
                            "{} begins at {:.3g} deg, where the declared model rests at {:.3g} deg. If the angle is "
                            "counted from its rest, add {:.3g} deg to the record: 0 is a straight finger. If "
                            "it is not, check the masses, lengths, magnets and gravity of the actuator file",
                            run.channels[c].name, units::degrees_per_radian * seen,
                            units::degrees_per_radian * *expected, units::degrees_per_radian * (*expected - seen))});
    }
  }
  // All runs have one zero: where one begins as straight as it should, another pose is no matter of the zero.
  const auto first = std::ranges::find_if(far_ones, [&](const auto& each) { return !right.contains(each.first); });
  return first == far_ones.end() ? std::nullopt : std::optional(first->second);
}

}  // namespace coilwright::measurement
