#include "attribution/laboratory/summary.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <map>

namespace attribution::laboratory {
namespace {

constexpr double tolerated_error = 1.1;        // times the noise
constexpr double tolerated_correction = 1.02;  // times the error before

bool keeps_error(const Outcome& outcome) {
  return outcome.after_over_noise && *outcome.after_over_noise <= tolerated_error;
}

std::string list(const std::vector<std::string>& ids) {
  return ids.empty() ? "nothing" : fmt::format("{}", fmt::join(ids, "+"));
}

std::string sets_of(const std::vector<std::vector<std::string>>& sets) {
  std::vector<std::string> texts;
  for (const auto& set : sets) texts.push_back(fmt::format("{}", fmt::join(set, "=")));
  return fmt::format("{}", fmt::join(texts, " "));
}

// "3/40", or nothing where there is none.
std::string fraction(const Count& count) {
  return count.of == 0 ? "" : fmt::format("{}/{}", count.hits, count.of);
}

std::string line_of(const Figure& figure) {
  if (figure.count.of == 0) return fmt::format("{:<66} no sets\n", figure.text);
  const double percent = 100.0 * figure.count.hits / figure.count.of;
  return fmt::format("{:<66} {:>4} of {:<4} {:>5.1f} %  at {} {:>3.0f} %  {}\n", figure.text, figure.count.hits,
                     figure.count.of, percent, figure.at_most ? "most " : "least", 100.0 * figure.share,
                     figure.reached() ? "reached" : "MISSED");
}

// What was stated, in five bins, and how often it was so; of an outsider no effect is there.
std::string reliability(const std::vector<Outcome>& outcomes) {
  constexpr int bins = 5;
  std::string text = "\nstated probabilities of effects: how many there were, their mean, and how many are there\n";
  for (const bool outsiders : {false, true})
    for (int bin = 0; bin < bins; ++bin) {
      Count there;
      double sum = 0.0;
      for (const Outcome& outcome : outcomes) {
        if ((outcome.category == "outsider") != outsiders) continue;
        for (const StatedOdds& each : outcome.odds) {
          if (std::min(bins - 1, static_cast<int>(bins * each.probability)) != bin) continue;
          there.add(each.is_there);
          sum += each.probability;
        }
      }
      if (there.of == 0) continue;
      text += fmt::format("{:<12}{:.1f} to {:.1f}  {:>4}  stated {:>5.1f} %  there {:>5.1f} %\n",
                          outsiders ? "outsiders" : "", 1.0 * bin / bins, (1.0 + bin) / bins, there.of,
                          100.0 * sum / there.of, 100.0 * there.hits / there.of);
    }
  return text;
}

// Sets by each of their conditions, those with all faults at once, and all.
std::map<std::string, std::vector<Outcome>> by_condition(const std::vector<Outcome>& outcomes) {
  std::map<std::string, std::vector<Outcome>> out;
  for (const Outcome& outcome : outcomes) {
    if (outcome.conditions.size() >= 7) {
      out["all at once"].push_back(outcome);
      continue;
    }
    if (outcome.conditions.size() == 2 && outcome.category != "colour_unknown") out["in pairs"].push_back(outcome);
    for (const std::string& condition : outcome.conditions) out[condition].push_back(outcome);
  }
  return out;
}

}  // namespace

std::vector<Figure> figures(const std::vector<Outcome>& outcomes) {
  Count names, verdicts, far, colour, found, invented, two, three, outsiders, wrong, absent, missed, effects, numbers,
      after, corrected, worse;
  for (const Outcome& outcome : outcomes) {
    const bool explained = outcome.verdict == "explained";
    const std::string& category = outcome.category;
    wrong.add(outcome.explained_wrong);
    absent.add(explained && outcome.invented);
    missed.add(explained && category != "outsider" && outcome.clear_missed);
    if (category == "nothing" || category == "far") names.add(outcome.false_name);
    if (category == "nothing") verdicts.add(outcome.right_verdict);
    if (category == "far") far.add(outcome.right_verdict);
    if (category == "colour_unknown") colour.add(explained || !outcome.warned);
    if (category == "one" && outcome.visible) {
      found.add(outcome.found);
      invented.add(outcome.invented);
    }
    if (category == "two" && outcome.visible) two.add(outcome.found);
    if (category == "three" && outcome.visible) three.add(outcome.found);
    if (category == "outsider") outsiders.add(explained);
    if (explained && outcome.after_over_noise) after.add(keeps_error(outcome));
    if (category == "outsider" && outcome.state_dependent && outcome.excess_left)
      corrected.add(*outcome.excess_left <= 0.5);
    if (outcome.corrected_over_before) worse.add(*outcome.corrected_over_before > tolerated_correction);
    effects += outcome.effect_intervals;
    numbers += outcome.number_intervals;
  }
  return {
      {.text = "nothing hidden: a false name", .column = "false", .count = names, .share = 0.03, .at_most = true},
      {.text = "nothing hidden: the right verdict", .column = "verdict", .count = verdicts, .share = 0.9},
      {.text = "numbers far off: declared_numbers_off, or the number's name",
       .column = "far",
       .count = far,
       .share = 0.9},
      {.text = "colour that cannot be known: `explained`, or no word of it",
       .column = "colour",
       .count = colour,
       .share = 0.0,
       .at_most = true},
      {.text = "one clear effect: named, or in the set reported", .column = "one", .count = found, .share = 0.92},
      {.text = "  with a further effect that is invented",
       .column = "further",
       .count = invented,
       .share = 0.05,
       .at_most = true},
      {.text = "both of two clear effects", .column = "two", .count = two, .share = 0.75},
      {.text = "all of three clear effects", .column = "three", .count = three, .share = 0.5},
      {.text = "outsiders explained", .column = "outside", .count = outsiders, .share = 0.05, .at_most = true},
      {.text = "`explained` and wrong, of all sets", .column = "wrong", .count = wrong, .share = 0.02, .at_most = true},
      {.text = "  with an effect that is not there",
       .column = "absent",
       .count = absent,
       .share = 0.02,
       .at_most = true},
      {.text = "  without one that is clear", .column = "missed", .count = missed, .share = 0.02, .at_most = true},
      {.text = "true effect parameters inside the 95 % intervals",
       .column = "effect ci",
       .count = effects,
       .share = 0.9},
      {.text = "true stiffness, damping and declared numbers inside them",
       .column = "number ci",
       .count = numbers,
       .share = 0.9},
      {.text = "error after at most 1.1 of the noise, where explained",
       .column = "after",
       .count = after,
       .share = 0.97},
      {.text = "outsiders of the state: half of the excess corrected",
       .column = "corrected",
       .count = corrected,
       .share = 0.5},
      {.text = "corrections that make the held-out error 2 % worse",
       .column = "worse",
       .count = worse,
       .share = 0.02,
       .at_most = true},
  };
}

std::string fault_of(const Outcome& outcome) {
  const bool explained = outcome.verdict == "explained";
  if (outcome.false_name) return "false name";
  if (outcome.hidden.empty() && outcome.category != "colour_unknown" && !outcome.right_verdict) return "wrong verdict";
  if (outcome.category == "colour_unknown" && explained) return "explained a colour";
  if (outcome.category == "outsider" && explained) return "outsider explained";
  if (outcome.explained_wrong) return "explained and wrong";
  if (outcome.category != "outsider" && !outcome.hidden.empty() && outcome.visible && !outcome.found)
    return "not found";
  if (outcome.category == "one" && outcome.invented) return "further effect";
  if (explained && outcome.after_over_noise && !keeps_error(outcome)) return "error after";
  if (outcome.corrected_over_before && *outcome.corrected_over_before > tolerated_correction) return "correction worse";
  return "";
}

std::string set_line(const Outcome& outcome) {
  const std::string wrong = fault_of(outcome);
  return fmt::format("{:>4} {:<14} {:<34} {:<36}{} {:<20} {}{}{}{}", outcome.number, outcome.category,
                     outcome.conditions.size() >= 7 ? "all at once" : list(outcome.conditions), list(outcome.hidden),
                     outcome.visible ? " " : "?", outcome.verdict,
                     outcome.reported.empty() ? "" : list(outcome.reported),
                     outcome.ambiguous.empty() ? "" : fmt::format(" [{}]", sets_of(outcome.ambiguous)),
                     outcome.after_over_noise ? fmt::format(" {:.2f}", *outcome.after_over_noise) : "",
                     wrong.empty() ? "" : fmt::format(" <- {}", wrong));
}

std::string summary(const std::vector<Outcome>& outcomes) {
  std::string text = fmt::format("{} sets\n\n", outcomes.size());
  const auto out = std::back_inserter(text);
  const std::vector<Figure> all = figures(outcomes);
  for (const Figure& figure : all) text += line_of(figure);

  fmt::format_to(out, "\nby condition: hits of sets\n{:<28}{:>5}", "", "sets");
  for (const Figure& figure : all) fmt::format_to(out, "{:>11}", figure.column);
  text += '\n';
  for (const auto& [condition, sets] : by_condition(outcomes)) {
    fmt::format_to(out, "{:<28}{:>5}", condition, sets.size());
    for (const Figure& figure : figures(sets)) fmt::format_to(out, "{:>11}", fraction(figure.count));
    text += '\n';
  }

  text += reliability(outcomes);
  text += "\nwhere something went wrong (?: too weak to be asked for; last: error after over the noise)\n";
  for (const Outcome& outcome : outcomes)
    if (!fault_of(outcome).empty()) text += set_line(outcome) + "\n";
  return text;
}

std::string times(const std::vector<Outcome>& outcomes) {
  if (outcomes.empty()) return "";
  std::vector<Outcome> slowest = outcomes;
  std::sort(slowest.begin(), slowest.end(), [](const Outcome& a, const Outcome& b) { return a.seconds > b.seconds; });
  std::string text = fmt::format("time of a diagnosis: median {:.1f} s, longest {:.1f} s\n",
                                 slowest[slowest.size() / 2].seconds, slowest.front().seconds);
  for (std::size_t i = 0; i < std::min<std::size_t>(slowest.size(), 5); ++i)
    text += fmt::format("  {:>6.1f} s {}\n", slowest[i].seconds, set_line(slowest[i]));
  return text;
}

}  // namespace attribution::laboratory
