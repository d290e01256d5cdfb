#include "measurement/planning/candidate_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "coilwright/simulation/initial_state.hpp"
#include "measurement/planning/planned_motion.hpp"

namespace coilwright::measurement::planning {
namespace {

using actuator::Model;

constexpr double pi = std::numbers::pi;
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

// Cycles of 1 Hz between nothing and 0.3, 1 and 0.3 of the level, two each, in steps of a hundredth of a second.
TableShape small_large_small(double level) {
  TableShape out;
  for (int i = 0; i < 600; ++i) {
    const double time = 0.01 * i;
    const double size = time >= 2.0 && time < 4.0 ? 1.0 : 0.3;
    out.times.push_back(time);
    out.rows.push_back({1e-4 * std::round(1e4 * level * size * 0.5 * (1.0 - std::cos(2.0 * pi * time)))});
  }
  return out;
}

// Builds the menu: what all its runs have in common.
class Menu {
 public:
  Menu(const PlannedRun& like, double level, const Model& nominal, std::string prefix)
      : like_(like), level_(level), nominal_(nominal), prefix_(std::move(prefix)) {}

  std::vector<CandidateRun> all() {
    add_commands();
    add_changed_rigs();
    if (nominal_.coils() > 0) add_coils();
    return std::move(out_);
  }

 private:
  [[nodiscard]] std::string amount(double share) const {
    return fmt::format("{:.3g} {}", share * level_, unit_of_drive(like_.plan.drive));
  }
  [[nodiscard]] SineShape sine(double frequency) const {
    return {.amplitude = 0.5 * level_, .offset = 0.5 * level_, .frequency = frequency};
  }
  PlannedRun& add(const char* kind, std::string input, const char* why, InputShape shape, double duration,
                  const data::RigChange& rig = {}) {
    PlannedRun run = recorded_as(like_, std::move(shape), duration);
    run.plan.name = fmt::format("{}{}.csv", prefix_, kind);
    run.plan.rig = rig;
    out_.push_back({.kind = kind, .input = std::move(input), .why = why, .run = std::move(run)});
    return out_.back().run;
  }

  void add_commands() {
    add("step", fmt::format("0 to {} at once, 2 s", amount(1.0)), "a step shows stiffness, damping and creep apart",
        StepShape{.after = level_, .at = 0.1}, 2.0);
    add("small_step", fmt::format("0 to {} at once, 2 s", amount(0.25)),
        "a small step shows what does not grow with the amplitude", StepShape{.after = 0.25 * level_, .at = 0.1}, 2.0);
    add("slow_sine", fmt::format("{0} + {0} sin(2 pi t), 1 Hz, 4 s", amount(0.5)),
        "a slow cycle shows loops that do not depend on speed", sine(1.0), 4.0);
    add("fast_sine", fmt::format("{0} + {0} sin(2 pi 5 t), 5 Hz, 2 s", amount(0.5)),
        "near resonance phase and damping show", sine(5.0), 2.0);
    add("chirp", fmt::format("{0} + {0} sin, 0.5 to 20 Hz in 8 s", amount(0.5)),
        "all frequencies: a delay turns the phase in proportion, a lag bends it",
        ChirpShape{.amplitude = 0.5 * level_, .offset = 0.5 * level_, .from = 0.5, .to = 20.0}, 8.0);
    add("release", fmt::format("hold {} for 1 s, then 0 for 2 s", amount(1.0)),
        "the free decay shows how friction depends on amplitude", StepShape{.before = level_, .at = 1.0}, 3.0);
    TableShape hot{.times = {0.0, 0.1, 60.1}, .rows = {{0.0}, {level_}, {0.3 * level_}}};
    add("hot_hold", fmt::format("hold {} for 60 s, then {} for 20 s", amount(1.0), amount(0.3)),
        "heat grows with the square of the current and stays when it falls; creep follows the angle",
        per_joint(std::move(hot)), 80.0);
    add("small_large_small",
        fmt::format("1 Hz cycles: 2 to {}, 2 to {}, 2 to {}", amount(0.3), amount(1.0), amount(0.3)),
        "what remembers the largest angle differs between the two small cycles", per_joint(small_large_small(level_)),
        6.0);
    add("reversed_step", fmt::format("0 to -{} at once, 2 s", amount(0.5)),
        "what does not turn with the sign of the command stands out", StepShape{.after = -0.5 * level_, .at = 0.1},
        2.0);
  }

  void add_changed_rigs() {
    // At rest first: where gravity alone holds the finger its direction shows most.
    const StepShape half{.after = 0.5 * level_, .at = 0.5};
    add("turned_base", fmt::format("base turned by 90 deg, 0 for 0.5 s, then {} for 1.5 s", amount(0.5)),
        "gravity turns with the base, springs, sensors and magnets do not", half, 2.0, {.base_turn = 0.5 * pi});
    const double mass = two_digits(0.5 * nominal_.chain().links().back().mass);
    add("tip_mass", fmt::format("{:.2g} g hung at the tip, 0 for 0.5 s, then {} for 1.5 s", 1e3 * mass, amount(0.5)),
        "a known weight is the scale for forces and masses", half, 2.0, {.tip_mass = mass});
  }

  // Without a driver nobody bends the finger but a hand, which lets go where the clock of the camera says.
  void add_coils() {
    const data::RecordingClock& clock = like_.plan.clock;
    if (like_.input_rate > 0.0 || clock.offset_sigma > 0.0 || clock.exposure > 0.0) return;
    PlannedRun held = recorded_as(like_, StepShape{.before = level_, .after = level_}, 1.0);
    const simulation::ModelInput input = simulation::model_input(nominal_, with_inputs(held, nominal_).command());
    const auto pose = simulation::equilibrium_at_first_input(nominal_, input);
    if (!pose || pose->angles.cwiseAbs().sum() == 0.0) return;
    const auto let_go = [&](const char* kind, const char* circuit, data::CoilWiring wiring, const char* why) {
      constexpr double whole = pi / 180.0;  // by hand: to a degree
      PlannedRun& run = add(kind, "", why, StepShape{}, 2.0, {.coil = wiring});
      for (const double angle : pose->angles) run.start_angles.push_back(whole * std::round(angle / whole));
      run.plan.start = data::Start::free;
      std::string angles;
      for (const double angle : run.start_angles)
        angles += fmt::format("{}{:.0f}", angles.empty() ? "" : " and ", angle / whole);
      out_.back().input = fmt::format("coils {}, joints held at {} deg by hand and let go, 2 s", circuit, angles);
    };
    let_go("coil_open", "open", data::CoilWiring::open,
           "without a closed circuit neither driver nor induced current acts: what is left is not theirs");
    let_go("coil_shorted", "shorted", data::CoilWiring::shorted,
           "in a closed circuit without a driver motion is damped by induced currents alone");
  }

  // The rows of a table are for all coils, or one value for each joint.
  [[nodiscard]] TableShape per_joint(TableShape table) const {
    if (like_.plan.drive != data::Drive::torque && !like_.only) return table;
    const int width = like_.plan.drive == data::Drive::torque ? nominal_.joints() : nominal_.coils();
    for (std::vector<double>& row : table.rows) {
      std::vector<double> wide(static_cast<std::size_t>(width), like_.only ? 0.0 : row[0]);
      if (like_.only) wide.at(static_cast<std::size_t>(*like_.only)) = row[0];
      row = std::move(wide);
    }
    return table;
  }

  const PlannedRun& like_;
  double level_;
  const Model& nominal_;
  std::string prefix_;
  std::vector<CandidateRun> out_;
};

}  // namespace

std::vector<CandidateRun> candidate_runs(const Experiment& experiment, const Model& nominal,
                                         const std::string& prefix) {
  const auto like = std::ranges::find_if(experiment.runs, is_commanded_motion);
  if (like == experiment.runs.end()) return {};
  double level = 0.0;
  for (const PlannedRun& run : experiment.runs)
    if (run.plan.kind == data::RunKind::transient && run.plan.drive == like->plan.drive)
      level = std::max(level, std::visit(LargestLevel{}, run.input));
  if (level <= 0.0) return {};
  return Menu(*like, level, nominal, prefix).all();
}

}  // namespace coilwright::measurement::planning
