#include "report/diagnosis/diagnosis_parts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "coilwright/formats/data/diagnosis_formatting.hpp"

namespace coilwright::report {
namespace {

using namespace measurement;

// An error has risen if it is larger by more than this fraction of the noise.
constexpr double notable_rise = 0.1;
// A number that moved by so many tolerances is worth a measurement.
constexpr double far = 2.0;
// One that moved by so many is more than chance, and belongs into the first lines.
constexpr double very_far = 3.0;
constexpr std::size_t most_to_measure = 3;

// Declared numbers that moved far; if none did, faces included, and they are off together, those that moved most. Where
// one is off by itself, those beside it have moved for its sake.
std::vector<std::string> numbers_to_measure(const Diagnosis& diagnosis) {
  if (!diagnosis.numbers_off.empty()) return numbers_off_to_measure(diagnosis);
  std::vector<const MovedNumber*> ordered;
  const auto moved = [](const MovedNumber* each) { return std::abs(formats::tolerances_moved(*each)); };
  bool together = diagnosis.verdict == Verdict::declared_numbers_off;
  for (const MovedNumber& each : diagnosis.nominal)
    if (!each.idle_from)
      ordered.push_back(&each);
    else if (moved(&each) > far)
      together = false;
  std::ranges::stable_sort(ordered, std::greater{}, moved);
  std::vector<std::string> out;
  for (const MovedNumber* each : ordered) {
    if (out.size() == most_to_measure || (moved(each) <= far && !(together && out.empty()))) continue;
    std::string what =
        each->estimate.key.starts_with("force_curve")
            ? shape_to_measure()
            : fmt::format("{} (declared {}, {} {})", each->estimate.key, number_text(formats::in_unit(*each).declared),
                          leaves_structure(diagnosis) ? "moved to" : "these data say", moved_to_text(*each));
    if (std::ranges::find(out, what) == out.end()) out.push_back(std::move(what));
  }
  return out;
}

// Declared faces that touch nowhere in these records: where they close cannot be weighed, but seen. A design has faces
// by its geometry, and no entry that could be removed.
std::vector<std::string> faces_to_look_at(const formats::DiagnosisReport& report) {
  std::vector<std::string> out;
  for (const MovedNumber& each : report.diagnosis.nominal) {
    if (!each.idle_from) continue;
    const formats::MovedNumberInUnit shown = formats::in_unit(each);
    std::string step = fmt::format(
        "Close a joint of the rig by hand, and see where its faces touch: {} is declared as {}, and these records show "
        "no contact down to {}.",
        each.estimate.key, number_text(shown.declared), number_text(*shown.idle_from));
    if (!report.is_design) step += " If there are no faces, remove \"contact\" from the joints of the actuator file.";
    out.push_back(std::move(step));
  }
  return out;
}

std::string measuring_step(const Diagnosis& diagnosis, const std::vector<std::string>& numbers) {
  const std::string all = fmt::format("{}", fmt::join(numbers, ", "));
  // Numbers of a fit that does not reach the noise are not measurements.
  if (leaves_structure(diagnosis))
    return fmt::format(
        "Do not copy the numbers that moved into the actuator file: they may have taken up what is missing. Measure by "
        "other means {}.",
        all);
  return fmt::format("Weigh or measure {}, correct the actuator file and diagnose again.", all);
}

// How each effect that was found, and each that could stand in its place, shows itself without the model.
std::vector<std::string> checks_at_the_rig(const Diagnosis& diagnosis) {
  std::vector<std::string> out;
  for (const AddedEffect& each : diagnosis.effects) {
    if (each.kind->check().empty()) continue;
    std::string step = fmt::format("Check {} without this model: {}.", each.kind->id(), each.kind->check());
    for (const auto& set : diagnosis.indistinguishable) {
      if (std::ranges::find(set, each.kind) == set.end()) continue;
      for (const actuator::EffectKind* other : set)
        if (other != each.kind && !other->check().empty())
          step += fmt::format(" If it is not there, check {}: {}.", other->id(), other->check());
    }
    out.push_back(std::move(step));
  }
  return out;
}

}  // namespace

std::string far_numbers(const Diagnosis& diagnosis) {
  if (diagnosis.verdict != Verdict::explained && diagnosis.verdict != Verdict::no_missing_effect) return {};
  std::vector<std::string> names;
  for (const MovedNumber& each : diagnosis.nominal) {
    const double moved = formats::tolerances_moved(each);
    if (std::abs(moved) > very_far) names.push_back(fmt::format("{} by {:.1f}", each.estimate.key, std::abs(moved)));
  }
  if (names.empty()) return {};
  return fmt::format(
      "{}eclared numbers had to move far, in tolerances: {}. Measure them before you rely on this model.",
      diagnosis.effects.empty() ? "But d" : "Even so d", fmt::join(names, ", "));
}

bool leaves_structure(const Diagnosis& diagnosis) {
  return diagnosis.verdict == Verdict::partly_explained || diagnosis.verdict == Verdict::unexplained;
}

std::vector<std::string> names_of_runs(std::span<const data::Warning> warnings) {
  std::vector<std::string> out;
  for (const data::Warning& each : warnings) out.push_back(each.run);
  return out;
}

bool has_risen(const Errors& from, const Errors& to, double noise) {
  return to.rmse > from.rmse + notable_rise * noise;
}

std::vector<std::string> risen_errors(const Diagnosis& diagnosis) {
  std::vector<std::string> out;
  for (const ErrorComparison* errors : formats::main_first(diagnosis.validate_errors)) {
    const units::Unit unit = formats::error_unit(errors->kind);
    const auto add = [&](double from, const char* what_before, double to, const char* what_after) {
      out.push_back(
          fmt::format("On the runs that no fit has seen the error of the {} rises from {} {} to {} {} (rmse).",
                      formats::name_of(errors->kind), number_text(units::from_si(from, unit)), what_before,
                      in_unit_text(to, unit), what_after));
    };
    if (!diagnosis.effects.empty() && has_risen(errors->before, errors->after, errors->noise_floor_rmse))
      add(errors->before.rmse, "without the effects", errors->after.rmse, "with them");
    else if (has_risen(errors->declared, errors->after, errors->noise_floor_rmse))
      add(errors->declared.rmse, "as declared", errors->after.rmse,
          diagnosis.effects.empty() ? "fitted anew" : "with the effects");
  }
  return out;
}

std::vector<std::string> errors_beyond_noise(const Diagnosis& diagnosis) {
  if (leaves_structure(diagnosis) || !risen_errors(diagnosis).empty()) return {};
  std::vector<std::string> out;
  for (const ErrorComparison* errors : formats::main_first(diagnosis.validate_errors)) {
    const bool is_noise_known = errors->noise_floor_rmse > 0.0;
    if (!is_noise_known || errors->after.rmse <= (1.0 + notable_rise) * errors->noise_floor_rmse) continue;
    const units::Unit unit = formats::error_unit(errors->kind);
    out.push_back(
        fmt::format("But on the runs that no fit has seen the error of the {} is {} (rmse), where noise alone makes "
                    "{}: they show something that the fitted runs do not.",
                    formats::name_of(errors->kind), in_unit_text(errors->after.rmse, unit),
                    in_unit_text(errors->noise_floor_rmse, unit)));
  }
  return out;
}

std::string refusal(const formats::DiagnosisReport& report) {
  if (report.refused.empty()) return {};
  return fmt::format("But it needs a number that no actuator has, and the other commands refuse the file: {}.",
                     report.refused.front());
}

bool may_be_the_camera(const Diagnosis& diagnosis) {
  // Colour alone makes no more of noise whose level was taken from one sample to the next.
  constexpr double most_of_colour = 10.0;
  return !diagnosis.noise.empty() && std::ranges::all_of(diagnosis.noise, &signals::NoiseLevel::colour_unknown) &&
         diagnosis.after.level < most_of_colour;
}

std::vector<std::string> next_steps(const formats::DiagnosisReport& report) {
  const Diagnosis& diagnosis = report.diagnosis;
  std::vector<std::string> steps;
  const bool structure = leaves_structure(diagnosis);
  if (!report.refused.empty())
    steps.push_back(
        fmt::format("Do not build on {}. Look at the units of the records and at the declared numbers that act with "
                    "the refused one (turns, gap, magnet, stiffness), then diagnose again.",
                    report.updated_actuator));
  if (!diagnosis.unanswered_runs.empty())
    steps.push_back(
        fmt::format("Look at the film and the wiring of {}. Where no current flowed, leave the run out, or end its "
                    "record before that, and diagnose again, before anything else.",
                    fmt::join(names_of_runs(diagnosis.unanswered_runs), ", ")));
  if (diagnosis.far_first_pose)
    steps.emplace_back(
        "Look at a picture of the finger at rest: 0 deg is a straight finger. If the records count from another zero, "
        "correct them and diagnose again, before anything else; if they do not, what bends the finger at rest is "
        "real.");
  if (!diagnosis.frozen_runs.empty())
    steps.push_back(
        fmt::format("Leave the pictures that stand still out of {} (the warnings say from when on), and diagnose "
                    "again: they were fitted as if the finger had stopped.",
                    fmt::join(diagnosis.frozen_runs, ", ")));
  if (!risen_errors(diagnosis).empty() || !errors_beyond_noise(diagnosis).empty())
    steps.emplace_back(
        "Fit a run of the kind that was kept from the fit, too, before anything is built on this result.");
  for (std::string& step : checks_at_the_rig(diagnosis)) steps.push_back(std::move(step));
  for (std::string& step : faces_to_look_at(report)) steps.push_back(std::move(step));
  if (const std::vector<std::string> measure = numbers_to_measure(diagnosis); !measure.empty())
    steps.push_back(measuring_step(diagnosis, measure));
  if (diagnosis.next_experiment) {
    const planning::NextExperiment& next = *diagnosis.next_experiment;
    steps.push_back(
        fmt::format("Record this run ({}): {}: {}; of {} bits that are open between the explanations it leaves {} on "
                    "average, or less.",
                    next.kind, next.input, next.why, number_text(next.open_bits), number_text(next.remaining_bits)));
  }
  if ((structure || !diagnosis.after.is_white()) &&
      std::ranges::any_of(diagnosis.noise, &signals::NoiseLevel::colour_unknown))
    steps.emplace_back(
        "Record ten seconds of the finger at rest (kind still): it tells whether what is left is noise of the camera.");
  if (structure)
    steps.emplace_back(
        "Look at what is left over, below, and at residuals.csv and the film where it is worst: on what it depends "
        "names the cause. Repeat that run: what comes back is not chance.");
  if (structure && diagnosis.verdict == Verdict::partly_explained)
    steps.emplace_back(
        "Do not take the numbers of the effects for those of the finger: what is missing distorts them.");
  if (diagnosis.validate_errors.empty() && !structure)
    steps.emplace_back(
        "Record a further run and give it the role validate: this result was judged by the runs that it was fitted "
        "to.");
  if (diagnosis.verdict == Verdict::no_missing_effect)
    steps.emplace_back(
        "To learn how small an effect these runs could have shown, describe them as an experiment and run plan: a "
        "smaller one may still be there.");
  if (!structure && !diagnosis.numbers_off.empty())
    steps.push_back(
        fmt::format("Do not build on {}: there its tolerance holds back the number that is off, and others carry what "
                    "it lacks. Go on with that of the new diagnosis.",
                    report.updated_actuator));
  else if (!structure && report.refused.empty())
    steps.push_back(fmt::format(
        "{} with {}: {} take it.", steps.empty() ? "Go on" : "Once that is done, go on", report.updated_actuator,
        report.is_design ? "evaluate, simulate and the studies of size" : "evaluate and simulate"));
  return steps;
}

}  // namespace coilwright::report
