#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "coilwright/formats/data/diagnosis_formatting.hpp"
#include "coilwright/measurement/identification/decision_thresholds.hpp"
#include "coilwright/report/diagnosis/diagnosis_text.hpp"
#include "coilwright/report/simulation/text_table.hpp"
#include "coilwright/text/one_line.hpp"
#include "report/diagnosis/diagnosis_parts.hpp"

namespace coilwright::report {
namespace {

using formats::error_unit;
using formats::ids;
using formats::in_unit;
using formats::main_first;
using namespace measurement;
using enum TextTable::Align;

constexpr std::size_t most_dependences = 4;
constexpr double least_dependence = 0.1;  // of the square: less is no clue

// An effect, and what it may be as well.
std::string name_with_rivals(const Diagnosis& diagnosis, const actuator::EffectKind* kind) {
  const auto set = std::ranges::find_if(diagnosis.indistinguishable,
                                        [&](const auto& kinds) { return kinds.front() == kind && kinds.size() > 1; });
  if (set == diagnosis.indistinguishable.end()) return std::string(kind->id());
  std::vector<std::string> names;
  for (const actuator::EffectKind* each : *set) names.emplace_back(each->id());
  const std::string last = names.back();
  names.pop_back();
  return fmt::format("either {} or {} (these data cannot tell which)", fmt::join(names, ", "), last);
}

// ", most of all NAME"; empty where nothing may move.
std::string farthest_number(const Diagnosis& diagnosis) {
  const auto moved = [](const MovedNumber& each) { return std::abs(formats::tolerances_moved(each)); };
  const auto most = std::ranges::max_element(diagnosis.nominal, {}, moved);
  if (most == diagnosis.nominal.end()) return "";
  return fmt::format(", most of all {} ({:.1f} tolerances)", most->estimate.key, moved(*most));
}

// Whether what is left over is noise, where that is nearly as probable as that it is not.
bool is_undecided(const Diagnosis& diagnosis) {
  const identification::WeighedHypothesis* reported = formats::reported_hypothesis(diagnosis);
  return reported != nullptr && reported->probability_of_noise > 0.2 && reported->probability_of_noise < 0.8;
}

// "is noise"; with its probability where that decides little.
std::string noise_words(const Diagnosis& diagnosis) {
  if (!is_undecided(diagnosis)) return "is noise";
  return fmt::format("is noise with a probability of {:.2f}",
                     formats::reported_hypothesis(diagnosis)->probability_of_noise);
}

std::string verdict_sentence(const Diagnosis& diagnosis) {
  std::vector<std::string> names;
  for (const AddedEffect& each : diagnosis.effects) names.push_back(name_with_rivals(diagnosis, each.kind));
  const std::string effects = fmt::format("{}", fmt::join(names, " and "));
  const std::string noise = noise_words(diagnosis);
  switch (diagnosis.verdict) {
    case Verdict::no_missing_effect:
      return fmt::format("The declared model lacks nothing that {}: fitted anew, what it leaves {}.",
                         has_unseen_effects(diagnosis) ? "moves it by a tenth of the noise" : "these data show", noise);
    case Verdict::declared_numbers_off:
      if (!diagnosis.numbers_off.empty()) return numbers_off_sentence(diagnosis);
      return fmt::format(
          "The declared numbers are off{}: moved further than their tolerances make likely, they explain these "
          "data, and no missing effect does so decisively better.",
          farthest_number(diagnosis));
    case Verdict::explained:
      return fmt::format("The declared model lacks {}; with {}, what is left over {}.", effects,
                         names.size() == 1 ? "it" : "them", noise);
    case Verdict::partly_explained:
      if (is_undecided(diagnosis))
        return fmt::format("The declared model lacks {}, and perhaps something else: what is left over {}.", effects,
                           noise);
      return fmt::format("The declared model lacks {}, and something else: structure remains that no effect explains.",
                         effects);
    case Verdict::incomplete:
      return "INTERRUPTED before there was a conclusion. The declared model was fitted anew, and its effects compared "
             "as far as the\nlist below; nothing is known of runs that no fit has seen. Diagnose again, with --resume, "
             "for an answer.";
    case Verdict::unexplained:
      if (may_be_the_camera(diagnosis))
        return "Something is left over that none of the known effects explains. Whether the finger or the camera makes "
               "it,\nthese records cannot tell: none shows the noise of the camera by itself.";
      if (is_undecided(diagnosis))
        return fmt::format(
            "The declared model may lack something that none of the known effects explains: what is left over {}.",
            noise);
      return "The declared model lacks something, and none of the known effects explains it.";
  }
  return "";
}

std::string parameters_text(const AddedEffect& effect) {
  if (effect.parameters.empty()) return "    (no number of its own)\n";
  TextTable table;
  for (const identification::Estimate& each : effect.parameters) {
    if (each.chosen)
      table.row({each.key, number_text(in_unit(each).value), "(chosen)"});
    else
      table.row(estimate_row(each));
  }
  std::string text = table.text(4, {left, right, left});
  for (const identification::Estimate& each : effect.parameters)
    if (each.has_many_optima)
      text += fmt::format(
          "    {} fits about as well at other values, apart from each other: its interval is coarse. Measure it\n"
          "    at the rig if a design rests on it.\n",
          each.key);
  return text;
}

// How probable it is.
std::string evidence_text(const Diagnosis& diagnosis, const actuator::EffectKind& kind) {
  return fmt::format("    there with a probability of {}\n",
                     probability_text(formats::probability_of(diagnosis, kind)));
}

// What is said beside "noise" of a residual that is larger than the noise was taken to be.
std::string too_large_for_noise(const Diagnosis& diagnosis, const identification::WeighedHypothesis& reported) {
  constexpr double large = 1.2;  // a level that the record itself tells is known to a tenth
  if (reported.probability_of_noise < 0.5 || over_noise(diagnosis, reported.chi_square) < large) return {};
  return "  That is more than the noise is taken to be (above): it is noise only where that level is too low. A still "
         "run\n"
         "  would tell.\n";
}

// What is left over, and whether it is noise.
std::string residual_line(const Diagnosis& diagnosis) {
  const identification::WeighedHypothesis* reported = formats::reported_hypothesis(diagnosis);
  if (reported == nullptr) return {};
  const auto level = [&](double chi_square) { return number_text(over_noise(diagnosis, chi_square)); };
  const std::string without =
      diagnosis.effects.empty()
          ? ""
          : fmt::format(", {} without effects", level(formats::chi_square_without_effects(diagnosis)));
  return fmt::format("  Left over: {} times the noise{} (rms, fit runs). It is noise with a probability of {}.\n",
                     level(reported->chi_square), without, probability_text(reported->probability_of_noise)) +
         too_large_for_noise(diagnosis, *reported);
}

// An effect may do no more than let the declared numbers stay where their tolerances put them.
std::string declared_text(const Diagnosis& diagnosis) {
  if (diagnosis.nominal.empty()) return {};
  const double probability = diagnosis.probability_of_declared;
  const std::string share = probability < 1e-4  ? "fewer than 0.01 %"
                            : probability < 0.1 ? fmt::format("{:.2g} %", 100.0 * probability)
                                                : fmt::format("{:.0f} %", 100.0 * probability);
  return fmt::format(
      "  Without any effect the declared numbers would have to be so far off, all together, that {} of the\n"
      "  rigs built to their tolerances are as far off or further ({}).\n",
      share,
      probability < identification::decision_thresholds.least_probability
          ? "below 1 %: they are off, or an effect is missing"
      : leaves_structure(diagnosis) ? "above 1 %: it is not they that are far off"
      : diagnosis.numbers_off.empty()
          ? "above 1 %: that may be chance"
          : "above 1 %: taken together that may be chance, though the one that is off is none");
}

std::string found_text(const Diagnosis& diagnosis) {
  std::string text = "\nWhat was found\n";
  for (const AddedEffect& each : diagnosis.effects) {
    text += fmt::format("  {}: {}\n", each.kind->id(), each.kind->description());
    text += parameters_text(each);
    text += evidence_text(diagnosis, *each.kind);
  }
  if (diagnosis.effects.empty())
    text += has_unseen_effects(diagnosis) ? "  No effect that moves anything by a tenth of the noise.\n"
                                          : "  No effect that the data support.\n";
  return text + residual_line(diagnosis) + numbers_off_text(diagnosis) + declared_text(diagnosis);
}

// Where no effect was found, the model with the effects is the one that was fitted anew.
std::string comparison_text(const ErrorComparison& comparison, bool any_effect) {
  const units::Unit unit = error_unit(comparison.kind);
  const auto shown = [&](double value) { return number_text(units::from_si(value, unit)); };
  const bool corrected = comparison.corrected.has_value();
  const auto line = [&](const char* name, double Errors::*member) {
    std::vector<std::string> cells{name, shown(comparison.declared.*member), shown(comparison.before.*member)};
    if (any_effect) cells.push_back(shown(comparison.after.*member));
    if (corrected) cells.push_back(shown((*comparison.corrected).*member));
    return cells;
  };
  std::vector<std::string> rmse = line("  rmse", &Errors::rmse);
  rmse.push_back(fmt::format("noise alone: {}", shown(comparison.noise_floor_rmse)));
  TextTable rows;
  std::vector<std::string> head{fmt::format("{}, {}", formats::name_of(comparison.kind), readable_unit(unit.suffix)),
                                "as declared", "fitted anew"};
  if (any_effect) head.emplace_back("with effects");
  if (corrected) head.emplace_back("corrected");
  std::vector<TextTable::Align> columns(head.size(), right);
  columns.front() = left;
  columns.push_back(left);
  rows.row(std::move(head));
  rows.row(line("  mean", &Errors::mae));
  rows.row(std::move(rmse));
  rows.row(line("  largest", &Errors::max));
  return rows.text(2, columns);
}

std::string errors_text(const Diagnosis& diagnosis) {
  const bool validated = !diagnosis.validate_errors.empty();
  const auto& comparisons = validated ? diagnosis.validate_errors : diagnosis.fit_errors;
  if (comparisons.empty()) return {};
  std::string text = validated ? "\nErrors on the runs that no fit has seen\n"
                               : "\nErrors on the fit runs (no run could be kept from the fit)\n";
  for (const ErrorComparison* each : main_first(comparisons))
    text += comparison_text(*each, !diagnosis.effects.empty());
  return text;
}

// Only where something is left over: on a residual that is noise there is nothing to name.
std::string residual_text(const Diagnosis& diagnosis) {
  if (!leaves_structure(diagnosis) || !diagnosis.residual) return {};
  const localise::ResidualTorque& residual = *diagnosis.residual;
  const units::Unit torque = error_unit(data::ChannelKind::torque);
  std::string text = fmt::format("\nWhat is left over, as a joint torque\n  rms {}, where noise alone gives {}\n",
                                 in_unit_text(residual.rms, torque), in_unit_text(residual.noise_floor, torque));
  if (residual.rms < residual.noise_floor)
    text += "  No more than noise makes of it: as a torque its size cannot be read. Look at it in residuals.csv.\n";
  TextTable table;
  for (const localise::Dependence& each : residual.dependences) {
    if (table.rows() == most_dependences || each.explained < least_dependence) break;
    table.row({std::string(each.variable), fmt::format("{:.0f} %", 100.0 * each.explained)});
  }
  if (table.rows() > 0)
    text += "  of its square goes with one variable alone\n" + table.text(4, {left, right});
  else if (!residual.dependences.empty())
    text += "  No single variable explains even a tenth of its square.\n";
  if (residual.frequency) text += fmt::format("  strongest line at {} Hz\n", number_text(*residual.frequency));
  if (!diagnosis.after.where.empty())
    text += fmt::format("  worst in {}: {} times what noise may show\n", diagnosis.after.where,
                        number_text(diagnosis.after.structure));
  return text;
}

// Of records that are none of a moving finger: effects stand in for what the rig did.
std::vector<std::string> records_to_check(const Diagnosis& diagnosis) {
  std::vector<std::string> out;
  if (!diagnosis.unanswered_runs.empty()) {
    const data::Warning& first = diagnosis.unanswered_runs.front();
    out.push_back(fmt::format("CHECK THE RECORDS first. {}: {}.", first.run, first.text));
  }
  if (diagnosis.unanswered_runs.size() > 1)
    out.push_back(
        fmt::format("Alike in {}.", fmt::join(names_of_runs(std::span(diagnosis.unanswered_runs).subspan(1)), ", ")));
  if (!diagnosis.frozen_runs.empty())
    out.push_back(
        fmt::format("CHECK THE CAMERA first. The pictures of {} stand still for a while, and were fitted as if the "
                    "finger had stopped.",
                    fmt::join(diagnosis.frozen_runs, ", ")));
  // Effects that bend the rest pose take the place of a zero: what follows is right only if the zero is.
  if (diagnosis.far_first_pose)
    out.push_back(fmt::format("CHECK THE ZERO of the angle first. {}: {}.", diagnosis.far_first_pose->run,
                              diagnosis.far_first_pose->text));
  return out;
}

std::vector<std::string> cautions_of(const formats::DiagnosisReport& report) {
  const Diagnosis& diagnosis = report.diagnosis;
  std::vector<std::string> out = records_to_check(diagnosis);
  for (std::string sentence : {refusal(report), far_numbers(diagnosis)})
    if (!sentence.empty()) out.push_back(std::move(sentence));
  std::ranges::move(risen_errors(diagnosis), std::back_inserter(out));
  std::ranges::move(errors_beyond_noise(diagnosis), std::back_inserter(out));
  return out;
}

// A section of the summary; nothing where it has no line.
std::string section(std::string_view title, const std::string& text) {
  return text.empty() ? "" : fmt::format("\n{}\n{}", title, text);
}

// Before all else that follows from the data.
std::string warnings_text(const Diagnosis& diagnosis) {
  std::string text;
  for (const data::Warning& each : diagnosis.warnings) {
    const auto is_this = [&](const data::Warning& other) { return other.run == each.run && other.text == each.text; };
    const bool said = (diagnosis.far_first_pose && each.text == diagnosis.far_first_pose->text) ||
                      std::ranges::any_of(diagnosis.unanswered_runs, is_this);
    if (!said) text += fmt::format("  {}{}\n", each.run.empty() ? "" : each.run + ": ", each.text);
  }
  return text.empty() ? "" : "\nWarnings\n" + text;
}

}  // namespace

formats::DiagnosisSummary summary_of(const formats::DiagnosisReport& report) {
  formats::DiagnosisSummary out{.verdict = verdict_sentence(report.diagnosis),
                                .cautions = cautions_of(report),
                                .assumptions = text::lines_of(diagnosis_assumptions(report))};
  std::ranges::replace(out.verdict, '\n', ' ');
  if (report.diagnosis.verdict == Verdict::incomplete) return out;
  out.rivals = text::lines_of(rivals_text(report.diagnosis));
  for (std::string& line : out.rivals) line.erase(0, std::min(line.find_first_not_of(' '), line.size()));
  out.next_steps = next_steps(report);
  return out;
}

std::string to_text(const formats::DiagnosisReport& report) {
  const Diagnosis& diagnosis = report.diagnosis;
  std::string text =
      fmt::format("{}: {}\n\n{}\n", report.dataset, name_of(diagnosis.verdict), verdict_sentence(diagnosis));
  for (const std::string& caution : cautions_of(report)) text += caution + '\n';
  text += warnings_text(diagnosis) + section("What was assumed", diagnosis_assumptions(report));
  if (diagnosis.verdict == Verdict::incomplete) return text + compared_text(diagnosis);
  return text + found_text(diagnosis) + errors_text(diagnosis) +
         fmt::format("\nHow sure, and what else it could be\n{}{}", rivals_text(diagnosis), compared_text(diagnosis)) +
         fmt::format("\nWhat to do next\n  {}\n", fmt::join(next_steps(report), "\n  ")) + residual_text(diagnosis) +
         correction_text(report);
}

}  // namespace coilwright::report
