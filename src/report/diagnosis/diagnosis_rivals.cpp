#include "report/diagnosis/diagnosis_parts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <string_view>

#include "coilwright/formats/data/diagnosis_formatting.hpp"
#include "coilwright/report/simulation/text_table.hpp"

namespace coilwright::report {

namespace {

using formats::ids;
using namespace measurement;
using enum TextTable::Align;

constexpr std::size_t most_candidates = 5;
constexpr double near_residual = 0.02;  // of the rms residual: models are not known better
constexpr std::size_t most_near = 3;
constexpr std::size_t most_hinted = 3;

using identification::are_among;
using identification::WeighedHypothesis;

// Whether an effect was compared with other numbers of it, too.
bool has_forms(const identification::Posterior& odds, const actuator::EffectKind* kind) {
  const auto is_another = [kind](const actuator::EffectKind* each) { return each != kind && each->id() == kind->id(); };
  return std::ranges::any_of(
      odds.hypotheses, [&](const WeighedHypothesis& each) { return std::ranges::any_of(each.effects, is_another); });
}

// The id of an effect; where it has forms, with how many numbers it is meant.
std::string name_among(const identification::Posterior& odds, const actuator::EffectKind* kind) {
  return has_forms(odds, kind) ? fmt::format("{} ({})", kind->id(), counted(kind->parameters().size(), "number"))
                               : std::string(kind->id());
}

// What a hypothesis is called in a sentence: "a + b".
std::string hypothesis(const identification::Posterior& odds, const WeighedHypothesis& candidate) {
  if (candidate.effects.empty()) return "no effect";
  std::vector<std::string> names;
  for (const actuator::EffectKind* kind : candidate.effects) names.push_back(name_among(odds, kind));
  return fmt::format("{}", fmt::join(names, " + "));
}

// Whether what a hypothesis leaves over differs so little from what the reported one leaves that a small error of the
// model, of the noise or of a declared number could have decided between them.
bool is_near(const WeighedHypothesis& rival, const WeighedHypothesis& reported) {
  return std::sqrt(rival.chi_square / reported.chi_square) < 1.0 + near_residual;
}

// Whether it is made of reported effects and of those that stand in a set with one: said already.
bool is_told(const Diagnosis& diagnosis, const WeighedHypothesis& rival, const WeighedHypothesis& reported) {
  return std::ranges::all_of(rival.effects, [&](const actuator::EffectKind* each) {
    const auto has = [each](const auto& kinds) { return std::ranges::find(kinds, each) != kinds.end(); };
    return has(reported.effects) || std::ranges::any_of(diagnosis.indistinguishable, has);
  });
}

// Those that these data refute by little, and how each of them shows itself at the rig.
std::string near_rivals_text(const Diagnosis& diagnosis) {
  const WeighedHypothesis* reported = formats::reported_hypothesis(diagnosis);
  if (diagnosis.effects.empty() || reported == nullptr) return {};
  std::string text;
  std::size_t count = 0;
  for (const WeighedHypothesis& each : diagnosis.odds.hypotheses) {
    // With more effects than those reported it is no other explanation.
    if (!is_near(each, *reported) || are_among(reported->effects, each.effects)) continue;
    if (is_told(diagnosis, each, *reported)) continue;
    if (++count > most_near) break;
    text += fmt::format("    {} (residual {}, where what is reported leaves {})\n", hypothesis(diagnosis.odds, each),
                        number_text(over_noise(diagnosis, each.chi_square)),
                        number_text(over_noise(diagnosis, reported->chi_square)));
    for (const actuator::EffectKind* kind : each.effects) {
      if (std::ranges::find(reported->effects, kind) != reported->effects.end()) continue;
      // A reported effect with other numbers shows itself as that one does: what it is tells more.
      const bool is_other_form = are_among({kind}, reported->effects);
      const std::string_view line = is_other_form ? kind->description() : kind->check();
      if (!line.empty()) text += fmt::format("      {}\n", line);
    }
  }
  if (text.empty()) return {};
  return "  Nearly as good, so that a small error of the model may have decided; how to see each at the rig:\n" + text;
}

// Hypotheses that may be true in place of the reported one, and are in no set that was named.
std::string alive_text(const Diagnosis& diagnosis) {
  constexpr double worth_naming = 0.05;
  const WeighedHypothesis* reported = formats::reported_hypothesis(diagnosis);
  if (reported == nullptr) return {};
  std::string text;
  for (const WeighedHypothesis& each : diagnosis.odds.hypotheses) {
    const bool has_less = each.effects.size() < reported->effects.size();
    if (each.probability < worth_naming || &each == reported) continue;
    if (!has_less && !are_among(reported->effects, each.effects) && is_told(diagnosis, each, *reported)) continue;
    text += fmt::format("    {}, with a probability of {}\n", hypothesis(diagnosis.odds, each),
                        probability_text(each.probability));
  }
  if (text.empty()) return {};
  return "  Not to be ruled out:\n" + text;
}

// What may be there beside what is reported, and what that would do.
std::string hinted_text(const Diagnosis& diagnosis) {
  if (diagnosis.hinted.empty()) return {};
  std::string text =
      "  One more effect may be there that these data hint at, too weakly to be reported. All intervals have in them "
      "what it would do:\n";
  for (const identification::HintedEffect& each :
       std::span(diagnosis.hinted).first(std::min(diagnosis.hinted.size(), most_hinted)))
    text += fmt::format("    {}: the interval of {} is {:.1f} times wider for its sake\n", each.kind->id(), each.number,
                        each.wider);
  return text;
}

// Effects of which these records tell nothing.
std::string not_tested_text(const Diagnosis& diagnosis) {
  constexpr std::size_t a_line = 5;
  const std::vector<std::string> all = ids(diagnosis.odds.not_tested());
  if (all.empty()) return {};
  std::string text = "  Not tested by these records, in which they would change nothing, and not ruled out:\n";
  for (std::size_t i = 0; i < all.size(); i += a_line)
    text += fmt::format("    {}\n", fmt::join(std::span(all).subspan(i, std::min(a_line, all.size() - i)), ", "));
  return text;
}

std::string remark_of(const WeighedHypothesis& hypothesis, bool is_reported) {
  if (hypothesis.at_optimum) return is_reported ? "reported" : "";
  return is_reported ? "reported, at least" : "at least";
}

}  // namespace

void add_compared(Section& section, const Diagnosis& diagnosis) {
  const std::vector<WeighedHypothesis>& all = diagnosis.odds.hypotheses;
  if (all.empty()) return;
  const WeighedHypothesis* reported = formats::reported_hypothesis(diagnosis);
  // Of a diagnosis that was interrupted the values are not counted: by what the recalibrated model leaves of them.
  const double declared = formats::chi_square_without_effects(diagnosis);
  const bool has_answer = diagnosis.verdict != Verdict::incomplete;
  const auto residual_of = [&](const WeighedHypothesis& each) {
    return !has_answer ? diagnosis.before.level * std::sqrt(each.chi_square / declared)
                       : over_noise(diagnosis, each.chi_square);
  };
  BarChart chart{.id = "ranking",
                 .title = "The most probable hypotheses",
                 .description = "Given that one of those that were fitted is true.",
                 .value_title = "probability",
                 .label_title = "effects"};
  TableBlock block{.caption = "Compared, most probable first",
                   .table = {.header = {"", "probability", "residual", "leaves noise", ""}},
                   .align = {left, right, right, right, left},
                   .further_in = 2};
  std::size_t count = 0;
  bool shows_forms = false, shows_bounds = false;
  for (const WeighedHypothesis& each : all) {
    if (count >= most_candidates && &each != reported && !each.effects.empty()) continue;
    ++count;
    shows_forms = shows_forms || std::ranges::any_of(each.effects, [&](const actuator::EffectKind* kind) {
                    return has_forms(diagnosis.odds, kind);
                  });
    shows_bounds = shows_bounds || (has_answer && !each.at_optimum);
    const std::string name = hypothesis(diagnosis.odds, each);
    block.table.rows.push_back({name, probability_text(each.probability), number_text(residual_of(each)),
                                probability_text(each.probability_of_noise),
                                has_answer ? remark_of(each, &each == reported) : ""});
    if (std::isfinite(each.probability))
      chart.bars.push_back({.label = name, .value = each.probability, .group = "compared"});
  }
  const std::string_view given = !has_answer ? "among those that were compared so far, by brief fits"
                                 : all.front().probability_of_noise < 0.5
                                     ? "to be nearest, among those that were fitted; each lacks something"
                                     : "given that one of those that were fitted is true";
  section.say("  Compared, most probable first\n");
  if (!chart.bars.empty()) section.blocks.emplace_back(std::move(chart));
  section.blocks.emplace_back(std::move(block));
  section.say(
      std::string(shows_forms ? "  (n numbers): the effect with so many of its numbers fitted; the others are as "
                                "if absent.\n"
                              : "") +
      (shows_bounds ? "  at least: its fit is not shown to be at its best, and its evidence is a lower bound.\n" : "") +
      fmt::format("  probability: {}. residual: rms on the fit runs over the noise, 1 is noise alone. leaves "
                  "noise: the probability that what is lacking is less than a tenth of the noise.\n",
                  given));
}

bool has_unseen_effects(const Diagnosis& diagnosis) {
  constexpr double most_doubt = 1.0 / (1.0 + identification::Losses{}.false_name);
  const WeighedHypothesis* reported = formats::reported_hypothesis(diagnosis);
  if (reported == nullptr || diagnosis.verdict == Verdict::incomplete) return false;
  return diagnosis.odds.probability_among(reported->effects) <= most_doubt;
}

std::string rivals_text(const Diagnosis& diagnosis) {
  std::string text;
  for (const auto& set : diagnosis.indistinguishable) {
    std::vector<std::string> names;
    for (const actuator::EffectKind* kind : set)
      names.push_back(fmt::format("{} {}", kind->id(), probability_text(diagnosis.odds.probability_of_any({kind}))));
    text += fmt::format("  One of these is there: {} ({}). These data cannot tell which; the first is reported.\n",
                        probability_text(diagnosis.odds.probability_of_any(set)), fmt::join(names, ", "));
  }
  const std::string near = near_rivals_text(diagnosis);
  const std::string alive = alive_text(diagnosis);
  text += near + alive;
  if (has_unseen_effects(diagnosis))
    text +=
        "  More than what is reported is there, most probably, but moves nothing by more than a tenth of the noise.\n";
  if (!diagnosis.effects.empty() && diagnosis.indistinguishable.empty() && near.empty() && alive.empty())
    text += "  Nothing else that was tried explains these data as well.\n";
  if (const std::size_t ruled_out = diagnosis.odds.ruled_out.size() - diagnosis.odds.not_tested().size())
    text += fmt::format("  Without a probability: {}, for reasons in diagnosis.json (ruled_out).\n",
                        counted(ruled_out, "effect"));
  return text + not_tested_text(diagnosis) + hinted_text(diagnosis);
}

}  // namespace coilwright::report
