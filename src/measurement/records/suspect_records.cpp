#include "measurement/records/suspect_records.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <utility>

#include "coilwright/measurement/signals/noise_level.hpp"
#include "coilwright/simulation/initial_state.hpp"
#include "coilwright/units/angle.hpp"
#include "measurement/data/equal_stretches.hpp"
#include "measurement/fit/hypothesis.hpp"
#include "measurement/records/declared_readings.hpp"
#include "measurement/replay/if_possible.hpp"
#include "measurement/replay/prediction.hpp"
#include "measurement/replay/rig_change.hpp"

namespace coilwright::measurement::records {
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

constexpr std::size_t fewest = 10;  // samples of a stall
// At three resolutions one neighbour in ten is alike by chance, ten in a row never.
constexpr double least_noise = 3.0;  // resolutions

// Stretches in which nothing but a standing picture keeps a reading.
std::vector<data::EqualStretch> long_stretches(const std::vector<double>& values) {
  std::vector<data::EqualStretch> out = data::equal_stretches(values);
  std::erase_if(out, [](const data::EqualStretch& each) { return each.size < fewest; });
  return out;
}

// The noise of what lies outside of them, which has no noise itself.
signals::NoiseLevel noise_without(const data::Run& run, const data::Channel& channel,
                                  const std::vector<data::EqualStretch>& left) {
  data::Run rest{.name = run.name, .kind = run.kind};
  data::Channel values{.name = channel.name, .kind = channel.kind};
  auto next = left.begin();
  for (std::size_t i = 0; i < run.times.size(); ++i) {
    if (next != left.end() && i == next->end()) ++next;
    if (next != left.end() && i >= next->first) continue;
    rest.times.push_back(run.times[i]);
    values.values.push_back(channel.values[i]);
  }
  return values.values.empty() ? signals::NoiseLevel{} : signals::noise_of(rest, values);
}

constexpr double hardly = 0.05;                                   // of the declared model's motion
constexpr double least_motion = 1.0 / units::degrees_per_radian;  // less shows nothing

// What most readings stay within; a tenth of them may be outliers on either side.
double extent(std::vector<double> values) {
  const auto at = [&](double share) {
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::ranges::nth_element(values, place);
    return *place;
  };
  return at(0.9) - at(0.1);
}

// That a finger falls back to its pose without current and stays there while the declared model is bent.
struct DeadPart {
  std::size_t first{}, last{};  // samples
  double declared{};            // largest bend there, rad
};

// Of one angle that once moved: what a late camera shows, or a driver that is switched on late, is none. `unpowered` is
// what the model shows without current.
std::optional<DeadPart> dead_part(const DeclaredReadings& angle, double unpowered) {
  constexpr double at_rest = 0.1;  // of the largest bend
  constexpr double bent = 0.5;
  constexpr double moved = 0.25;
  constexpr double least_share = 0.1;  // of the run, in which it should be bent
  const auto bend = [&](std::size_t i) { return std::abs(angle.declared[i] - unpowered); };
  double most = 0.0;
  for (std::size_t i = 0; i < angle.declared.size(); ++i) most = std::max(most, bend(i));
  // Where the run begins without current, so does the record: its zero may be off.
  const double rest = bend(0) <= at_rest * most ? first_reading(*angle.channel, angle.declared.front()) : unpowered;
  const auto least = std::max<double>(2.0 * fewest, least_share * static_cast<double>(angle.measured.size()));
  bool has_moved = false;
  for (std::size_t i = 0; most >= least_motion && i < angle.measured.size(); ++i) {
    const auto away = [&](std::size_t k) { return std::abs(angle.measured[k] - rest); };
    has_moved = has_moved || away(i) > moved * most;
    DeadPart part{.first = i, .last = i};
    std::size_t bent_samples = 0;
    for (; i < angle.measured.size() && away(i) <= at_rest * most; ++i) {
      part.last = i;
      part.declared = std::max(part.declared, bend(i));
      if (bend(i) >= bent * most) ++bent_samples;
    }
    if (has_moved && static_cast<double>(bent_samples) >= least) return part;
  }
  return std::nullopt;
}

// An angle that hardly moves in the whole run.
std::optional<data::Warning> dead_throughout(const data::Run& run, const DeclaredReadings& angle) {
  const double seen = extent(angle.measured);
  const double expected = extent(angle.declared);
  if (expected < least_motion || seen > hardly * expected) return std::nullopt;
  return data::Warning{
      .run = run.name,
      .text =
          fmt::format("{} keeps within {:.2g} deg where the declared model moves by {:.2g} deg: a coil, a wire, the "
                      "driver or the camera may have been off. If so, leave the run out: a fit would explain it by "
                      "effects that are not there. If the current did flow, something holds the finger",
                      angle.channel->name, units::degrees_per_radian * seen, units::degrees_per_radian * expected)};
}

std::optional<data::Warning> dead_in_part(const data::Run& run, const DeclaredReadings& angle,
                                          const actuator::Model& model) {
  const auto straight = mechanics::JointVector::Zero(model.joints());
  const auto unpowered = simulation::state_at_rest(model, model.all_coils(0.0), straight);
  const auto pose = unpowered ? shown(model, *angle.channel, *unpowered) : std::nullopt;
  const auto part = pose ? dead_part(angle, *pose) : std::nullopt;
  if (!part) return std::nullopt;
  return data::Warning{
      .run = run.name,
      .text = fmt::format("from {:.6g} to {:.6g} s {} stays where the finger rests without current, and the declared "
                          "model is bent by up to {:.2g} deg there: a coil, a wire, the driver or the camera may have "
                          "been off. If so, end the record before that: a fit would explain it by effects that are "
                          "not there. If the current did flow, something holds the finger",
                          run.times[part->first], run.times[part->last], angle.channel->name,
                          units::degrees_per_radian * part->declared)};
}

}  // namespace

std::optional<data::Warning> initial_pose_mismatch(std::span<const replay::PreparedRun> runs,
                                                   const replay::DeclaredModel& declared) {
  const fit::Hypothesis as_declared(declared, {});
  std::set<std::string> right;  // channels that begin as straight as they should in a run
  std::vector<std::pair<std::string, data::Warning>> far_ones;
  for (const replay::PreparedRun& prepared : runs) {
    const data::Run& run = *prepared.run;
    if (!prepared.is_motion() || run.start != data::Start::at_rest) continue;
    const actuator::Model model(replay::on_changed_rig(as_declared.spec_at(as_declared.start()), run.rig));
    const replay::Window& window = prepared.windows.front();
    const auto rest = simulation::equilibrium_at_first_input(model, window.input);
    if (!rest) continue;
    const auto motion = replay::predict_window(model, prepared, window, *rest);
    for (std::size_t c = 0; c < run.channels.size(); ++c) {
      const std::optional<double> expected = shown(model, run.channels[c], *rest);
      if (!expected) continue;
      const double seen = first_reading(run.channels[c], *expected);
      const double near = std::max(far, most_deviations * prepared.noise[c].sigma);
      // An input that began before the first sample may have moved the finger by then.
      const auto first = static_cast<Eigen::Index>(c * window.samples());
      if (motion && std::abs(motion->values[first] - *expected) > near) continue;
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

std::optional<data::Warning> stalled_frames(const data::Run& run) {
  if (run.kind != data::RunKind::transient) return std::nullopt;
  for (const data::Channel& channel : run.channels) {
    const std::vector<data::EqualStretch> stretches = long_stretches(channel.values);
    if (stretches.empty() || channel.values.size() != run.times.size()) continue;
    const signals::NoiseLevel level = noise_without(run, channel, stretches);
    if (level.resolution <= 0.0 || level.sigma < least_noise * level.resolution) continue;
    const auto [least, most] = std::ranges::minmax(channel.values);
    data::EqualStretch longest;
    for (const data::EqualStretch& each : stretches) {
      const double value = channel.values[each.first];
      if (value != least && value != most && each.size > longest.size) longest = each;
    }
    if (longest.size == 0) continue;
    return data::Warning{
        .run = run.name,
        .text = fmt::format("{} is exactly the same in {} samples from {:.6g} s on, where its noise would show: the "
                            "camera or the tracker stopped there. Leave them out of the record: they look like a "
                            "finger that sticks",
                            channel.name, longest.size, run.times[longest.first])};
  }
  return std::nullopt;
}

std::vector<data::Warning> unanswered_runs(std::span<const data::Run> runs, const replay::DeclaredModel& declared) {
  const fit::Hypothesis as_declared(declared, {});
  std::vector<data::Warning> out;
  for (const data::Run& run : runs) {
    if (!is_motion_of_angles(run)) continue;
    using Readings = std::vector<DeclaredReadings>;
    const auto readings = replay::if_possible<Readings>([&] { return declared_readings(run, declared, as_declared); });
    if (!readings) continue;
    const actuator::Model model(replay::on_changed_rig(as_declared.spec_at(as_declared.start()), run.rig));
    for (const DeclaredReadings& angle : *readings) {
      if (!is_angle(*angle.channel)) continue;
      auto warning = dead_throughout(run, angle);
      if (!warning) warning = dead_in_part(run, angle, model);
      if (!warning) continue;
      out.push_back(std::move(*warning));
      break;
    }
  }
  return out;
}

}  // namespace coilwright::measurement::records
