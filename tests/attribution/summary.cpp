#include "attribution/summary.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <string_view>

#include "truth/hidden_effects.hpp"

namespace attribution {
namespace {

using coilwright::measurement::Verdict;

constexpr double tolerated_error = 1.1;  // times the noise floor

std::string hidden_ids(const Outcome& outcome) {
  std::vector<std::string> ids;
  for (const truth::HiddenEffect& hidden : outcome.answer.hidden) ids.push_back(hidden.id);
  return ids.empty() ? "nothing" : fmt::format("{}", fmt::join(ids, "+"));
}

std::string sets_of(const std::vector<std::vector<std::string>>& sets) {
  std::vector<std::string> texts;
  for (const auto& set : sets) texts.push_back(fmt::format("{}", fmt::join(set, "=")));
  return fmt::format("{}", fmt::join(texts, " "));
}

std::string strengths(const Outcome& outcome, double truth::HiddenEffect::*strength) {
  std::vector<std::string> texts;
  for (const truth::HiddenEffect& hidden : outcome.answer.hidden)
    texts.push_back(fmt::format("{:.2f}", hidden.*strength));
  return fmt::format("{}", fmt::join(texts, "+"));
}

bool keeps_error(const Outcome& outcome) {
  return outcome.error_over_floor && *outcome.error_over_floor <= tolerated_error;
}

// What went wrong with a set; empty if nothing did.
std::string_view fault(const Outcome& outcome) {
  switch (outcome.category) {
    case Category::nothing:
      if (outcome.verdict != Verdict::no_missing_effect) return "false alarm";
      break;
    case Category::one:
    case Category::two:
      if (!outcome.found) return "not found";
      if (outcome.determined && !outcome.alone) return "not alone";
      break;
    case Category::outsider:
      if (outcome.verdict == Verdict::explained) return "outsider explained";
      break;
  }
  if (outcome.verdict == Verdict::explained && !keeps_error(outcome)) return "error after";
  return "";
}

}  // namespace

std::vector<Aim> aims(const std::vector<Outcome>& outcomes) {
  Count alarms, found, visible, alone, both, outsiders, errors, effects, calibration;
  for (const Outcome& outcome : outcomes) {
    switch (outcome.category) {
      case Category::nothing:
        alarms.add(outcome.verdict != Verdict::no_missing_effect);
        break;
      case Category::one:
        found.add(outcome.found);
        if (outcome.answer.hidden.front().visible) visible.add(outcome.found);
        if (outcome.determined) alone.add(outcome.alone);
        break;
      case Category::two:
        both.add(outcome.found);
        break;
      case Category::outsider:
        outsiders.add(outcome.verdict != Verdict::explained);
        break;
    }
    if (outcome.verdict == Verdict::explained) errors.add(keeps_error(outcome));
    effects += outcome.effect_intervals;
    calibration += outcome.calibration_intervals;
  }
  return {
      {.text = "false alarms where nothing is hidden", .count = alarms, .share = 0.05, .at_most = true},
      {.text = "hidden effect first, or in the ambiguity set reported with it", .count = found, .share = 0.9},
      {.text = "  the same where the noise lets it be seen at all", .count = visible, .share = 0.9},
      {.text = "alone and right, where the data determine it", .count = alone, .share = 0.8},
      {.text = "both of two", .count = both, .share = 0.7},
      {.text = "outsiders not explained", .count = outsiders, .share = 0.9},
      {.text = "error after at most 1.1 of the noise, where explained", .count = errors, .share = 1.0},
      {.text = "true effect parameters inside the 95 % intervals", .count = effects, .share = 0.9},
      {.text = "true stiffness and damping inside the 95 % intervals", .count = calibration, .share = 0.9},
  };
}

std::string set_line(const Outcome& outcome) {
  const std::string_view wrong = fault(outcome);
  return fmt::format("{:>4} {:<8} {:<42} {:>11}  {:<17} {:<42}{}{}", outcome.number, name_of(outcome.category),
                     hidden_ids(outcome), strengths(outcome, &truth::HiddenEffect::strength_after_calibration),
                     name_of(outcome.verdict), fmt::format("{}", fmt::join(outcome.reported, "+")),
                     outcome.ambiguous.empty() ? "" : fmt::format(" [{}]", sets_of(outcome.ambiguous)),
                     wrong.empty() ? "" : fmt::format(" <- {}", wrong));
}

std::string summary(const std::vector<Outcome>& outcomes) {
  std::string text = fmt::format("{} sets\n\n", outcomes.size());
  for (const Aim& aim : aims(outcomes)) {
    const double share = aim.count.of == 0 ? 0.0 : 100.0 * aim.count.hits / aim.count.of;
    fmt::format_to(std::back_inserter(text), "{:<64} {:>4} of {:<4} {:>5.1f} %  at {} {:>3.0f} %  {}\n", aim.text,
                   aim.count.hits, aim.count.of, share, aim.at_most ? "most " : "least", 100.0 * aim.share,
                   aim.reached() ? "reached" : "MISSED");
  }
  text += "\nwhere something went wrong (strength: standard deviations of the noise, after calibration)\n";
  for (const Outcome& outcome : outcomes)
    if (!fault(outcome).empty()) text += set_line(outcome) + "\n";
  return text;
}

std::string sets_csv(const std::vector<Outcome>& outcomes) {
  std::string text =
      "set,category,hidden,strength,strength_after_calibration,determined,verdict,reported,indistinguishable,found,"
      "alone,error_over_floor,effect_intervals_hit,effect_intervals,calibration_intervals_hit,calibration_intervals\n";
  for (const Outcome& outcome : outcomes)
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", outcome.number,
                   name_of(outcome.category), hidden_ids(outcome), strengths(outcome, &truth::HiddenEffect::strength),
                   strengths(outcome, &truth::HiddenEffect::strength_after_calibration), outcome.determined ? 1 : 0,
                   name_of(outcome.verdict), fmt::join(outcome.reported, "+"), sets_of(outcome.ambiguous),
                   outcome.found ? 1 : 0, outcome.alone ? 1 : 0,
                   outcome.error_over_floor ? fmt::format("{:.3f}", *outcome.error_over_floor) : "",
                   outcome.effect_intervals.hits, outcome.effect_intervals.of, outcome.calibration_intervals.hits,
                   outcome.calibration_intervals.of);
  return text;
}

std::string confusion_csv(const std::vector<Outcome>& outcomes) {
  std::vector<std::string> columns;
  for (const truth::HiddenKind& kind : truth::hidden_kinds())
    if (!kind.outsider()) columns.push_back(kind.id);
  for (const Verdict none : {Verdict::no_missing_effect, Verdict::unexplained}) columns.emplace_back(name_of(none));
  std::vector<std::string> rows{"nothing"};
  for (const truth::HiddenKind& kind : truth::hidden_kinds()) rows.push_back(kind.id);
  std::map<std::string, std::map<std::string, int>> counts;
  for (const Outcome& outcome : outcomes) {
    if (outcome.answer.hidden.size() > 1) continue;
    const std::string first =
        outcome.reported.empty() ? std::string(name_of(outcome.verdict)) : outcome.reported.front();
    if (std::find(columns.begin(), columns.end(), first) == columns.end()) columns.push_back(first);
    ++counts[hidden_ids(outcome)][first];
  }
  std::string text = fmt::format("hidden,{}\n", fmt::join(columns, ","));
  for (const std::string& row : rows) {
    text += row;
    for (const std::string& column : columns) fmt::format_to(std::back_inserter(text), ",{}", counts[row][column]);
    text += '\n';
  }
  return text;
}

}  // namespace attribution
