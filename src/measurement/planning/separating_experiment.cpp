#include "measurement/planning/separating_experiment.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "measurement/planning/candidate_runs.hpp"
#include "measurement/planning/planned_motion.hpp"
#include "measurement/planning/recorded_experiment.hpp"
#include "measurement/replay/rig_change.hpp"

namespace coilwright::measurement::planning {
namespace {

using actuator::Model;
using mechanics::JointVector;

// A run that separates hypotheses by less than half the noise is not proposed.
constexpr double least_separation = 0.5;
// The accuracy of a torque bench, as a fraction of its largest reading.
constexpr double bench_accuracy = 0.01;
constexpr double half_turn = std::numbers::pi;

using Prediction = std::optional<Eigen::VectorXd>;

// A run with its times, and what perfect instruments show of it: channel after channel, SI.
struct Seen {
  data::Run run;
  Eigen::VectorXd values;
};

// As one hypothesis has it. Clocks and shutter would blur all hypotheses alike. Nothing if it cannot be simulated.
std::optional<Seen> seen_by(const identification::FittedHypothesis& fitted, const PlannedRun& planned) {
  PlannedRun run = planned;
  run.plan.clock = {};
  run.plan.hold = {};
  run.input_rate = 0.0;
  try {
    const Model model(replay::on_changed_rig(fitted.hypothesis.spec_at(fitted.fit.values), run.plan.rig));
    data::Run seen = with_inputs(run, model);
    Eigen::VectorXd values = true_values(run, seen, {}, fitted.hypothesis.declared(), model);
    return Seen{.run = std::move(seen), .values = std::move(values)};
  } catch (const std::runtime_error&) {
    return std::nullopt;
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

// The same over the noise of each instrument.
Prediction predicted_motion(const PlannedRun& candidate, const Instruments& instruments,
                            const identification::FittedHypothesis& fitted) {
  std::optional<Seen> seen = seen_by(fitted, candidate);
  if (!seen) return std::nullopt;
  const auto samples = static_cast<Eigen::Index>(seen->run.samples());
  for (std::size_t c = 0; c < seen->run.channels.size(); ++c) {
    const double noise = instruments.of(seen->run.channels[c].kind).noise;
    seen->values.segment(static_cast<Eigen::Index>(c) * samples, samples) *= noise > 0.0 ? 1.0 / noise : 0.0;
  }
  return std::move(seen->values);
}

// Torque of the first joint over its angle, N m: with the largest current, if coils drive the rig, and without.
Eigen::VectorXd bench_torques(double current, const identification::FittedHypothesis& fitted) {
  const Model model = fitted.hypothesis.model_at(fitted.fit.values);
  std::vector<double> values;
  for (int i = 0; i <= 16; ++i) {
    JointVector angles = JointVector::Zero(model.joints());
    angles[0] = i * 5.0 * half_turn / 180.0;
    if (current > 0.0) values.push_back(model.magnetic_torques(angles, model.all_coils(current))[0]);
    values.push_back(model.hinge_torques(angles)[0]);
  }
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

// The smallest rms difference between any two predictions; 0 if one is missing.
double separation(const std::vector<Prediction>& predictions) {
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

using Rivals = std::vector<const identification::FittedHypothesis*>;

bool depends_on_circuit(const identification::FittedHypothesis* rival) {
  return std::ranges::any_of(rival->kinds(),
                             [](const actuator::EffectKind* kind) { return kind->needs_closed_circuit(); });
}

// How far a candidate separates the rivals, over the noise.
double motion_separation(const PlannedRun& candidate, const Instruments& instruments, const Rivals& rivals) {
  std::vector<Prediction> predictions;
  for (const identification::FittedHypothesis* rival : rivals)
    predictions.push_back(predicted_motion(candidate, instruments, *rival));
  return separation(predictions);
}

double accuracy_of_bench(double current, const identification::FittedHypothesis& fitted) {
  return std::max(bench_accuracy * bench_torques(current, fitted).lpNorm<Eigen::Infinity>(), 1e-12);
}

// How far a torque bench separates the rivals, over its accuracy.
double bench_separation(double current, const Rivals& rivals) {
  std::vector<Prediction> predictions;
  for (const identification::FittedHypothesis* rival : rivals) predictions.emplace_back(bench_torques(current, *rival));
  return separation(predictions) / accuracy_of_bench(current, *rivals.front());
}

// The largest current of any coil; 0 where no coil is driven.
double largest_current(std::span<const replay::PreparedRun> runs) {
  double current = 0.0;
  for (const replay::PreparedRun& prepared : runs)
    for (const replay::Window& window : prepared.windows)
      for (const auto& currents : window.input.currents)
        if (currents.size() > 0) current = std::max(current, currents.lpNorm<Eigen::Infinity>());
  return current;
}

// The two runs of a torque bench: with the largest current, and what the hinge does without.
std::vector<PlannedRun> bench_runs(double current) {
  data::Run stiffness{.name = "next_stiffness.csv", .kind = data::RunKind::joint_stiffness};
  data::Run torque{.name = "next_torque.csv", .kind = data::RunKind::static_torque};
  for (int i = 0; i <= 16; ++i) {
    const double angle = i * 5.0 * half_turn / 180.0;
    stiffness.angles.push_back(angle);
    torque.angles.push_back(angle);
    torque.inputs.push_back({current});
  }
  stiffness.channels = torque.channels = {{.name = "torque_Nmm", .kind = data::ChannelKind::torque}};
  std::vector<PlannedRun> out;
  if (current > 0.0) out.push_back({.plan = std::move(torque)});
  out.push_back({.plan = std::move(stiffness)});
  return out;
}

std::vector<std::string> ids_of(const identification::FittedHypothesis& hypothesis) {
  std::vector<std::string> ids;
  for (const actuator::EffectKind* kind : hypothesis.kinds()) ids.emplace_back(kind->id());
  return ids;
}

// What the rivals expect of each channel of the proposed runs; nothing where one of them cannot be simulated in them.
std::vector<ExpectedReading> expected_readings(const std::vector<PlannedRun>& proposed, const Instruments& instruments,
                                               const Rivals& rivals) {
  std::vector<ExpectedReading> out;
  for (const PlannedRun& planned : proposed) {
    const std::size_t first = out.size();
    for (const identification::FittedHypothesis* rival : rivals) {
      const std::optional<Seen> seen = seen_by(*rival, planned);
      if (!seen) return {};
      const auto samples = static_cast<Eigen::Index>(seen->run.samples());
      for (std::size_t c = 0; c < seen->run.channels.size(); ++c) {
        const data::Channel& channel = seen->run.channels[c];
        if (rival == rivals.front())
          out.push_back({.run = planned.plan.name,
                         .channel = channel.name,
                         .kind = channel.kind,
                         .noise = instruments.of(channel.kind).noise,
                         .at = seen->run.times.empty() ? seen->run.angles : seen->run.times});
        const auto values = seen->values.segment(static_cast<Eigen::Index>(c) * samples, samples);
        out[first + c].values.emplace_back(values.begin(), values.end());
      }
    }
  }
  return out;
}

// Names that no other run of the experiment has.
void add_with_own_name(Experiment& experiment, PlannedRun run) {
  const std::string stem = run.plan.name.substr(0, run.plan.name.rfind('.'));
  const auto taken = [&] {
    return std::ranges::any_of(experiment.runs,
                               [&](const PlannedRun& each) { return each.plan.name == run.plan.name; });
  };
  for (int number = 2; taken(); ++number) run.plan.name = fmt::format("{}_{}.csv", stem, number);
  experiment.runs.push_back(std::move(run));
}

// What can be repeated of the present records, the instruments at rest, and the proposed runs.
Experiment with_proposal(const Experiment& recorded, const std::vector<PlannedRun>& proposed) {
  Experiment out{.name = "next experiment", .instruments = recorded.instruments, .runs = {}};
  for (const PlannedRun& run : recorded.runs)
    if (can_be_repeated(run)) add_with_own_name(out, run);
  constexpr double rest = 10.0;  // s
  PlannedRun still{.plan = {.name = "next_still.csv", .kind = data::RunKind::still},
                   .duration = rest,
                   .rate = recorded.runs.front().rate};
  still.plan.channels = recorded.runs.front().plan.channels;
  add_with_own_name(out, std::move(still));
  for (const PlannedRun& run : proposed) add_with_own_name(out, run);
  return out;
}

}  // namespace

std::optional<NextExperiment> separating_experiment(std::span<const replay::PreparedRun> runs,
                                                    const identification::Attribution& attribution) {
  if (attribution.rivals.empty()) return std::nullopt;
  const identification::FittedHypothesis& after = attribution.after;
  Rivals rivals{&after};
  for (const identification::FittedHypothesis& rival : attribution.rivals) rivals.push_back(&rival);
  Experiment recorded = recorded_experiment(runs, after.fit);
  const Model nominal = after.hypothesis.model_at(after.fit.values);
  std::vector<CandidateRun> candidates = candidate_runs(recorded, nominal, "next_");
  // A pose that a hand holds is not known well enough to tell anything but what a circuit does.
  if (std::ranges::none_of(rivals, depends_on_circuit))
    std::erase_if(candidates,
                  [](const CandidateRun& each) { return each.run.plan.rig.coil != data::CoilWiring::driven; });
  if (candidates.empty()) return std::nullopt;
  const double current = nominal.coils() > 0 ? largest_current(runs) : 0.0;

  std::vector<double> separations(candidates.size() + 1);  // the last one is that of a torque bench
  tbb::parallel_for(std::size_t{0}, separations.size(), [&](std::size_t i) {
    separations[i] = i < candidates.size() ? motion_separation(candidates[i].run, recorded.instruments, rivals)
                                           : bench_separation(current, rivals);
  });
  const auto best = std::ranges::max_element(separations);
  if (*best < least_separation) return std::nullopt;
  std::vector<std::vector<std::string>> explanations;
  for (const identification::FittedHypothesis* rival : rivals) explanations.push_back(ids_of(*rival));
  const auto i = static_cast<std::size_t>(best - separations.begin());
  if (i == candidates.size()) {
    recorded.instruments.torque = {.noise = accuracy_of_bench(current, after)};
    const std::vector<PlannedRun> proposed = bench_runs(current);
    return NextExperiment{
        .kind = "bench_torque",
        .input = current > 0.0 ? "torque of the first joint over 0 to 80 deg, with the largest current and without"
                               : "torque of the first joint over 0 to 80 deg",
        .why = "magnets and springs are measured apart, at rest",
        .separation = *best,
        .experiment = with_proposal(recorded, proposed),
        .explanations = std::move(explanations),
        .expected = expected_readings(proposed, recorded.instruments, rivals)};
  }
  const CandidateRun& chosen = candidates[i];
  return NextExperiment{.kind = chosen.kind,
                        .input = chosen.input,
                        .why = chosen.why,
                        .separation = *best,
                        .experiment = with_proposal(recorded, {chosen.run, chosen.run}),
                        .explanations = std::move(explanations),
                        .expected = expected_readings({chosen.run}, recorded.instruments, rivals)};
}

}  // namespace coilwright::measurement::planning
