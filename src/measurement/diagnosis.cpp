#include "coilwright/measurement/diagnosis.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <memory>
#include <span>
#include <utility>

#include "coilwright/measurement/identification/decision_thresholds.hpp"
#include "coilwright/measurement/require_no_slip.hpp"
#include "measurement/correction/find_correction.hpp"
#include "measurement/data/usable_runs.hpp"
#include "measurement/diagnosis_warnings.hpp"
#include "measurement/final_errors.hpp"
#include "measurement/fit/fit.hpp"
#include "measurement/fit/input_errors.hpp"
#include "measurement/fit/outliers.hpp"
#include "measurement/fit/parallel.hpp"
#include "measurement/identification/curvature.hpp"
#include "measurement/identification/free_numbers.hpp"
#include "measurement/identification/hypothesis_search.hpp"
#include "measurement/identification/insensitive_parameters.hpp"
#include "measurement/identification/intervals.hpp"
#include "measurement/identification/mixed_intervals.hpp"
#include "measurement/identification/numbers_off.hpp"
#include "measurement/identification/profile_likelihood.hpp"
#include "measurement/identification/recalibration.hpp"
#include "measurement/identification/staged_fit.hpp"
#include "measurement/identification/unseen_effects.hpp"
#include "measurement/localise/localisation.hpp"
#include "measurement/planning/informative_experiment.hpp"
#include "measurement/records/exchanged_runs.hpp"
#include "measurement/records/suspect_records.hpp"
#include "measurement/replay/if_possible.hpp"
#include "measurement/replay/recorded_noise.hpp"

namespace coilwright::measurement {
namespace {

// Measures how long each phase takes, and how many runs its fits simulate.
class PhaseTimer {
 public:
  void end_phase(std::string name) {
    const auto now = std::chrono::steady_clock::now();
    phases_.push_back({.name = std::move(name),
                       .seconds = std::chrono::duration<double>(now - last_).count(),
                       .simulated_runs = simulations_->exchange(0)});
    last_ = now;
  }
  [[nodiscard]] const std::vector<Phase>& phases() const { return phases_; }
  [[nodiscard]] const replay::SimulationCount& simulations() const { return simulations_; }

 private:
  replay::SimulationCount simulations_ = std::make_shared<std::atomic<long>>();
  std::vector<Phase> phases_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

void set_if_idle(MovedNumber& number, std::span<const identification::InsensitiveParameter> idle, Eigen::Index index) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const identification::InsensitiveParameter& each : idle) {
    if (each.index != index) continue;
    number.idle_from = each.nearest;
    const bool below = each.nearest < number.declared;
    number.estimate.lower = below ? -infinity : each.nearest;
    number.estimate.upper = below ? each.nearest : infinity;
    number.estimate.determined = true;
  }
}

void set_declared_numbers(Diagnosis& out, const replay::DeclaredModel& declared,
                          std::span<const identification::Estimate> estimates,
                          std::span<const identification::InsensitiveParameter> idle) {
  for (std::size_t i = 0; i < declared.calibration.size(); ++i) {
    const replay::CalibrationParameter& number = declared.calibration[i];
    if (number.calibrated) {
      out.calibration.push_back(estimates[i]);
      out.calibration.back().declared = number.declared;
    } else {
      out.nominal.push_back({.estimate = estimates[i],
                             .declared = number.declared,
                             .tolerance = number.tolerance->deviation,
                             .named = number.tolerance->named});
      set_if_idle(out.nominal.back(), idle, static_cast<Eigen::Index>(i));
    }
  }
}

// As Diagnosis::covariance has it, of the last step.
Eigen::MatrixXd reported_covariance(const identification::FittedHypothesis& fitted, double overdispersion,
                                    std::span<const identification::Estimate> estimates) {
  const Eigen::MatrixXd of_fit = identification::covariance(fitted, overdispersion);
  Eigen::VectorXd wider = Eigen::VectorXd::Ones(of_fit.rows());
  for (Eigen::Index i = 0; i < wider.size(); ++i) {
    const identification::Estimate& estimate = estimates[static_cast<std::size_t>(i)];
    const double of_interval = (estimate.upper - estimate.lower) / (2.0 * identification::normal_95);
    const double deviation = std::sqrt(of_fit(i, i));
    if (std::isfinite(of_interval) && deviation > 0.0) wider[i] = std::max(1.0, of_interval / deviation);
  }
  // Choices are no numbers of the fit, but of the effects.
  std::vector<Eigen::Index> places;
  for (std::size_t i = 0; i < fitted.hypothesis.declared().calibration.size(); ++i)
    places.push_back(static_cast<Eigen::Index>(i));
  auto size = static_cast<Eigen::Index>(places.size());
  for (std::size_t effect = 0; effect < fitted.hypothesis.effects().size(); ++effect) {
    for (const std::size_t number : fitted.hypothesis.parameters_of(effect).numbers)
      places.push_back(size + static_cast<Eigen::Index>(number));
    size += static_cast<Eigen::Index>(fitted.hypothesis.effects()[effect].values.size());
  }
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(size, size);
  out(places, places) = wider.asDiagonal() * of_fit * wider.asDiagonal();
  return out;
}

template <typename Value>
void append(std::vector<Value>& to, const std::vector<Value>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

// Takes the noise anew from where the declared model stands still once it is recalibrated, and sets outliers aside, as
// that model shows them, and once more without what is suspected then. Far from the noise the runs keep the model error
// at which that was fitted: the comparison begins there.
void set_outliers_aside_twice(std::vector<replay::PreparedRun>& runs, const replay::DeclaredModel& declared,
                              std::span<const data::Run> still, std::span<const data::Run> recorded) {
  auto fitted = identification::recalibrated_at_its_error(runs, declared);
  const actuator::Model model = fitted.hypothesis.model_at(fitted.fit.values);
  std::vector<Eigen::VectorXd> shown;
  for (const fit::RunFit& each : fitted.fit.runs) shown.push_back(each.predictions);
  if (replay::give_recorded_noise(runs, still, recorded, model, shown))
    fitted = identification::recalibrated_at_its_error(runs, declared);
  const auto set_aside = [&](const fit::Fit& found) {
    (void)fit::set_outliers_aside(runs, found);
    fit::weigh_input_errors(runs, fitted.hypothesis, found.values, &found);
  };
  set_aside(fitted.fit);
  const auto trimmed = fit::with_suspects_aside(runs, fitted.fit);
  if (!trimmed) return;
  const auto anew = identification::fit_exactly(
      *trimmed, {.hypothesis = fitted.hypothesis, .start = fitted.fit.values, .local_numbers_from = &fitted.fit});
  if (anew) set_aside(anew->fit);
}

// What is known before there is an answer: the recalibrated model, with intervals by its curvature, and the hypotheses
// as they were compared so far.
Diagnosis incomplete(Diagnosis out, std::span<const replay::PreparedRun> runs,
                     const identification::FittedHypothesis& before, identification::Posterior so_far) {
  const double overdispersion = identification::overdispersion_of(runs, before);
  const Eigen::VectorXd deviations = identification::standard_deviations(before, overdispersion);
  std::vector<identification::Estimate> estimates;
  for (Eigen::Index i = 0; i < before.hypothesis.size(); ++i)
    estimates.push_back(identification::local_estimate(before.hypothesis.parameters()[static_cast<std::size_t>(i)],
                                                       before.fit.values[i], deviations[i]));
  set_declared_numbers(out, before.hypothesis.declared(), estimates, {});
  out.verdict = Verdict::incomplete;
  out.probability_of_declared = identification::probability_of_declared_numbers(before);
  out.model_error = before.fit.model_error;
  out.before = before.whiteness;
  out.after = before.whiteness;
  out.odds = std::move(so_far);
  for (const replay::PreparedRun& prepared : runs) append(out.noise, prepared.noise);
  return out;
}

Diagnosis diagnose_in_arena(const data::Dataset& data, const replay::DeclaredModel& declared,
                            const DiagnosisOptions& options) {
  Diagnosis out{.warnings = data.warnings};
  PhaseTimer timer;
  const auto say = [&](const char* line) {
    if (options.progress) options.progress(line);
  };
  const fit::Hypothesis as_declared(declared, {});
  const actuator::Model nominal = as_declared.model_at(as_declared.start());
  for (const data::Run& run : data.fit) replay::require_fits_model(run, declared, nominal);
  if (!options.as_written) require_no_slip(data, declared);
  const data::UsableRuns usable = data::usable_runs(data.fit);
  append(out.warnings, usable.warnings);
  std::vector<replay::PreparedRun> runs;
  for (const data::Run& run : usable.runs) {
    runs.push_back(replay::prepare_run(run, declared, nominal));
    replay::give_recorded_noise(runs.back(), data.still, usable.runs, nominal);
    runs.back().simulations = timer.simulations();
    runs.back().known_fits = options.known_fits;
  }
  fit::weigh_input_errors(runs, as_declared, as_declared.start(), nullptr);
  FinalErrors::require_fits_model(data.validate, declared, nominal);
  out.unanswered_runs = records::unanswered_runs(usable.runs, declared);
  append(out.unanswered_runs, FinalErrors::unanswered_runs(data.validate, declared));
  append(out.warnings, out.unanswered_runs);
  append(out.warnings, records::exchanged_runs(usable.runs, declared));
  // A finger that does not answer has no pose that could tell of the zero.
  out.far_first_pose = records::initial_pose_mismatch(runs, declared);
  if (out.far_first_pose &&
      std::ranges::find(out.unanswered_runs, out.far_first_pose->run, &data::Warning::run) != out.unanswered_runs.end())
    out.far_first_pose.reset();
  if (out.far_first_pose) out.warnings.push_back(*out.far_first_pose);
  for (const data::Run& run : usable.runs)
    if (auto stalled = records::stalled_frames(run)) {
      out.frozen_runs.push_back(run.name);
      out.warnings.push_back(std::move(*stalled));
    }
  // What is wrong with the records is said before the work: its answer would come to nothing.
  if (options.warn)
    for (const data::Warning& each : out.warnings) options.warn(each);
  const replay::DeclaredModel fitted_from = identification::with_free_numbers_of_records(runs, declared);
  set_outliers_aside_twice(runs, fitted_from, data.still, usable.runs);
  timer.end_phase("noise and outliers");

  out.held_exact = declared.held_exact;
  const auto make_known = [&](const identification::FittedHypothesis& before, identification::Posterior so_far) {
    options.known(incomplete(out, runs, before, so_far));
  };
  identification::Attribution found = identification::attribute(
      {.runs = runs,
       .declared = &fitted_from,
       .seed = options.seed,
       .progress = options.progress,
       .known = options.known ? make_known : decltype(identification::AttributionRequest::known){},
       .beliefs = options.beliefs,
       .effects = options.effects});
  if (options.known) make_known(found.before, found.posterior);
  for (const replay::PreparedRun& prepared : runs) append(out.noise, prepared.noise);
  timer.end_phase("comparison");

  const double overdispersion = identification::overdispersion_of(runs, found.after);
  identification::EstimatedHypothesis reported = identification::estimated(
      runs, identification::refitted(runs, std::move(found.after)), overdispersion, options.progress);
  found.after = std::move(reported.fitted);
  std::vector<identification::Estimate>& estimates = reported.estimates;
  out.hinted = identification::widen_by_unseen_effects(estimates, runs, found, overdispersion);
  identification::widen_by_posterior(estimates, found, overdispersion);
  const auto idle_before = identification::insensitive_parameters(runs, found.before);
  const auto idle_after = found.has_effects() ? identification::insensitive_parameters(runs, found.after) : idle_before;
  if (!found.has_effects() && found.answer.leaves_noise)
    out.numbers_off = identification::numbers_that_may_be_off(runs, found.before, overdispersion);
  timer.end_phase("intervals");

  out.probability_of_declared = identification::probability_of_declared_numbers(found.before, idle_before);
  const bool numbers_are_off =
      !out.numbers_off.empty() || out.probability_of_declared < identification::decision_thresholds.least_probability;
  out.verdict = identification::verdict_of(found.posterior, found.answer, numbers_are_off);
  out.model_error = found.after.fit.model_error;
  out.before = found.before.whiteness;
  out.after = found.after.whiteness;
  out.indistinguishable = found.answer.indistinguishable;
  set_declared_numbers(out, declared, estimates, idle_after);
  out.covariance = reported_covariance(found.after, overdispersion, estimates);
  for (std::size_t i = 0; i < found.after.hypothesis.effects().size(); ++i)
    out.effects.push_back({.kind = found.after.hypothesis.effects()[i].kind,
                           .parameters = identification::estimates_of_effect(found.after, estimates, i)});
  say("residual as a torque");
  out.residual = localise::localise(runs, found.after);
  timer.end_phase("localisation");
  correction::FoundCorrection nameless;
  if (out.verdict == Verdict::partly_explained || out.verdict == Verdict::unexplained)
    nameless = correction::find_correction(runs, found, out.residual, options.progress);
  out.correction = nameless.outcome;
  timer.end_phase("nameless correction");
  say("what to record next");
  out.next_experiment =
      replay::if_possible<planning::NextExperiment>([&] { return planning::informative_experiment(runs, found); });
  out.odds = std::move(found.posterior);
  // Both were fitted again after they had been weighed.
  for (identification::WeighedHypothesis& each : out.odds.hypotheses)
    if (each.effects.empty()) each.chi_square = found.before.fit.chi_square;
  if (found.has_effects()) out.odds.hypotheses[found.answer.reported].chi_square = found.after.fit.chi_square;
  timer.end_phase("next experiment");

  const ThreeModels models{.declared = {.hypothesis = as_declared, .fit = {.values = as_declared.start()}},
                           .before = found.before,
                           .after = found.after,
                           .overdispersion = overdispersion,
                           .corrected = nameless.fitted};
  say("errors of the finished models");
  const FinalErrors fitted(runs, models);
  const FinalErrors validated(data.validate, declared, models, data.still, timer.simulations());
  out.fit_errors = fitted.errors();
  out.validate_errors = validated.errors();
  for (const FinalErrors* errors : {&fitted, &validated}) {
    append(out.replays, errors->replays());
    append(out.outliers, errors->outliers());
    append(out.warnings, errors->warnings());
  }
  append(out.warnings, warnings_of(out, runs, declared));
  if (found.has_effects())
    if (auto alone = support_in_one_run(runs, found.before.fit, found.after.fit)) out.warnings.push_back(*alone);
  timer.end_phase("final errors");
  out.phases = timer.phases();
  return out;
}

}  // namespace

Diagnosis diagnose(const data::Dataset& data, const replay::DeclaredModel& declared, const DiagnosisOptions& options) {
  Diagnosis out;
  fit::with_threads(options.threads, [&] { out = diagnose_in_arena(data, declared, options); });
  return out;
}

}  // namespace coilwright::measurement
