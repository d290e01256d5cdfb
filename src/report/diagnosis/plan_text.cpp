#include "coilwright/report/diagnosis/plan_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "coilwright/report/simulation/text_table.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::report {
namespace {

using namespace measurement::planning;
using enum TextTable::Align;

constexpr std::size_t most_pairs = 20;

// "0.21 Nmm" of torque_Nmm.
std::string parameter_text(const actuator::Effect& effect, std::size_t number) {
  const std::string_view key = effect.kind->parameters()[number].key;
  const std::string value = fmt::format("{:.3g}", units::from_memory(effect.values[number], key));
  const auto parts = units::split_unit(key);
  return parts ? value + " " + readable_unit(parts->unit.suffix) : value;
}

std::string name_text(const actuator::Effect& effect, std::size_t number) {
  const std::string_view key = effect.kind->parameters()[number].key;
  const auto parts = units::split_unit(key);
  std::string out(parts ? parts->quantity : key);
  std::ranges::replace(out, '_', ' ');
  return out;
}

// "gain 0.854 (1 without it)", "current 1.35 A or less" of a limit: of most effects the strength is 0 where they are
// not there, which goes without saying.
std::string strength_text(const VisibleEffect& effect) {
  if (!effect.main) return effect.visible ? "shows as it is" : "";
  const std::size_t main = *effect.main;
  std::string out = name_text(effect.effect, main) + " " + parameter_text(effect.effect, main);
  const actuator::EffectParameter& number = effect.effect.kind->parameters()[main];
  if (!number.absent || *number.absent == 0.0) return out;
  if (std::isinf(*number.absent)) return out + " or less";
  return out + fmt::format(" ({:.3g} without it)", units::from_memory(*number.absent, number.key));
}

// The other numbers, at which that strength holds.
std::string shape_text(const VisibleEffect& effect) {
  std::string out;
  for (std::size_t i = 0; i < effect.effect.values.size(); ++i) {
    if (i == effect.main) continue;
    out += (out.empty() ? "at " : ", ") + name_text(effect.effect, i) + " " + parameter_text(effect.effect, i);
  }
  return out;
}

std::string strengths_text(const ExperimentPlan& plan) {
  TextTable table;
  for (const VisibleEffect& each : plan.effects) {
    const std::string strength = strength_text(each);
    const std::string shape = shape_text(each);
    if (each.visible) {
      table.row({std::string(each.effect.kind->id()), strength, shape});
      continue;
    }
    std::string tried = strength;
    if (!strength.empty() && !shape.empty()) tried += ' ';
    tried += shape;
    table.row({std::string(each.effect.kind->id()), "never", each.remark + (tried.empty() ? "" : ": " + tried)});
  }
  return table.text(2, {left, left, left});
}

std::string pairs_text(const ExperimentPlan& plan) {
  if (std::ranges::none_of(plan.effects, &VisibleEffect::visible))
    return "No effect shows in this experiment, so that none can be told from another.\n";
  if (plan.pairs.empty()) return "Five times as strong, every effect that shows could be told from every other one.\n";
  std::string out =
      "These pairs it cannot tell apart even five times as strong. The number is how much they differ, over what\n"
      "telling them apart takes; 1 would be enough:\n";
  TextTable table;
  for (const InseparablePair& pair : plan.pairs) {
    if (table.rows() == most_pairs) break;
    table.row({std::string(plan.effects[pair.first].effect.kind->id()),
               std::string(plan.effects[pair.second].effect.kind->id()), fmt::format("{:.2f}", pair.over_limit)});
  }
  out += table.text(2, {left, left, right});
  if (plan.pairs.size() > most_pairs)
    out += fmt::format("  and {} more, which --json lists\n", plan.pairs.size() - most_pairs);
  return out;
}

std::string plural(std::size_t count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string gains_text(const AddedRun& run) {
  std::vector<std::string> gains;
  if (run.separated_pairs > 0)
    gains.push_back(plural(run.separated_pairs, "of these pairs comes apart", "of these pairs come apart"));
  if (run.newly_visible > 0)
    gains.push_back(plural(run.newly_visible, "more effect can be found", "more effects can be found"));
  if (run.lowering < 0.995)
    gains.push_back(fmt::format("the smallest strengths fall by {:.0f} % on average", 100.0 * (1.0 - run.lowering)));
  std::string out;
  for (const std::string& gain : gains) out += (out.empty() ? "" : "; ") + gain;
  return out.empty() ? "nothing gets better" : out;
}

std::string added_text(const ExperimentPlan& plan) {
  if (plan.added_runs.empty()) return "No run could be proposed: none of the fit runs commands a motion.\n";
  const AddedRun& best = plan.added_runs.front();
  if (gains_text(best) == "nothing gets better") return "None of the runs that were tried would show more.\n";
  std::string out = fmt::format("Add this run: {}, {}.\n  Why: {}.\n  With it: {}.\n", best.kind, best.input, best.why,
                                gains_text(best));
  return out + "  Its entry for \"runs\", and the other runs that were tried, are in the output of --json.\n";
}

}  // namespace

std::string to_text(const formats::PlanReport& report) {
  const ExperimentPlan& plan = report.plan;
  std::string out = fmt::format(
      "What {} could show on {}: {} samples of its fit runs.\n\n"
      "The smallest strength of each effect, alone, that stands out of the noise in four of five records (an estimate\n"
      "by small changes about the declared model):\n",
      report.experiment, report.actuator, plan.samples);
  out += strengths_text(plan);
  out +=
      "Count on twice these strengths: where it was tried, at 60 frames a second, a diagnosis found 2 of 9 effects at "
      "these\nstrengths and 9 of 12 at twice (with older estimates, which were lower).\n";
  if (const double stronger = std::sqrt(plan.overdispersion); stronger > 1.05)
    out += fmt::format(
        "The noise is not white, or its level not known: effects must be {:.2g} times as strong as in white noise of\n"
        "that level, and the strengths above are. A still run would tell a diagnosis its colour.\n",
        stronger);
  out += '\n' + pairs_text(plan) + '\n' + added_text(plan);
  if (!plan.left_out.empty()) {
    out += "\nLeft out:\n";
    for (const LeftOutEffect& each : plan.left_out) out += fmt::format("  {}: {}\n", each.kind->id(), each.reason);
  }
  return out;
}

}  // namespace coilwright::report
