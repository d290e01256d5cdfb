#include "measurement/experiment/added_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace coilwright::measurement::experiment {
namespace {

// A long hold needs no fine samples.
constexpr double most_samples = 4000.0;

struct LargestLevel {
  double operator()(const StepShape& s) const { return std::max(std::abs(s.before), std::abs(s.after)); }
  double operator()(const SineShape& s) const { return std::abs(s.amplitude) + std::abs(s.offset); }
  double operator()(const ChirpShape& s) const { return std::abs(s.amplitude) + std::abs(s.offset); }
  double operator()(const HoldShape& s) const { return std::abs(s.level); }
  double operator()(const PulseShape& s) const { return std::max(std::abs(s.low), std::abs(s.high)); }
  double operator()(const TableShape& s) const {
    double out = 0.0;
    for (const std::vector<double>& row : s.rows)
      for (const double value : row) out = std::max(out, std::abs(value));
    return out;
  }
};

bool is_commanded_motion(const PlannedRun& run) {
  return run.plan.kind == data::RunKind::transient && !run.validate && run.plan.rig.coil == data::CoilWiring::driven;
}

// Recorded as `like` is, from rest, on the rig as it is.
PlannedRun recorded_as(const PlannedRun& like, InputShape input, double duration) {
  PlannedRun out = like;
  out.input = std::move(input);
  out.duration = duration;
  out.rate = std::min(like.rate, most_samples / duration);
  out.start_angles.clear();
  out.plan.start = data::Start::at_rest;
  out.plan.window.reset();
  out.plan.rig = {};
  return out;
}

double two_digits(double value) {
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
  return std::round(value / unit) * unit;
}

}  // namespace

std::vector<AddedRun> runs_to_add(const Experiment& experiment, const actuator::Model& nominal) {
  const auto like = std::ranges::find_if(experiment.runs, is_commanded_motion);
  if (like == experiment.runs.end()) return {};
  double level = 0.0;
  for (const PlannedRun& run : experiment.runs)
    if (run.plan.kind == data::RunKind::transient && run.plan.drive == like->plan.drive)
      level = std::max(level, std::visit(LargestLevel{}, run.input));
  if (level <= 0.0) return {};
  const char* unit = like->plan.drive == data::Drive::torque    ? "N m"
                     : like->plan.drive == data::Drive::voltage ? "V"
                                                                : "A";
  const auto amount = [&](double share) { return fmt::format("{:.3g} {}", share * level, unit); };
  std::vector<AddedRun> out;
  const auto add = [&](const char* kind, std::string input, const char* why, InputShape shape, double duration,
                       data::RigChange rig = {}) {
    PlannedRun run = recorded_as(*like, std::move(shape), duration);
    run.plan.name = fmt::format("added_{}.csv", kind);
    run.plan.rig = rig;
    out.push_back({.kind = kind, .input = std::move(input), .why = why, .run = std::move(run)});
  };
  const auto sine = [&](double frequency) {
    return SineShape{.amplitude = 0.5 * level, .offset = 0.5 * level, .frequency = frequency};
  };
  const StepShape half{.after = 0.5 * level, .at = 0.1};
  add("step", fmt::format("0 to {} at once, 2 s", amount(1.0)), "a step shows stiffness, damping and creep apart",
      StepShape{.after = level, .at = 0.1}, 2.0);
  add("small_step", fmt::format("0 to {} at once, 2 s", amount(0.25)),
      "a small step shows what does not grow with the amplitude", StepShape{.after = 0.25 * level, .at = 0.1}, 2.0);
  add("slow_sine", fmt::format("{0} + {0} sin(2 pi t), 1 Hz, 4 s", amount(0.5)),
      "a slow cycle shows loops that do not depend on speed", sine(1.0), 4.0);
  add("fast_sine", fmt::format("{0} + {0} sin(2 pi 5 t), 5 Hz, 2 s", amount(0.5)),
      "near resonance phase and damping show", sine(5.0), 2.0);
  add("chirp", fmt::format("{0} + {0} sin, 0.5 to 20 Hz in 8 s", amount(0.5)),
      "all frequencies: a delay turns the phase in proportion, a lag bends it",
      ChirpShape{.amplitude = 0.5 * level, .offset = 0.5 * level, .from = 0.5, .to = 20.0}, 8.0);
  add("release", fmt::format("hold {} for 1 s, then 0 for 2 s", amount(1.0)),
      "the free decay shows how friction depends on amplitude", StepShape{.before = level, .at = 1.0}, 3.0);
  add("hot_hold", fmt::format("hold {} for 60 s, then 0 for 20 s", amount(1.0)),
      "heat grows with the square of the current and stays when it falls; creep follows the angle",
      HoldShape{.level = level, .from = 0.0, .until = 60.0}, 80.0);
  add("reversed_step", fmt::format("0 to -{} at once, 2 s", amount(0.5)),
      "what does not turn with the current's sign stands out", StepShape{.after = -0.5 * level, .at = 0.1}, 2.0);
  add("turned_base", fmt::format("base turned by 90 deg, 0 to {} at once, 2 s", amount(0.5)),
      "gravity turns with the base, springs, sensors and magnets do not", half, 2.0,
      {.base_turn = 0.5 * std::numbers::pi});
  const double tip_mass = two_digits(0.5 * nominal.chain().links().back().mass);
  add("tip_mass", fmt::format("{:.2g} g hung at the tip, 0 to {} at once, 2 s", 1e3 * tip_mass, amount(0.5)),
      "a known weight is the scale for forces and masses", half, 2.0, {.tip_mass = tip_mass});
  return out;
}

}  // namespace coilwright::measurement::experiment
