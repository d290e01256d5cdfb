#include "measurement/planning/informative_experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "coilwright/algebra/spectral.hpp"
#include "measurement/fit/parallel.hpp"
#include "measurement/planning/candidate_runs.hpp"
#include "measurement/planning/expected_information.hpp"
#include "measurement/planning/planned_motion.hpp"
#include "measurement/planning/recorded_experiment.hpp"
#include "measurement/replay/if_possible.hpp"
#include "measurement/replay/rig_change.hpp"

namespace coilwright::measurement::planning {
namespace {

using actuator::Model;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using mechanics::JointVector;

// A run that tells less than this share of what is open between the explanations is not proposed.
constexpr double least_share = 0.1;
// The accuracy of a torque bench, as a fraction of its largest reading.
constexpr double bench_accuracy = 0.01;
constexpr double half_turn = std::numbers::pi;

// An explanation that is left, with what the records say of its numbers.
struct Explanation {
  const fit::Hypothesis& hypothesis;
  const identification::WeighedFit& weighed;
  double probability{};  // over that of all that are left
};

// A run with its times, and what perfect instruments show of it: channel after channel, SI.
struct Seen {
  data::Run run;
  VectorXd values;
};

// As a hypothesis with these numbers has it. Clocks and shutter would blur all hypotheses alike. Nothing if it cannot
// be simulated.
std::optional<Seen> seen_by(const fit::Hypothesis& hypothesis, const VectorXd& numbers, const PlannedRun& planned) {
  PlannedRun run = planned;
  run.plan.clock = {};
  run.plan.hold = {};
  run.input_rate = 0.0;
  return replay::if_possible<Seen>([&] {
    const Model model(replay::on_changed_rig(hypothesis.spec_at(numbers), run.plan.rig));
    data::Run seen = with_inputs(run, model);
    VectorXd values = true_values(run, seen, {}, hypothesis.declared(), model);
    return Seen{.run = std::move(seen), .values = std::move(values)};
  });
}

// What a hypothesis with these numbers reads, over the noise; nothing if it cannot be simulated.
using Readings = std::function<std::optional<VectorXd>(const fit::Hypothesis&, const VectorXd&)>;

Readings motion_readings(const PlannedRun& candidate, const Instruments& instruments) {
  return [&](const fit::Hypothesis& hypothesis, const VectorXd& numbers) -> std::optional<VectorXd> {
    std::optional<Seen> seen = seen_by(hypothesis, numbers, candidate);
    if (!seen) return std::nullopt;
    const auto samples = static_cast<Eigen::Index>(seen->run.samples());
    for (std::size_t c = 0; c < seen->run.channels.size(); ++c) {
      const double noise = instruments.of(seen->run.channels[c].kind).noise;
      seen->values.segment(static_cast<Eigen::Index>(c) * samples, samples) *= noise > 0.0 ? 1.0 / noise : 0.0;
    }
    return std::move(seen->values);
  };
}

// Torque of the first joint over its angle, N m: with the largest current, if coils drive the rig, and without.
VectorXd bench_torques(double current, const fit::Hypothesis& hypothesis, const VectorXd& numbers) {
  const Model model = hypothesis.model_at(numbers);
  std::vector<double> values;
  for (int i = 0; i <= 16; ++i) {
    JointVector angles = JointVector::Zero(model.joints());
    angles[0] = i * 5.0 * half_turn / 180.0;
    if (current > 0.0) values.push_back(model.magnetic_torques(angles, model.all_coils(current))[0]);
    values.push_back(model.hinge_torques(angles)[0]);
  }
  return Eigen::Map<const VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

double accuracy_of_bench(double current, const Explanation& explanation) {
  const VectorXd torques = bench_torques(current, explanation.hypothesis, explanation.weighed.values);
  return std::max(bench_accuracy * torques.lpNorm<Eigen::Infinity>(), 1e-12);
}

Readings bench_readings(double current, double accuracy) {
  return [=](const fit::Hypothesis& hypothesis, const VectorXd& numbers) -> std::optional<VectorXd> {
    return replay::if_possible<VectorXd>(
        [&] { return VectorXd(bench_torques(current, hypothesis, numbers) / accuracy); });
  };
}

// Columns that make the covariance of the numbers: independent moves of one standard deviation.
MatrixXd moves_of(const identification::WeighedFit& weighed) {
  const VectorXd deviations = weighed.covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
  const VectorXd over = deviations.unaryExpr([](double each) { return each > 0.0 ? 1.0 / each : 0.0; });
  const algebra::SymmetricModes modes =
      algebra::symmetric_modes(over.asDiagonal() * weighed.covariance * over.asDiagonal());
  return deviations.asDiagonal() * modes.vectors * modes.values.cwiseMax(0.0).cwiseSqrt().asDiagonal();
}

// By secants over one standard deviation: what the records leave open may be far from linear. A move that makes no
// motion is made the other way.
std::optional<Expectation> expectation(const Explanation& explanation, const Readings& readings) {
  const VectorXd& numbers = explanation.weighed.values;
  std::optional<VectorXd> mean = readings(explanation.hypothesis, numbers);
  if (!mean) return std::nullopt;
  const MatrixXd moves = numbers.size() > 0 ? moves_of(explanation.weighed) : MatrixXd(0, 0);
  Expectation out{.probability = explanation.probability,
                  .mean = *mean,
                  .spread = MatrixXd(mean->size(), moves.cols()),
                  .moved = [&explanation, &readings, moves](const VectorXd& by) {
                    const VectorXd there = explanation.weighed.values + moves * by;
                    return readings(explanation.hypothesis, explanation.hypothesis.clamped(there));
                  }};
  for (Eigen::Index k = 0; k < moves.cols(); ++k) {
    const VectorXd one = VectorXd::Unit(moves.cols(), k);
    std::optional<VectorXd> there = out.moved(one);
    if (!there) there = out.moved(-one);
    if (!there) return std::nullopt;
    out.spread.col(k) = *there - *mean;
  }
  return out;
}

using Explanations = std::vector<Explanation>;

// Logarithm of how many bits a run leaves at most; infinite where one of the explanations cannot be simulated in it.
double log_bits_after(const Explanations& explanations, const Readings& readings) {
  std::vector<Expectation> expected;
  for (const Explanation& each : explanations) {
    std::optional<Expectation> one = expectation(each, readings);
    if (!one) return std::numeric_limits<double>::infinity();
    expected.push_back(*std::move(one));
  }
  return log_remaining_bits(expected);
}

bool depends_on_circuit(const Explanation& explanation) {
  return std::ranges::any_of(explanation.hypothesis.effects(),
                             [](const actuator::Effect& effect) { return effect.kind->needs_closed_circuit(); });
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

// Ids of the effects of each.
std::vector<std::vector<std::string>> names_of(const Explanations& explanations) {
  std::vector<std::vector<std::string>> out;
  for (const Explanation& explanation : explanations) {
    out.emplace_back();
    for (const actuator::Effect& effect : explanation.hypothesis.effects()) out.back().emplace_back(effect.kind->id());
  }
  return out;
}

// What the explanations expect of each channel of the proposed runs; nothing where one of them cannot be simulated in
// them.
std::vector<ExpectedReading> expected_readings(const std::vector<PlannedRun>& proposed, const Instruments& instruments,
                                               const Explanations& explanations) {
  std::vector<ExpectedReading> out;
  for (const PlannedRun& planned : proposed) {
    const std::size_t first = out.size();
    for (const Explanation& explanation : explanations) {
      const std::optional<Seen> seen = seen_by(explanation.hypothesis, explanation.weighed.values, planned);
      if (!seen) return {};
      const auto samples = static_cast<Eigen::Index>(seen->run.samples());
      for (std::size_t c = 0; c < seen->run.channels.size(); ++c) {
        const data::Channel& channel = seen->run.channels[c];
        if (&explanation == &explanations.front())
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

// The reported hypothesis first, then its rivals.
Explanations explanations_of(const identification::Attribution& attribution) {
  const identification::Answer& answer = attribution.answer;
  Explanations out;
  double sum = 0.0;
  const auto add = [&](const identification::FittedHypothesis& fitted, std::size_t place) {
    const double probability = attribution.posterior.hypotheses[place].probability;
    out.push_back({.hypothesis = fitted.hypothesis, .weighed = attribution.weighed[place], .probability = probability});
    sum += probability;
  };
  add(attribution.after, answer.reported);
  for (std::size_t i = 0; i < answer.rivals.size(); ++i) add(attribution.rivals[i], answer.rivals[i]);
  for (Explanation& each : out) each.probability /= sum;
  return out;
}

}  // namespace

std::optional<NextExperiment> informative_experiment(std::span<const replay::PreparedRun> runs,
                                                     const identification::Attribution& attribution) {
  if (attribution.rivals.empty()) return std::nullopt;
  const Explanations explanations = explanations_of(attribution);
  const identification::FittedHypothesis& after = attribution.after;
  Experiment recorded = recorded_experiment(runs, after.fit);
  const Model nominal = after.hypothesis.model_at(after.fit.values);
  std::vector<CandidateRun> candidates = candidate_runs(recorded, nominal, "next_");
  // A pose that a hand holds is not known well enough to tell anything but what a circuit does.
  if (std::ranges::none_of(explanations, depends_on_circuit))
    std::erase_if(candidates,
                  [](const CandidateRun& each) { return each.run.plan.rig.coil != data::CoilWiring::driven; });
  if (candidates.empty()) return std::nullopt;
  const double current = nominal.coils() > 0 ? largest_current(runs) : 0.0;
  const double accuracy = accuracy_of_bench(current, explanations.front());

  std::vector<double> after_run(candidates.size() + 1);  // the last one is that of a torque bench
  fit::in_parallel(after_run.size(), [&](std::size_t i) {
    after_run[i] =
        log_bits_after(explanations, i < candidates.size() ? motion_readings(candidates[i].run, recorded.instruments)
                                                           : bench_readings(current, accuracy));
  });
  const auto best = std::ranges::min_element(after_run);
  std::vector<double> probabilities;
  for (const Explanation& each : explanations) probabilities.push_back(each.probability);
  NextExperiment out{.open_bits = open_bits(probabilities), .remaining_bits = std::exp(*best)};
  if (out.remaining_bits > (1.0 - least_share) * out.open_bits) return std::nullopt;
  out.explanations = names_of(explanations);
  const auto i = static_cast<std::size_t>(best - after_run.begin());
  std::vector<PlannedRun> proposed;
  if (i == candidates.size()) {
    recorded.instruments.torque = {.noise = accuracy};
    out.kind = "bench_torque";
    out.input = current > 0.0 ? "torque of the first joint over 0 to 80 deg, with the largest current and without"
                              : "torque of the first joint over 0 to 80 deg";
    out.why = "magnets and springs are measured apart, at rest";
    proposed = bench_runs(current);
    out.experiment = with_proposal(recorded, proposed);
  } else {
    const CandidateRun& chosen = candidates[i];
    out.kind = chosen.kind;
    out.input = chosen.input;
    out.why = chosen.why;
    proposed = {chosen.run};
    out.experiment = with_proposal(recorded, {chosen.run, chosen.run});
  }
  out.expected = expected_readings(proposed, recorded.instruments, explanations);
  return out;
}

}  // namespace coilwright::measurement::planning
