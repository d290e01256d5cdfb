#include "report/diagnosis/diagnosis_parts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "coilwright/measurement/identification/decision_thresholds.hpp"

namespace coilwright::report {
namespace {

using namespace measurement;

// The declared number that is meant; null for the shape of the torque, which is several.
const MovedNumber* declared_of(const Diagnosis& diagnosis, const identification::NumberOff& off) {
  const auto key = [](const MovedNumber& each) -> const std::string& { return each.estimate.key; };
  const auto number = std::ranges::find(diagnosis.nominal, off.name, key);
  return off.estimate && number != diagnosis.nominal.end() ? &*number : nullptr;
}

std::string free_value_text(const Diagnosis& diagnosis, const identification::NumberOff& off) {
  const MovedNumber* number = declared_of(diagnosis, off);
  if (number == nullptr) return "the torque has another shape over the angle than was declared";
  const std::vector<std::string> free = estimate_row(*off.estimate);
  return fmt::format("free, it is {}, {}; declared {}, {:.1f} tolerances away", free[1], free[2],
                     number_text(formats::in_unit(*number).declared),
                     std::abs(off.estimate->value - number->declared) / number->tolerance);
}

// Missing effects that would explain these data about as well as a number that is off.
std::vector<std::string> rivals_of_numbers(const Diagnosis& diagnosis) {
  constexpr double worth_naming = 0.05;
  std::vector<std::string> out;
  for (const identification::WeighedHypothesis& each : diagnosis.odds.hypotheses)
    if (!each.effects.empty() && each.probability >= worth_naming)
      if (std::string name = fmt::format("{}", fmt::join(formats::ids(each.effects), " + "));
          std::ranges::find(out, name) == out.end())
        out.push_back(std::move(name));
  constexpr std::size_t most = 3;
  if (out.size() > most) out.resize(most);
  return out;
}

}  // namespace

std::string numbers_off_sentence(const Diagnosis& diagnosis) {
  std::vector<std::string> names;
  for (const identification::NumberOff& each : diagnosis.numbers_off) names.push_back(each.name);
  const std::vector<std::string> rivals = rivals_of_numbers(diagnosis);
  std::string text = fmt::format(
      "A declared number is off: free from its tolerance, {} {}explains these data far better than within it",
      fmt::join(names, " or "), names.size() > 1 ? "(these data do not tell which) " : "");
  text += rivals.empty() ? ", and decisively better than any missing effect that was tried."
                         : fmt::format(". Or {} is missing, which explains them about as well: measure {} to know.",
                                       fmt::join(rivals, " or "), names.size() > 1 ? "these numbers" : "that number");
  if (diagnosis.probability_of_declared < identification::decision_thresholds.least_probability)
    text += " Others may be off, too.";
  return text;
}

std::string numbers_off_text(const Diagnosis& diagnosis) {
  std::string text;
  for (const identification::NumberOff& each : diagnosis.numbers_off)
    text += fmt::format("  {} {}: {};\n    the model gains {:.3g} by that\n", each.name,
                        diagnosis.numbers_off.size() > 1 ? "may be the one that is off" : "is off",
                        free_value_text(diagnosis, each), each.gain);
  if (text.empty()) return text;
  return text +
         "  A gain of 6 is odds of 20 to 1. The numbers that moved, above, are those of a fit that holds each by its "
         "tolerance: there the one that is off passes what it lacks to those beside it.\n";
}

std::vector<std::string> numbers_off_to_measure(const Diagnosis& diagnosis) {
  std::vector<std::string> out;
  for (const identification::NumberOff& each : diagnosis.numbers_off) {
    const MovedNumber* number = declared_of(diagnosis, each);
    out.push_back(number == nullptr ? shape_to_measure()
                                    : fmt::format("{} (declared {}, these data say {})", each.name,
                                                  number_text(formats::in_unit(*number).declared),
                                                  number_text(formats::in_unit(*each.estimate).value)));
  }
  return out;
}

std::string shape_to_measure() {
  return "the torque over the angle at one current (a static_torque bench), whose shape is off";
}

}  // namespace coilwright::report
