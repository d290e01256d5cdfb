#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "coilwright/formats/data/diagnosis_formatting.hpp"
#include "coilwright/formats/data/measured_unit.hpp"
#include "coilwright/report/diagnosis_text.hpp"
#include "report/text_table.hpp"

namespace coilwright::report {
namespace {

using formats::error_unit;
using formats::EstimateInUnit;
using formats::ids;
using formats::in_unit;
using formats::main_first;
using namespace measurement;
using enum TextTable::Align;

constexpr std::size_t most_candidates = 5;
constexpr std::size_t most_dependences = 4;

// Four digits: what the intervals of a fit bear, and a line holds.
std::string number(double value) {
  return std::isfinite(value) ? fmt::format("{:.4g}", value) : "none";
}

std::string in_unit_text(double value, const units::Unit& unit) {
  const std::string readable = readable_unit(unit.suffix);
  return number(units::from_si(value, unit)) + (readable.empty() ? "" : " " + readable);
}

std::string verdict_sentence(const Diagnosis& diagnosis) {
  std::vector<std::string> names;
  for (const AddedEffect& each : diagnosis.effects) names.emplace_back(each.kind->id());
  const std::string effects = fmt::format("{}", fmt::join(names, " and "));
  switch (diagnosis.verdict) {
    case Verdict::no_missing_effect:
      return "The declared model lacks nothing that these data show: fitted anew, it reaches the noise.";
    case Verdict::declared_numbers_off:
      return "The declared numbers are off: moved further than their tolerances allow, they explain these data, and no "
             "missing effect does so decisively better.";
    case Verdict::explained:
      return fmt::format("The declared model lacks {}; with it, what is left over is noise.", effects);
    case Verdict::partly_explained:
      return fmt::format("The declared model lacks {}, and something else: structure remains that no effect explains.",
                         effects);
    case Verdict::unexplained:
      return "The declared model lacks something, and none of the known effects explains it.";
  }
  return "";
}

// Digits that a number bears whose interval is this wide: two of the half width's.
int digits_of(const EstimateInUnit& shown) {
  const double half_width = 0.5 * (shown.upper - shown.lower);
  if (!std::isfinite(half_width) || half_width <= 0.0 || std::abs(shown.value) <= half_width) return 3;
  const double places = std::floor(std::log10(std::abs(shown.value))) - std::floor(std::log10(half_width));
  return std::clamp(static_cast<int>(places) + 2, 3, 12);
}

std::string interval_text(const compare::Estimate& estimate, const EstimateInUnit& shown, int digits) {
  if (!estimate.determined) return "not determined by these data";
  const bool lower = std::isfinite(shown.lower);
  const bool upper = std::isfinite(shown.upper);
  if (lower && upper) return fmt::format("{:.{}g} to {:.{}g} (95 %)", shown.lower, digits, shown.upper, digits);
  if (lower) return fmt::format("at least {} (95 %)", number(shown.lower));
  if (upper) return fmt::format("at most {} (95 %)", number(shown.upper));
  return "no bound on either side (95 %)";
}

std::vector<std::string> estimate_row(const compare::Estimate& estimate) {
  const EstimateInUnit shown = in_unit(estimate);
  const int digits = digits_of(shown);
  return {estimate.key, fmt::format("{:.{}g}", shown.value, digits), interval_text(estimate, shown, digits)};
}

std::string parameters_text(const AddedEffect& effect) {
  if (effect.parameters.empty()) return "    (no number of its own)\n";
  TextTable table;
  for (const compare::Estimate& each : effect.parameters) {
    if (each.chosen)
      table.row({each.key, number(in_unit(each).value), "(chosen)"});
    else
      table.row(estimate_row(each));
  }
  return table.text(4, {left, right, left});
}

std::string effects_text(const Diagnosis& diagnosis) {
  if (diagnosis.effects.empty()) return {};
  std::string text = "\nWhat it lacks\n";
  for (const AddedEffect& each : diagnosis.effects) {
    text += fmt::format("  {}: {}\n", each.kind->id(), each.kind->description());
    text += parameters_text(each);
    const compare::Evidence& evidence = each.evidence;
    text += fmt::format("    chi^2 on the fit runs {} -> {}", number(evidence.chi_square_before),
                        number(evidence.chi_square_after));
    if (std::isfinite(evidence.cross_validated_gain))
      // More than all of it is what noise makes of it.
      text += fmt::format("; takes away {} % of the error above the noise on runs left out in turn",
                          number(100.0 * std::min(1.0, evidence.cross_validated_gain)));
    text += '\n';
  }
  return text;
}

std::string calibration_text(const Diagnosis& diagnosis) {
  if (diagnosis.calibration.empty()) return {};
  TextTable table;
  for (const compare::Estimate& each : diagnosis.calibration) table.row(estimate_row(each));
  return "\nDeclared numbers, fitted anew\n" + table.text(2, {left, right, left});
}

std::string comparison_text(const ErrorComparison& comparison) {
  const units::Unit unit = error_unit(comparison.kind);
  const auto shown = [&](double value) { return number(units::from_si(value, unit)); };
  const auto line = [&](const char* name, double Errors::*member) -> std::vector<std::string> {
    return {name, shown(comparison.declared.*member), shown(comparison.before.*member),
            shown(comparison.after.*member)};
  };
  std::vector<std::string> rmse = line("  rmse", &Errors::rmse);
  rmse.push_back(fmt::format("noise alone: {}", shown(comparison.noise_floor_rmse)));
  TextTable rows;
  rows.row({fmt::format("{}, {}", formats::name_of(comparison.kind), readable_unit(unit.suffix)), "as declared",
            "fitted anew", "with effects"});
  rows.row(line("  mean", &Errors::mae));
  rows.row(std::move(rmse));
  rows.row(line("  largest", &Errors::max));
  return rows.text(2, {left, right, right, right, left});
}

std::string errors_text(const Diagnosis& diagnosis) {
  const bool validated = !diagnosis.validate_errors.empty();
  const auto& comparisons = validated ? diagnosis.validate_errors : diagnosis.fit_errors;
  if (comparisons.empty()) return {};
  std::string text = validated ? "\nErrors on the runs that no fit has seen\n"
                               : "\nErrors on the fit runs (no run could be kept from the fit)\n";
  for (const ErrorComparison* each : main_first(comparisons)) text += comparison_text(*each);
  return text;
}

// What an effect's rivals are called in a sentence: "a + b".
std::string hypothesis(const compare::ComparedHypothesis& candidate) {
  return candidate.effects.empty() ? "no effect" : fmt::format("{}", fmt::join(ids(candidate.effects), " + "));
}

std::string compared_text(const Diagnosis& diagnosis) {
  if (diagnosis.compared_hypotheses.empty()) return {};
  TextTable table;
  table.row({"", "chi^2"});
  for (const compare::ComparedHypothesis& each :
       std::span(diagnosis.compared_hypotheses).first(std::min(diagnosis.compared_hypotheses.size(), most_candidates)))
    table.row({hypothesis(each), each.evidence ? number(each.evidence->chi_square_after) : "none", each.remark});
  return "\nCompared, best first\n" + table.text(2, {left, right, left});
}

std::string rivals_text(const Diagnosis& diagnosis) {
  std::string text;
  for (const auto& set : diagnosis.indistinguishable)
    text += fmt::format("  these data cannot tell apart: {}\n", fmt::join(ids(set), ", "));
  if (!text.empty()) text = "\nWhat else it could be\n" + text;
  return text + compared_text(diagnosis);
}

std::string experiment_text(const Diagnosis& diagnosis) {
  if (!diagnosis.next_experiment) return {};
  const experiment::NextExperiment& next = *diagnosis.next_experiment;
  std::string text = fmt::format("\nThe experiment that would tell\n  {}: {}\n  {}", next.kind, next.input, next.why);
  if (std::isfinite(next.separation))
    text += fmt::format(" (predictions differ by {} times the noise)", number(next.separation));
  return text + '\n';
}

// Only where something is left over: on a residual that is noise there is nothing to name.
std::string residual_text(const Diagnosis& diagnosis) {
  const bool structure = diagnosis.verdict == Verdict::partly_explained || diagnosis.verdict == Verdict::unexplained;
  if (!structure || !diagnosis.residual) return {};
  const localise::ResidualTorque& residual = *diagnosis.residual;
  const units::Unit torque = error_unit(data::ChannelKind::torque);
  std::string text = fmt::format("\nWhat is left over, as a joint torque\n  rms {}, where noise alone gives {}\n",
                                 in_unit_text(residual.rms, torque), in_unit_text(residual.noise_floor, torque));
  TextTable table;
  for (const localise::Dependence& each : residual.dependences) {
    if (table.rows() == most_dependences) break;
    table.row({fmt::format("on {}", each.variable), fmt::format("{:.0f} %", 100.0 * each.explained)});
  }
  if (table.rows() > 0) text += "  depends\n" + table.text(4, {left, right});
  if (residual.frequency) text += fmt::format("  strongest line at {} Hz\n", number(*residual.frequency));
  if (!diagnosis.after.where.empty())
    text += fmt::format("  worst in {} ({} times what noise may show)\n", diagnosis.after.where,
                        number(diagnosis.after.whiteness_ratio));
  return text;
}

// Before all else that follows from the data.
std::string warnings_text(const Diagnosis& diagnosis) {
  if (diagnosis.warnings.empty()) return {};
  std::string text = "\nWarnings\n";
  for (const data::Warning& each : diagnosis.warnings)
    text += fmt::format("  {}{}\n", each.run.empty() ? "" : each.run + ": ", each.text);
  return text;
}

// A line a channel: how noisy it is over its runs, and whether that was given or estimated.
std::string noise_text(const Diagnosis& diagnosis) {
  struct Channel {
    double least = std::numeric_limits<double>::infinity();
    double most = 0.0;
    int given = 0;  // runs
    int estimated = 0;

    [[nodiscard]] std::string source() const {
      const auto runs = [](int count) { return fmt::format("{} {}", count, count == 1 ? "run" : "runs"); };
      constexpr const char* how = "estimated (diagnosis.json says how)";
      if (estimated == 0) return fmt::format("in {}, given", runs(given));
      if (given == 0) return fmt::format("in {}, {}", runs(estimated), how);
      return fmt::format("given in {}, in {} {}", runs(given), runs(estimated), how);
    }
  };
  std::map<std::string, Channel> channels;
  for (const noise::NoiseLevel& each : diagnosis.noise) {
    Channel& channel = channels[each.channel];
    channel.least = std::min(channel.least, each.sigma);
    channel.most = std::max(channel.most, each.sigma);
    ++(each.given ? channel.given : channel.estimated);
  }
  TextTable table;
  for (const auto& [name, channel] : channels) {
    const units::Unit unit = units::difference_unit(name);
    const std::string most = in_unit_text(channel.most, unit);
    const std::string range = channel.least == channel.most
                                  ? most
                                  : fmt::format("{} to {}", number(units::from_si(channel.least, unit)), most);
    table.row({name, fmt::format("{} {}", range, channel.source())});
  }
  return table.rows() == 0 ? std::string() : "\nNoise\n" + table.text(2, {left, left});
}

// Files of the runs with that role, each once, in their order.
std::vector<std::string> runs_of(const Diagnosis& diagnosis, bool validate) {
  std::vector<std::string> out;
  std::set<std::string> seen;
  for (const Replay& each : diagnosis.replays)
    if (each.validate == validate && seen.insert(each.run).second) out.push_back(each.run);
  return out;
}

std::string runs_text(const formats::DiagnosisReport& report) {
  std::string text;
  const auto line = [&text](const char* name, const std::vector<std::string>& runs) {
    if (!runs.empty()) text += fmt::format("  {} {}\n", name, fmt::join(runs, ", "));
  };
  line("fitted:", runs_of(report.diagnosis, false));
  line("kept from the fit:", runs_of(report.diagnosis, true));
  line("chosen for that by the tool (the set names none):", report.held_out);
  return text.empty() ? text : "\nRuns\n" + text;
}

}  // namespace

std::string to_text(const formats::DiagnosisReport& report) {
  const Diagnosis& diagnosis = report.diagnosis;
  return fmt::format("{}: {}\n\n{}\n", report.dataset, name_of(diagnosis.verdict), verdict_sentence(diagnosis)) +
         warnings_text(diagnosis) + effects_text(diagnosis) + errors_text(diagnosis) + rivals_text(diagnosis) +
         experiment_text(diagnosis) + residual_text(diagnosis) + calibration_text(diagnosis) + noise_text(diagnosis) +
         runs_text(report);
}

}  // namespace coilwright::report
