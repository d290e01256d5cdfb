#include "coilwright/measurement/diagnosis.hpp"

#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "measurement/compare/cross_validation.hpp"
#include "measurement/compare/hypothesis_search.hpp"
#include "measurement/compare/intervals.hpp"
#include "measurement/data/usable_runs.hpp"
#include "measurement/experiment/separating_experiment.hpp"
#include "measurement/final_errors.hpp"
#include "measurement/fit/residual_blocks.hpp"
#include "measurement/localise/localisation.hpp"

namespace coilwright::measurement {
namespace {

// Where structure remains: the share of what is above the noise that an effect must remove, the first and each later
// one. With enough samples every flexible term is significant; what does not halve the rest of a model that is known to
// be incomplete takes the shape of what is missing.
constexpr double least_share = 0.2;
constexpr double least_later_share = 0.5;

// Notes how long each phase took and how many runs it simulated.
class Stopwatch {
 public:
  explicit Stopwatch(std::vector<Phase>& phases) : phases_(phases) {}
  void lap(std::string name) {
    const auto now = std::chrono::steady_clock::now();
    const long runs = fit::simulated_runs();
    phases_.push_back({.name = std::move(name),
                       .seconds = std::chrono::duration<double>(now - last_).count(),
                       .simulated_runs = runs - last_runs_});
    last_ = now;
    last_runs_ = runs;
  }

 private:
  std::vector<Phase>& phases_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
  long last_runs_ = fit::simulated_runs();
};

// What step `i` of an attribution explains.
compare::Evidence evidence_of(std::span<const replay::Record> records, const compare::Attribution& found,
                              std::size_t i) {
  const compare::Scored& without = found.steps[i - 1];
  const compare::Scored& with = found.steps[i];
  compare::Evidence out = compare::evidence(records, without, with, found.unit);
  out.cross_validated_gain = compare::cross_validated_gain(records, without, with);
  return out;
}

// Share of the squared residual above the noise that a step removes.
double explained_share(const compare::Scored& without, const compare::Scored& with) {
  return (without.fit.chi_square - with.fit.chi_square) / without.excess();
}

bool supported(const compare::Scored& without, const compare::Scored& with, const compare::Evidence& step) {
  if (with.adequacy.noise_only()) return true;
  const double least = without.hypothesis.effects().empty() ? least_share : least_later_share;
  return explained_share(without, with) >= least && !(step.cross_validated_gain <= 0.0);
}

bool all_present(const compare::Scored& s, const std::vector<compare::Estimate>& all) {
  for (std::size_t i = 0; i < s.hypothesis.effects().size(); ++i)
    if (!compare::excludes_absent(s, compare::estimates_of_effect(s, all, i), i)) return false;
  return true;
}

// What stands of an attribution.
struct Standing {
  std::vector<compare::Evidence> gains{};      // of each step
  std::vector<compare::Estimate> estimates{};  // of the last
  double unit{};                               // of its evidence
};

// An effect that is not needed, or that cannot be told from nothing, is taken back, the last first.
Standing what_stands(std::span<const replay::Record> records, compare::Attribution& found) {
  Standing out{.estimates = compare::estimates(records, found.steps.back(), found.unit), .unit = found.unit};
  for (std::size_t i = 1; i < found.steps.size(); ++i) out.gains.push_back(evidence_of(records, found, i));
  while (found.steps.size() > 1 && (!supported(found.steps[found.steps.size() - 2], found.after(), out.gains.back()) ||
                                    !all_present(found.after(), out.estimates))) {
    found.steps.pop_back();
    out.gains.pop_back();
    found.rivals.clear();
    found.indistinguishable.clear();
    out.unit = compare::unit_of_evidence(records, found.after());
    out.estimates = compare::estimates(records, found.steps.back(), out.unit);
    if (!out.gains.empty()) out.gains.back() = evidence_of(records, found, found.steps.size() - 1);
  }
  return out;
}

Verdict verdict_of(const compare::Attribution& found) {
  if (found.steps.size() == 1)
    return found.before().adequacy.noise_only() ? Verdict::no_missing_effect : Verdict::unexplained;
  return found.after().adequacy.noise_only() ? Verdict::explained : Verdict::partly_explained;
}

// Why a model that explains the fit runs is off on others.
std::string why_larger(const ErrorComparison& errors) {
  constexpr double deviations = 2.0;
  const double open = std::hypot(errors.noise_floor_rmse, deviations * errors.uncertainty_rmse);
  return errors.after.rmse <= open
             ? "no more than the uncertainty of the fitted numbers leaves open there; fit such a run too"
             : "another regime, a start that is not as declared, or another effect";
}

// What a reader should not miss: a verdict rests on the fit runs and on structure alone.
void warn(const std::vector<replay::Record>& records, const replay::DeclaredModel& declared, Diagnosis& out) {
  constexpr double much = 1.5;
  const bool given =
      std::ranges::any_of(records, [](const replay::Record& record) { return record.run->sigma.has_value(); });
  if (given && out.after.level > much)
    out.warnings.push_back(
        {.run = "", .text = fmt::format("what is left is {:.3g} times the noise that the set gives", out.after.level)});
  if (given && out.after.level < 1.0 / much)
    out.warnings.push_back({.run = "",
                            .text = fmt::format("what is left is only {:.3g} times the noise that the set gives: an "
                                                "effect may hide in it",
                                                out.after.level)});
  if (out.verdict != Verdict::no_missing_effect)
    for (const std::string& number : declared.held_effects)
      out.warnings.push_back(
          {.run = "", .text = fmt::format("{} stays as declared; it is fitted anew if calibrate names it", number)});
  for (const ErrorComparison& errors : out.validate_errors)
    if (errors.after.rmse > errors.before.rmse + 0.1 * errors.noise_floor_rmse)
      out.warnings.push_back({.run = "", .text = "on the runs that no fit has seen the effects make the error larger"});
  if (out.verdict == Verdict::partly_explained || out.verdict == Verdict::unexplained) return;
  for (const ErrorComparison& errors : out.validate_errors)
    if (errors.after.rmse > much * errors.noise_floor_rmse)
      out.warnings.push_back(
          {.run = "",
           .text = fmt::format("on the runs that no fit has seen the error is {:.3g} times the noise: {}",
                               errors.after.rmse / errors.noise_floor_rmse, why_larger(errors))});
}

Diagnosis diagnose_here(const data::Dataset& data, const replay::DeclaredModel& declared,
                        const DiagnosisOptions& options) {
  Diagnosis out{.warnings = data.warnings};
  Stopwatch watch(out.phases);
  const fit::Hypothesis as_written(declared, {});
  const actuator::Model nominal = as_written.model_at(as_written.start());
  for (const data::Run& run : data.fit) check(run, declared, nominal);
  const std::vector<data::Run> runs = data::usable_runs(data.fit, out.warnings);
  std::vector<replay::Record> records;
  for (const data::Run& run : runs) records.push_back(replay::prepare(run, declared, nominal));
  FinalErrors::check(data.validate, declared, nominal);
  for (const replay::Record& record : records)
    out.noise.insert(out.noise.end(), record.noise.begin(), record.noise.end());
  watch.lap("noise");

  compare::Attribution found = compare::attribute({.records = records,
                                                   .declared = &declared,
                                                   .seed = options.seed,
                                                   .progress = options.progress,
                                                   .effects = options.effects});
  watch.lap("comparison");

  const Standing standing = what_stands(records, found);
  const std::vector<compare::Estimate>& all = standing.estimates;
  watch.lap("intervals and cross-validation");

  out.verdict = verdict_of(found);
  out.before = found.before().adequacy;
  out.after = found.after().adequacy;
  out.candidates = std::move(found.candidates);
  out.indistinguishable = found.indistinguishable;
  out.calibration.assign(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(declared.calibration.size()));
  for (std::size_t i = 0; i < found.after().hypothesis.effects().size(); ++i)
    out.effects.push_back({.kind = found.after().hypothesis.effects()[i].kind,
                           .parameters = compare::estimates_of_effect(found.after(), all, i),
                           .evidence = standing.gains[i]});
  out.residual = localise::localise(records, found.after());
  watch.lap("localisation");
  out.next_experiment = experiment::next_experiment(records, found);
  watch.lap("next experiment");

  const ThreeModels models{.declared = {.hypothesis = as_written, .fit = {.values = as_written.start()}},
                           .before = found.before(),
                           .after = found.after(),
                           .unit = standing.unit};
  const FinalErrors fitted(runs, declared, models);
  const FinalErrors validated(data.validate, declared, models);
  out.fit_errors = fitted.errors();
  out.validate_errors = validated.errors();
  for (const FinalErrors* errors : {&fitted, &validated}) {
    out.replays.insert(out.replays.end(), errors->replays().begin(), errors->replays().end());
    out.warnings.insert(out.warnings.end(), errors->warnings().begin(), errors->warnings().end());
  }
  warn(records, declared, out);
  watch.lap("final errors");
  return out;
}

}  // namespace

std::string_view name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::no_missing_effect:
      return "no_missing_effect";
    case Verdict::explained:
      return "explained";
    case Verdict::partly_explained:
      return "partly_explained";
    case Verdict::unexplained:
      return "unexplained";
  }
  return "";
}

Diagnosis diagnose(const data::Dataset& data, const replay::DeclaredModel& declared, const DiagnosisOptions& options) {
  tbb::task_arena arena(options.threads > 0 ? options.threads : tbb::task_arena::automatic);
  return arena.execute([&] { return diagnose_here(data, declared, options); });
}

}  // namespace coilwright::measurement
