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

// What effects are worth that leave more than noise, where nothing was fitted. That the error rises is said elsewhere.
std::string worth_sentence(const Diagnosis& diagnosis) {
  if (diagnosis.validate_errors.empty() || !risen_errors(diagnosis).empty()) return "";
  const ErrorComparison& errors = *formats::main_first(diagnosis.validate_errors).front();
  const units::Unit unit = error_unit(errors.kind);
  const auto in = [&](double value) { return number_text(units::from_si(value, unit)); };
  const double noise = errors.noise_floor_rmse;
  return fmt::format(" On the runs that no fit has seen {} the error of the {} from {} to {} (rmse{}).",
                     diagnosis.effects.size() == 1 ? "it takes" : "they take", formats::name_of(errors.kind),
                     in(errors.before.rmse), in_unit_text(errors.after.rmse, unit),
                     noise > 0.0 ? "; noise alone: " + in(noise) : "");
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
                           noise) +
               worth_sentence(diagnosis);
      return fmt::format("The declared model lacks {}, and something else: structure remains that no effect explains.",
                         effects) +
             worth_sentence(diagnosis);
    case Verdict::incomplete:
      return "INTERRUPTED before there was a conclusion. The declared model was fitted anew, and its effects compared "
             "as far as the list below; nothing is known of runs that no fit has seen. Diagnose again, with --resume, "
             "for an answer.";
    case Verdict::unexplained:
      if (may_be_the_camera(diagnosis))
        return "Something is left over that none of the known effects explains. Whether the finger or the camera makes "
               "it, these records cannot tell: none shows the noise of the camera by itself.";
      if (is_undecided(diagnosis))
        return fmt::format(
            "The declared model may lack something that none of the known effects explains: what is left over {}.",
            noise);
      return "The declared model lacks something, and none of the known effects explains it.";
  }
  return "";
}

void add_parameters(Section& section, const AddedEffect& effect) {
  if (effect.parameters.empty()) return section.say("    (no number of its own)\n");
  TableBlock block{.caption = fmt::format("Numbers of {}", effect.kind->id()),
                   .table = {.header = {"number", "value", "95 % interval"}},
                   .align = {left, right, left},
                   .headed = false,
                   .further_in = 2};
  for (const identification::Estimate& each : effect.parameters)
    block.table.rows.push_back(each.chosen
                                   ? std::vector<std::string>{each.key, number_text(in_unit(each).value), "(chosen)"}
                                   : estimate_row(each));
  section.blocks.emplace_back(std::move(block));
  for (const identification::Estimate& each : effect.parameters)
    if (each.has_many_optima)
      section.say(fmt::format(
          "    {} fits about as well at other values, apart from each other: its interval is coarse. Measure it at the "
          "rig if a design rests on it.\n",
          each.key));
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
         "run would tell.\n";
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
      "  Without any effect the declared numbers would have to be so far off, all together, that {} of the "
      "rigs built to their tolerances are as far off or further ({}).\n",
      share,
      probability < identification::decision_thresholds.least_probability
          ? "below 1 %: they are off, or an effect is missing"
      : leaves_structure(diagnosis) ? "above 1 %: it is not they that are far off"
      : diagnosis.numbers_off.empty()
          ? "above 1 %: that may be chance"
          : "above 1 %: taken together that may be chance, though the one that is off is none");
}

Section found_section(const Diagnosis& diagnosis) {
  Section section{.id = "effects", .title = "What was found"};
  for (const AddedEffect& each : diagnosis.effects) {
    section.say(fmt::format("  {}: {}\n", each.kind->id(), each.kind->description()));
    add_parameters(section, each);
    section.say(evidence_text(diagnosis, *each.kind));
  }
  if (diagnosis.effects.empty())
    section.say(has_unseen_effects(diagnosis) ? "  No effect that moves anything by a tenth of the noise.\n"
                                              : "  No effect that the data support.\n");
  section.say(residual_line(diagnosis) + numbers_off_text(diagnosis) + declared_text(diagnosis));
  return section;
}

// Where no effect was found, the model with the effects is the one that was fitted anew.
TableBlock comparison_table(const ErrorComparison& comparison, bool any_effect) {
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
  TableBlock block{.caption = fmt::format("Errors of the {}", formats::name_of(comparison.kind))};
  std::vector<std::string>& head =
      block.table.header = {fmt::format("{}, {}", formats::name_of(comparison.kind), readable_unit(unit.suffix)),
                            "as declared", "fitted anew"};
  if (any_effect) head.emplace_back("with effects");
  if (corrected) head.emplace_back("corrected");
  block.align.assign(head.size(), right);
  block.align.front() = left;
  block.align.push_back(left);
  head.emplace_back();
  block.table.rows = {line("  mean", &Errors::mae), std::move(rmse), line("  largest", &Errors::max)};
  block.table.rows[0].emplace_back();
  block.table.rows[2].emplace_back();
  return block;
}

Section errors_section(const Diagnosis& diagnosis) {
  const bool validated = !diagnosis.validate_errors.empty();
  Section section{.id = "errors",
                  .title = validated ? "Errors on the runs that no fit has seen"
                                     : "Errors on the fit runs (no run could be kept from the fit)"};
  for (const ErrorComparison* each : main_first(validated ? diagnosis.validate_errors : diagnosis.fit_errors))
    section.blocks.emplace_back(comparison_table(*each, !diagnosis.effects.empty()));
  return section;
}

// Only where something is left over: on a residual that is noise there is nothing to name.
Section residual_section(const Diagnosis& diagnosis) {
  Section section{.id = "leftover", .title = "What is left over, as a joint torque"};
  if (!leaves_structure(diagnosis) || !diagnosis.residual) return section;
  const localise::ResidualTorque& residual = *diagnosis.residual;
  const units::Unit torque = error_unit(data::ChannelKind::torque);
  section.say(fmt::format("  rms {}, where noise alone gives {}\n", in_unit_text(residual.rms, torque),
                          in_unit_text(residual.noise_floor, torque)));
  if (residual.rms < residual.noise_floor)
    section.say(
        "  No more than noise makes of it: as a torque its size cannot be read. Look at it in residuals.csv.\n");
  TableBlock block{.caption = "What its square goes with",
                   .table = {.header = {"variable", "share"}},
                   .align = {left, right},
                   .headed = false,
                   .further_in = 2};
  for (const localise::Dependence& each : residual.dependences) {
    if (block.table.rows.size() == most_dependences || each.explained < least_dependence) break;
    block.table.rows.push_back({std::string(each.variable), fmt::format("{:.0f} %", 100.0 * each.explained)});
  }
  if (!block.table.rows.empty()) {
    section.say("  of its square goes with one variable alone\n");
    section.blocks.emplace_back(std::move(block));
  } else if (!residual.dependences.empty()) {
    section.say("  No single variable explains even a tenth of its square.\n");
  }
  if (residual.frequency) section.say(fmt::format("  strongest line at {} Hz\n", number_text(*residual.frequency)));
  if (!diagnosis.after.where.empty())
    section.say(fmt::format("  worst in {}: {} times what noise may show\n", diagnosis.after.where,
                            number_text(diagnosis.after.structure)));
  return section;
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

// Before all else that follows from the data.
Section warnings_section(const Diagnosis& diagnosis) {
  Section section{.id = "warnings", .title = "Warnings"};
  for (const data::Warning& each : diagnosis.warnings) {
    const auto is_this = [&](const data::Warning& other) { return other.run == each.run && other.text == each.text; };
    const bool said = (diagnosis.far_first_pose && each.text == diagnosis.far_first_pose->text) ||
                      std::ranges::any_of(diagnosis.unanswered_runs, is_this);
    if (!said) section.say(fmt::format("  {}{}\n", each.run.empty() ? "" : each.run + ": ", each.text));
  }
  return section;
}

}  // namespace

Document document_of(const formats::DiagnosisReport& report) {
  const Diagnosis& diagnosis = report.diagnosis;
  Document out{.title = fmt::format("{}: {}", report.dataset, name_of(diagnosis.verdict)),
               .verdict = verdict_sentence(diagnosis)};
  for (const std::string& caution : cautions_of(report)) out.cautions.push_back(caution + '\n');
  Section rivals{.id = "rivals", .title = "How sure, and what else it could be"};
  if (diagnosis.verdict != Verdict::incomplete) rivals.say(rivals_text(diagnosis));
  add_compared(rivals, diagnosis);
  out.sections = {warnings_section(diagnosis), assumptions_section(report)};
  if (diagnosis.verdict == Verdict::incomplete) {
    out.sections.push_back(std::move(rivals));
    return out;
  }
  Section next{.id = "next", .title = "What to do next"};
  next.say(fmt::format("  {}\n", fmt::join(next_steps(report), "\n  ")));
  for (Section& each : std::vector<Section>{found_section(diagnosis), errors_section(diagnosis), std::move(rivals),
                                            std::move(next), residual_section(diagnosis), correction_section(report)})
    out.sections.push_back(std::move(each));
  return out;
}

}  // namespace coilwright::report
