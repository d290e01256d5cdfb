#include "report/diagnosis_parts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "coilwright/formats/data/diagnosis_formatting.hpp"
#include "coilwright/measurement/compare/decision_thresholds.hpp"
#include "coilwright/report/text_table.hpp"

namespace coilwright::report {
namespace {

using formats::ids;
using namespace measurement;
using enum TextTable::Align;

constexpr std::size_t most_candidates = 5;
constexpr double near_residual = 0.02;  // of the rms residual: models are not known better
constexpr std::size_t most_near = 3;
constexpr std::size_t most_hinted = 3;
constexpr double least_odds = 0.01;

using Compared = std::vector<compare::ComparedHypothesis>;

// The id of an effect; where it was compared with further numbers too, with how many it is meant to have.
std::string name_among(const Compared& compared, const actuator::EffectKind* kind) {
  const auto is_another = [kind](const actuator::EffectKind* each) { return each != kind && each->id() == kind->id(); };
  const bool is_twice = std::ranges::any_of(
      compared, [&](const compare::ComparedHypothesis& each) { return std::ranges::any_of(each.effects, is_another); });
  return is_twice ? fmt::format("{} ({})", kind->id(), counted(kind->parameters().size(), "number"))
                  : std::string(kind->id());
}

// What a hypothesis is called in a sentence: "a + b".
std::string hypothesis(const Compared& compared, const compare::ComparedHypothesis& candidate) {
  if (candidate.effects.empty()) return "no effect";
  std::vector<std::string> names;
  for (const actuator::EffectKind* kind : candidate.effects) names.push_back(name_among(compared, kind));
  return fmt::format("{}", fmt::join(names, " + "));
}

// Whether what a hypothesis leaves over differs so little from what the reported one leaves that a small error of the
// model, of the noise or of a declared number could have decided between them.
bool is_near(const compare::ComparedHypothesis& rival, const compare::ComparedHypothesis& reported) {
  return rival.evidence && rival.remark.empty() &&
         std::sqrt(rival.evidence->chi_square_after / reported.evidence->chi_square_after) < 1.0 + near_residual;
}

bool has_all(const std::vector<const actuator::EffectKind*>& some, const std::vector<const actuator::EffectKind*>& of) {
  return std::ranges::all_of(of, [&](const actuator::EffectKind* each) {
    return std::ranges::any_of(some, [&](const actuator::EffectKind* one) { return one->id() == each->id(); });
  });
}

// Whether it is made of reported effects and of those that stand in a set with one: said already.
bool is_told(const Diagnosis& diagnosis, const compare::ComparedHypothesis& rival,
             const compare::ComparedHypothesis& reported) {
  return std::ranges::all_of(rival.effects, [&](const actuator::EffectKind* each) {
    const auto has = [each](const auto& kinds) { return std::ranges::find(kinds, each) != kinds.end(); };
    return has(reported.effects) || std::ranges::any_of(diagnosis.indistinguishable, has);
  });
}

// The one that is reported; the end where it was not compared.
auto reported_among(const std::vector<compare::ComparedHypothesis>& compared, const Diagnosis& diagnosis) {
  return std::ranges::find_if(compared, [&](const compare::ComparedHypothesis& each) {
    return formats::is_reported(diagnosis, each.effects) && each.evidence;
  });
}

std::string probability_text(double probability) {
  if (probability > 0.999) return "above 0.999";
  if (probability < 0.001) return "below 0.001";
  return fmt::format("{:.3f}", probability);
}

// The leading hypotheses, the reported one and that of no effect.
std::string odds_text(const Diagnosis& diagnosis) {
  const std::vector<compare::WeighedHypothesis>& all = diagnosis.odds.hypotheses;
  if (all.empty()) return {};
  TextTable table;
  std::size_t count = 0;
  for (const compare::WeighedHypothesis& each : all) {
    const bool is_reported = formats::is_reported(diagnosis, each.effects);
    const bool leads = count < most_candidates && each.probability >= least_odds;
    if (!leads && !is_reported && !each.effects.empty()) continue;
    ++count;
    table.row({hypothesis(diagnosis.compared_hypotheses, {.effects = each.effects}), probability_text(each.probability),
               is_reported ? "reported" : ""});
  }
  return fmt::format("  How probable, given that one of those that were fitted is true{}\n",
                     diagnosis.after.is_white() ? "" : "; but none of them leaves noise") +
         table.text(4, {left, right, left});
}

// Those that these data refute by little, and how each of them shows itself at the rig.
std::string near_rivals_text(const Diagnosis& diagnosis) {
  const auto compared = formats::compared_as_reported(diagnosis);
  const auto reported = reported_among(compared, diagnosis);
  if (diagnosis.effects.empty() || reported == compared.end()) return {};
  std::string text;
  std::size_t count = 0;
  for (const compare::ComparedHypothesis& each : compared) {
    // With more effects than those reported it is no other explanation.
    if (!is_near(each, *reported) || has_all(each.effects, reported->effects)) continue;
    if (is_told(diagnosis, each, *reported)) continue;
    if (++count > most_near) break;
    text += fmt::format("    {} (residual {}, where what is reported leaves {})\n", hypothesis(compared, each),
                        number_text(over_noise(diagnosis, each.evidence->chi_square_after)),
                        number_text(over_noise(diagnosis, reported->evidence->chi_square_after)));
    for (const actuator::EffectKind* kind : each.effects) {
      if (std::ranges::find(reported->effects, kind) != reported->effects.end()) continue;
      // A reported effect with other numbers shows itself as that one does: what it is tells more.
      const bool is_other_form = has_all(reported->effects, {kind});
      const std::string_view line = is_other_form ? kind->description() : kind->check();
      if (!line.empty()) text += fmt::format("      {}\n", line);
    }
  }
  if (text.empty()) return {};
  return "  Worse by little, so that a small error of the model may have decided; how to see each at the rig:\n" + text;
}

// Whether a hypothesis with more effects than those reported has a larger gain, which decides nothing by itself.
bool gains_with_more(const Diagnosis& diagnosis) {
  const auto compared = formats::compared_as_reported(diagnosis);
  const auto reported = reported_among(compared, diagnosis);
  return reported != compared.end() && std::ranges::any_of(compared, [&](const compare::ComparedHypothesis& each) {
           return each.evidence && each.effects.size() > reported->effects.size() &&
                  each.evidence->criterion_gain > reported->evidence->criterion_gain;
         });
}

// What may be there beside what is reported, and what that would do.
std::string hinted_text(const Diagnosis& diagnosis) {
  if (diagnosis.hinted.empty()) return {};
  std::string text =
      "  One more effect may be there that these data hint at, too weakly to be reported. All intervals have in them\n"
      "  what it would do:\n";
  for (const compare::HintedEffect& each :
       std::span(diagnosis.hinted).first(std::min(diagnosis.hinted.size(), most_hinted)))
    text += fmt::format("    {} (gain {:.1f}): the interval of {} is {:.1f} times wider for its sake\n",
                        each.kind->id(), each.gain, each.number, each.wider);
  return text;
}

}  // namespace

std::string compared_text(const Diagnosis& diagnosis) {
  const auto compared = formats::compared_as_reported(diagnosis);
  if (compared.empty()) return {};
  TextTable table;
  table.row({"", "residual", "gain", ""});
  // Of one that is not the answer its neighbours in rank are not either, though nothing else speaks against them.
  const auto remark_of = [&](const compare::ComparedHypothesis& each) -> std::string {
    if (formats::is_reported(diagnosis, each.effects)) return "reported";
    const compare::ComparedHypothesis& first = compared.front();
    const bool as_good =
        &each != &first && each.evidence && first.evidence && !first.remark.empty() &&
        first.evidence->criterion_gain - each.evidence->criterion_gain < compare::decision_thresholds.decisive_gain;
    return each.remark.empty() && as_good ? "these data do not tell it from the first of this list" : each.remark;
  };
  // Of a diagnosis that was interrupted the values are not counted: by what the recalibrated model leaves of them.
  const auto residual_of = [&](const compare::Evidence& evidence) {
    return diagnosis.verdict == Verdict::incomplete
               ? diagnosis.before.level * std::sqrt(evidence.chi_square_after / evidence.chi_square_before)
               : over_noise(diagnosis, evidence.chi_square_after);
  };
  for (const compare::ComparedHypothesis& each : std::span(compared).first(std::min(compared.size(), most_candidates)))
    table.row({hypothesis(compared, each), each.evidence ? number_text(residual_of(*each.evidence)) : "none",
               each.evidence ? fmt::format("{:.1f}", each.evidence->criterion_gain) : "none", remark_of(each)});
  return "  Compared, best first\n" + table.text(4, {left, right, right, left}) +
         "  residual: rms on the fit runs over the noise, 1 is noise alone. gain: how much better than the declared "
         "model\n  fitted anew, each further number charged: a lead of 6 is odds of 20 to 1, less decides nothing; "
         "below 0 it\n"
         "  explains less than its numbers cost. It counts every sample, so that a small steady difference decides. "
         "Those far\n"
         "  behind the best were fitted briefly: their gain may be larger.\n";
}

std::string rivals_text(const Diagnosis& diagnosis) {
  std::string text = odds_text(diagnosis);
  for (const auto& set : diagnosis.indistinguishable)
    text += fmt::format("  These data cannot tell apart: {}. The simplest of them is reported.\n",
                        fmt::join(ids(set), ", "));
  const std::string near = near_rivals_text(diagnosis);
  text += near;
  if (!diagnosis.effects.empty() && diagnosis.indistinguishable.empty() && near.empty())
    text += fmt::format("  Nothing else that was tried explains these data as well{}.\n",
                        gains_with_more(diagnosis) ? " with as few effects" : "");
  return text + hinted_text(diagnosis);
}

}  // namespace coilwright::report
