#include "measurement/experiment/separating_experiment.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "coilwright/simulation/initial_state.hpp"
#include "measurement/replay/prediction.hpp"

namespace coilwright::measurement::experiment {
namespace {

using actuator::Model;
using actuator::ModelSpec;
using mechanics::JointVector;

constexpr double pi = std::numbers::pi;
constexpr double least_separation = 0.5;
// A torque bench is taken to be good for a hundredth of its largest reading.
constexpr double bench_accuracy = 0.01;

// How the rig is driven: at most so hard as in the records.
struct Rig {
  bool coils{};
  double amplitude{};  // A, or N m at the first joint
  double interval{};   // s
  double sigma{};      // rad
  std::string unit{};
};

// A run that could be made: what is commanded (1 is the rig's amplitude) and what else is changed.
struct Proposal {
  std::string kind;
  std::string input;
  std::string why;
  double duration{};
  std::function<double(double)> command{};           // of time, s
  std::function<void(ModelSpec&)> change = nullptr;  // of the rig
};

std::vector<Proposal> menu(const Rig& rig) {
  const auto amount = [&](double share) { return fmt::format("{:.3g} {}", share * rig.amplitude, rig.unit); };
  const auto sine = [](double frequency) {
    return [frequency](double t) { return 0.5 + 0.5 * std::sin(2.0 * pi * frequency * t); };
  };
  std::vector<Proposal> out{
      {.kind = "step",
       .input = fmt::format("0 to {} at once, 2 s", amount(1.0)),
       .why = "a step shows stiffness, damping and creep apart",
       .duration = 2.0,
       .command = [](double t) { return t < 0.1 ? 0.0 : 1.0; }},
      {.kind = "step",
       .input = fmt::format("0 to {} at once, 2 s", amount(0.25)),
       .why = "a small step shows what does not grow with the amplitude",
       .duration = 2.0,
       .command = [](double t) { return t < 0.1 ? 0.0 : 0.25; }},
      {.kind = "sine",
       .input = fmt::format("{0} + {0} sin(2 pi t), 1 Hz, 4 s", amount(0.5)),
       .why = "a slow cycle shows loops that do not depend on speed",
       .duration = 4.0,
       .command = sine(1.0)},
      {.kind = "sine",
       .input = fmt::format("{0} + {0} sin(2 pi 5 t), 5 Hz, 2 s", amount(0.5)),
       .why = "near resonance phase and damping show",
       .duration = 2.0,
       .command = sine(5.0)},
      {.kind = "chirp",
       .input = fmt::format("{0} + {0} sin, 0.5 to 20 Hz in 8 s", amount(0.5)),
       .why = "all frequencies: a delay turns the phase in proportion, a lag bends it",
       .duration = 8.0,
       .command = [](double t) { return 0.5 + 0.5 * std::sin(2.0 * pi * (0.5 * t + 19.5 / 16.0 * t * t)); }},
      {.kind = "release",
       .input = fmt::format("hold {} for 1 s, then 0 for 2 s", amount(1.0)),
       .why = "the free decay shows how friction depends on amplitude",
       .duration = 3.0,
       .command = [](double t) { return t < 1.0 ? 1.0 : 0.0; }},
      {.kind = "hot_hold",
       .input = fmt::format("hold {} for 60 s, then {} for 20 s", amount(1.0), amount(0.3)),
       .why = "heat grows with the square of the current and stays when it falls; creep follows the angle",
       .duration = 80.0,
       .command = [](double t) { return t < 60.0 ? 1.0 : 0.3; }},
      {.kind = "small_large_small",
       .input = fmt::format("1 Hz cycles: 2 to {}, 2 to {}, 2 to {}", amount(0.3), amount(1.0), amount(0.3)),
       .why = "what remembers the largest angle differs between the two small cycles",
       .duration = 6.0,
       .command =
           [](double t) {
             const double size = t >= 2.0 && t < 4.0 ? 1.0 : 0.3;
             return size * 0.5 * (1.0 - std::cos(2.0 * pi * t));
           }},
      {.kind = "reversed_current",
       .input = fmt::format("0 to -{} at once, 2 s", amount(0.5)),
       .why = "what does not turn with the current's sign stands out",
       .duration = 2.0,
       .command = [](double t) { return t < 0.1 ? 0.0 : -0.5; }},
      {.kind = "turned_base",
       .input = fmt::format("base turned by 90 deg towards opening, 0 to {}, 2 s", amount(0.5)),
       .why = "gravity turns with the base, springs, sensors and magnets do not",
       .duration = 2.0,
       .command = [](double t) { return t < 0.5 ? 0.0 : 0.5; },
       .change =
           [](ModelSpec& spec) {
             spec.chain = spec.chain.under_gravity(spec.chain.gravity(), spec.chain.base_tilt() + 0.5 * pi);
           }},
  };
  if (rig.coils)
    out.push_back({.kind = "coil_open",
                   .input = fmt::format("hold {} for 1 s, then open the circuit for 2 s", amount(1.0)),
                   .why = "without a closed circuit neither driver nor induced current acts: what changes is theirs",
                   .duration = 3.0,
                   .command = [](double t) { return t < 1.0 ? 1.0 : 0.0; },
                   .change =
                       [](ModelSpec& spec) {
                         std::erase_if(spec.effects, [](const actuator::Effect& effect) {
                           return effect.kind->needs_closed_circuit();
                         });
                       }});
  return out;
}

replay::Window window_of(const Proposal& proposal, const Rig& rig, const Model& model) {
  replay::Window window;
  // Long holds need no fine samples.
  const double interval = std::max(rig.interval, proposal.duration / 8000.0);
  const auto samples = static_cast<std::size_t>(proposal.duration / interval) + 1;
  window.last = samples;
  simulation::CommandedInput command{.drive = rig.coils ? data::Drive::current : data::Drive::torque};
  for (std::size_t i = 0; i < samples; ++i) {
    const double t = static_cast<double>(i) * interval;
    command.times.push_back(t);
    std::vector<double>& row = command.rows.emplace_back(rig.coils ? 1 : model.joints(), 0.0);
    row[0] = rig.amplitude * proposal.command(t);
  }
  window.input = simulation::model_input(model, command);
  return window;
}

std::optional<Eigen::VectorXd> predicted(const Proposal& proposal, const Rig& rig, const compare::Scored& s) {
  ModelSpec spec = s.hypothesis.spec_at(s.fit.values);
  if (proposal.change) proposal.change(spec);
  const Model model(std::move(spec));
  const data::Run camera{.kind = data::RunKind::transient,
                         .channels = {{.name = "bending_angle_deg", .quantity = data::Quantity::bending_angle}}};
  const replay::Record record{.run = &camera};
  const replay::Window window = window_of(proposal, rig, model);
  const auto start = simulation::equilibrium_at_first_input(model, window.input);
  if (!start) return std::nullopt;
  auto out = replay::predict_window(model, record, window, *start);
  if (!out) return std::nullopt;
  return Eigen::VectorXd(out->values / rig.sigma);
}

// Torque of the first joint over its angle at full and half current, and its spring alone, over the bench's accuracy.
std::optional<Eigen::VectorXd> bench_torques(const Rig& rig, const compare::Scored& s) {
  const Model model = s.hypothesis.model_at(s.fit.values);
  std::vector<double> values;
  for (int i = 0; i <= 16; ++i) {
    JointVector angles = JointVector::Zero(model.joints());
    angles[0] = i * 5.0 * pi / 180.0;
    if (rig.coils) values.push_back(model.magnetic_torques(angles, model.all_coils(rig.amplitude))[0]);
    values.push_back(model.hinge_torques(angles)[0]);
  }
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

// The smallest rms difference between any two.
double separation(const std::vector<std::optional<Eigen::VectorXd>>& predictions) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t a = 0; a < predictions.size(); ++a) {
    for (std::size_t b = a + 1; b < predictions.size(); ++b) {
      if (!predictions[a] || !predictions[b]) return 0.0;
      const Eigen::VectorXd difference = *predictions[a] - *predictions[b];
      least = std::min(least, std::sqrt(difference.squaredNorm() / static_cast<double>(difference.size())));
    }
  }
  return std::isfinite(least) ? least : 0.0;
}

Rig rig_of(std::span<const replay::Record> records, const Model& model) {
  Rig rig{.coils = false, .interval = 0.002};
  double current = 0.0;
  double torque = 0.0;
  for (const replay::Record& record : records) {
    for (const replay::Window& window : record.windows) {
      for (const auto& currents : window.input.currents)
        if (currents.size() > 0) current = std::max(current, currents.lpNorm<Eigen::Infinity>());
      for (const auto& torques : window.input.joint_torques)
        torque = std::max(torque, torques.lpNorm<Eigen::Infinity>());
    }
    if (!record.is_motion()) continue;
    const std::vector<double>& times = record.run->times;
    rig.interval = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
    for (std::size_t c = 0; c < record.noise.size() && rig.sigma == 0.0; ++c)
      if (record.run->channels[c].quantity != data::Quantity::joint_rate) rig.sigma = record.noise[c].sigma;
  }
  rig.coils = model.coils() > 0 && current > 0.0;
  rig.amplitude = rig.coils ? current : torque;
  rig.unit = rig.coils ? "A" : "N m at joint 1";
  return rig;
}

}  // namespace

std::optional<NextExperiment> next_experiment(std::span<const replay::Record> records,
                                              const compare::Attribution& attribution) {
  if (attribution.rivals.empty()) return std::nullopt;
  std::vector<const compare::Scored*> rivals{&attribution.after()};
  for (const compare::Scored& rival : attribution.rivals) rivals.push_back(&rival);
  const compare::Scored& after = attribution.after();
  const Model model = after.hypothesis.model_at(after.fit.values);
  const Rig rig = rig_of(records, model);
  if (rig.amplitude <= 0.0 || rig.sigma <= 0.0) return std::nullopt;

  const std::vector<Proposal> proposals = menu(rig);
  std::vector<double> separations(proposals.size() + 1);
  tbb::parallel_for(std::size_t{0}, separations.size(), [&](std::size_t i) {
    std::vector<std::optional<Eigen::VectorXd>> predictions;
    double scale = 1.0;
    for (const compare::Scored* rival : rivals) {
      predictions.push_back(i < proposals.size() ? predicted(proposals[i], rig, *rival) : bench_torques(rig, *rival));
      if (i == proposals.size())
        scale = std::max(bench_accuracy * predictions.front()->lpNorm<Eigen::Infinity>(), 1e-12);
    }
    separations[i] = separation(predictions) / scale;
  });
  const auto best = std::ranges::max_element(separations);
  if (*best < least_separation) return std::nullopt;
  const auto i = static_cast<std::size_t>(best - separations.begin());
  if (i == proposals.size())
    return NextExperiment{.kind = "bench_torque",
                          .input = "torque of the first joint over 0 to 80 deg, with the largest current and without",
                          .why = "magnets and springs are measured apart, at rest",
                          .separation = *best};
  return NextExperiment{
      .kind = proposals[i].kind, .input = proposals[i].input, .why = proposals[i].why, .separation = *best};
}

}  // namespace coilwright::measurement::experiment
