#include "measurement/experiment/separating_experiment.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "coilwright/simulation/initial_state.hpp"
#include "measurement/experiment/candidate_experiments.hpp"
#include "measurement/replay/prediction.hpp"

namespace coilwright::measurement::experiment {
namespace {

using actuator::Model;
using actuator::ModelSpec;
using mechanics::JointVector;

// A run that separates hypotheses by less than half the noise is not proposed.
constexpr double least_separation = 0.5;
// The accuracy of a torque bench, as a fraction of its largest reading.
constexpr double bench_accuracy = 0.01;
constexpr double pi = std::numbers::pi;

replay::Window window_of(const CandidateExperiment& candidate, const DriveRange& range, const Model& model) {
  replay::Window window{};
  // Long holds need no fine samples.
  const double interval = std::max(range.interval, candidate.duration / 8000.0);
  const auto samples = static_cast<std::size_t>(candidate.duration / interval) + 1;
  window.range.last = samples;
  simulation::CommandedInput command{.drive = range.coils ? data::Drive::current : data::Drive::torque};
  for (std::size_t i = 0; i < samples; ++i) {
    const double t = static_cast<double>(i) * interval;
    command.times.push_back(t);
    std::vector<double>& row = command.rows.emplace_back(range.coils ? 1 : model.joints(), 0.0);
    row[0] = range.amplitude * candidate.command(t);
  }
  window.input = simulation::model_input(model, command);
  return window;
}

using Prediction = std::optional<Eigen::VectorXd>;

// The bending angle over its noise that a hypothesis predicts. Nothing if it cannot be simulated.
Prediction predicted_motion(const CandidateExperiment& candidate, const DriveRange& range,
                            const compare::FittedHypothesis& fitted) {
  ModelSpec spec = fitted.hypothesis.spec_at(fitted.fit.values);
  if (candidate.change) candidate.change(spec);
  const Model model(std::move(spec));
  const replay::Window window = window_of(candidate, range, model);
  const data::Run camera{.kind = data::RunKind::transient,
                         .times = window.input.times,
                         .channels = {{.name = "bending_angle_deg", .kind = data::ChannelKind::bending_angle}}};
  const replay::PreparedRun prepared{.run = &camera};
  const auto start = simulation::equilibrium_at_first_input(model, window.input);
  if (!start) return std::nullopt;
  const auto predicted = replay::predict_window(model, prepared, window, *start);
  if (!predicted) return std::nullopt;
  return Eigen::VectorXd(predicted->values / range.sigma);
}

// Torque of the first joint over its angle, N m: with the largest current, if coils drive the rig, and without.
Eigen::VectorXd bench_torques(const DriveRange& range, const compare::FittedHypothesis& fitted) {
  const Model model = fitted.hypothesis.model_at(fitted.fit.values);
  std::vector<double> values;
  for (int i = 0; i <= 16; ++i) {
    JointVector angles = JointVector::Zero(model.joints());
    angles[0] = i * 5.0 * pi / 180.0;
    if (range.coils) values.push_back(model.magnetic_torques(angles, model.all_coils(range.amplitude))[0]);
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

using Rivals = std::vector<const compare::FittedHypothesis*>;

// How far a candidate separates the rivals, over the noise.
double motion_separation(const CandidateExperiment& candidate, const DriveRange& range, const Rivals& rivals) {
  std::vector<Prediction> predictions;
  for (const compare::FittedHypothesis* rival : rivals)
    predictions.push_back(predicted_motion(candidate, range, *rival));
  return separation(predictions);
}

// How far a torque bench separates the rivals, over its accuracy.
double bench_separation(const DriveRange& range, const Rivals& rivals) {
  std::vector<Prediction> predictions;
  for (const compare::FittedHypothesis* rival : rivals) predictions.emplace_back(bench_torques(range, *rival));
  return separation(predictions) / std::max(bench_accuracy * predictions.front()->lpNorm<Eigen::Infinity>(), 1e-12);
}

DriveRange drive_range(std::span<const replay::PreparedRun> runs, const Model& model) {
  DriveRange range{.coils = false, .interval = 0.002};
  double current = 0.0;
  double torque = 0.0;
  for (const replay::PreparedRun& prepared : runs) {
    for (const replay::Window& window : prepared.windows) {
      for (const auto& currents : window.input.currents)
        if (currents.size() > 0) current = std::max(current, currents.lpNorm<Eigen::Infinity>());
      for (const auto& torques : window.input.joint_torques)
        torque = std::max(torque, torques.lpNorm<Eigen::Infinity>());
    }
    if (!prepared.is_motion()) continue;
    const std::vector<double>& times = prepared.run->times;
    range.interval = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
    for (std::size_t c = 0; c < prepared.noise.size() && range.sigma == 0.0; ++c)
      if (prepared.run->channels[c].kind != data::ChannelKind::joint_rate) range.sigma = prepared.noise[c].sigma;
  }
  range.coils = model.coils() > 0 && current > 0.0;
  range.amplitude = range.coils ? current : torque;
  range.unit = range.coils ? "A" : "N m at joint 1";
  return range;
}

}  // namespace

std::optional<NextExperiment> separating_experiment(std::span<const replay::PreparedRun> runs,
                                                    const compare::Attribution& attribution) {
  if (attribution.rivals.empty()) return std::nullopt;
  const compare::FittedHypothesis& after = attribution.after();
  Rivals rivals{&after};
  for (const compare::FittedHypothesis& rival : attribution.rivals) rivals.push_back(&rival);
  const DriveRange range = drive_range(runs, after.hypothesis.model_at(after.fit.values));
  if (range.amplitude <= 0.0 || range.sigma <= 0.0) return std::nullopt;

  const std::vector<CandidateExperiment> candidates = candidate_experiments(range);
  std::vector<double> separations(candidates.size() + 1);  // the last one is that of a torque bench
  tbb::parallel_for(std::size_t{0}, separations.size(), [&](std::size_t i) {
    separations[i] =
        i < candidates.size() ? motion_separation(candidates[i], range, rivals) : bench_separation(range, rivals);
  });
  const auto best = std::ranges::max_element(separations);
  if (*best < least_separation) return std::nullopt;
  const auto i = static_cast<std::size_t>(best - separations.begin());
  if (i == candidates.size())
    return NextExperiment{.kind = "bench_torque",
                          .input = "torque of the first joint over 0 to 80 deg, with the largest current and without",
                          .why = "magnets and springs are measured apart, at rest",
                          .separation = *best};
  return NextExperiment{
      .kind = candidates[i].kind, .input = candidates[i].input, .why = candidates[i].why, .separation = *best};
}

}  // namespace coilwright::measurement::experiment
