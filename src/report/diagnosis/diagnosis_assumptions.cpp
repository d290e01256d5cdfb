#include "report/diagnosis/diagnosis_parts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "coilwright/report/simulation/text_table.hpp"

namespace coilwright::report {
namespace {

using namespace measurement;
using enum TextTable::Align;

constexpr std::size_t most_numbers = 8;
constexpr std::size_t most_times = 5;

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
  line("Runs fitted:", runs_of(report.diagnosis, false));
  line("Runs kept from the fit, for the errors only:", runs_of(report.diagnosis, true));
  line("Chosen for that by the tool, because the set names none:", report.held_out);
  return text;
}

void add_calibration(Section& section, const Diagnosis& diagnosis) {
  if (diagnosis.calibration.empty()) return;
  TableBlock block{.caption = "Numbers fitted freely",
                   .table = {.header = {"number", "value", "95 % interval", "declared"}},
                   .align = {left, right, left, left},
                   .headed = false,
                   .further_in = 2};
  for (const identification::Estimate& each : diagnosis.calibration) {
    std::vector<std::string> row = estimate_row(each);
    const std::optional<double> declared = formats::in_unit(each).declared;
    row.push_back(declared ? fmt::format("declared {}", number_text(*declared)) : "");
    block.table.rows.push_back(std::move(row));
  }
  section.say("  Numbers fitted freely:\n");
  section.blocks.emplace_back(std::move(block));
  if (diagnosis.verdict == Verdict::partly_explained || diagnosis.verdict == Verdict::unexplained)
    section.say("    The intervals are right only if nothing is missing; here something is left over.\n");
  if (!diagnosis.indistinguishable.empty())
    section.say(
        "    Their intervals, and those of the declared numbers, contain what each of the effects that these data "
        "cannot "
        "tell apart makes of them; the values are those with the effects reported.\n");
}

// The declared numbers, those first that moved furthest.
void add_nominal(Section& section, const formats::DiagnosisReport& report) {
  const Diagnosis& diagnosis = report.diagnosis;
  if (diagnosis.nominal.empty()) return;
  std::vector<const MovedNumber*> ordered;
  for (const MovedNumber& each : diagnosis.nominal) ordered.push_back(&each);
  const auto distance = [](const MovedNumber* each) { return -std::abs(formats::tolerances_moved(*each)); };
  std::ranges::stable_sort(ordered, {}, distance);
  std::string text =
      fmt::format("  {} could move, each at the price of its tolerance (one standard deviation); in the fit {}:\n",
                  counted(ordered.size(), "declared number"),
                  diagnosis.effects.empty() ? "without an effect" : "with the effects found");
  if (diagnosis.model_error > 1.0)
    text += fmt::format(
        "    What is missing in the model is far larger than the noise: tolerances were weighed against it, as if the "
        "noise were {:.0f} times as large. Otherwise these numbers would take up what they can of it.\n",
        diagnosis.model_error);
  section.say(text);
  TableBlock block{.caption = "Declared numbers as the fit has them",
                   .table = {.header = {"", "declared", "tolerance", "moved to", "tolerances moved", "95 % interval"}},
                   .align = {left, right, left, right, right, left},
                   .further_in = 2};
  for (const MovedNumber* each : std::span(ordered).first(std::min(ordered.size(), most_numbers))) {
    const formats::MovedNumberInUnit shown = formats::in_unit(*each);
    block.table.rows.push_back({each->estimate.key, number_text(shown.declared),
                                fmt::format("{}{}", number_text(shown.tolerance), each->named ? "" : " (default)"),
                                moved_to_text(*each), fmt::format("{:+.1f}", formats::tolerances_moved(*each)),
                                each->idle_from ? "" : estimate_row(each->estimate).back()});
  }
  section.blocks.emplace_back(std::move(block));
  text.clear();
  if (ordered.size() > most_numbers)
    text += fmt::format("    and {} that moved less (nominal in diagnosis.json)\n", ordered.size() - most_numbers);
  const auto idle = std::ranges::find_if(ordered, [](const MovedNumber* each) { return each->idle_from.has_value(); });
  if (idle != ordered.end())
    text += fmt::format(
        "    below, above: there the number changes nothing in these records (faces that touch nowhere). It has moved "
        "that far at least; the records cannot say how much further. {} has it at {}, as if there were "
        "no faces.\n",
        report.updated_actuator, number_text(formats::in_unit((*idle)->estimate).value));
  const auto any_named = [&](std::string_view start) {
    return std::ranges::any_of(ordered, [&](const MovedNumber* each) { return each->estimate.key.starts_with(start); });
  };
  if (any_named("joint_stiffness_ratio") || any_named("joint_damping_ratio"))
    text += "    A ratio of the joints is how much more the second has than the first, over their mean.\n";
  if (any_named("force_curve"))
    text += "    The numbers of force_curve are a smooth error of the shape of the torque over the angle.\n";
  if (any_named("/"))
    text += "    A name with slashes is a place in the actuator file; its lists count from 0, links from the base.\n";
  section.say(text);
}

std::string exact_text(const Diagnosis& diagnosis) {
  if (diagnosis.held_exact.empty()) return {};
  std::string text = "  Taken as exact (if one of them is wrong, the numbers found have taken its error up):\n";
  for (const std::string& each : diagnosis.held_exact) text += fmt::format("    {}\n", each);
  return text;
}

// How noisy a channel is over its runs, and whether that was given or estimated.
struct Channel {
  double least = std::numeric_limits<double>::infinity();
  double most = 0.0;
  std::size_t given = 0;      // runs
  std::size_t from_run = 0;   // estimated from themselves
  std::size_t from_rest = 0;  // known from a record without motion
  std::set<std::string> colours{};

  void add(const signals::NoiseLevel& level) {
    least = std::min(least, level.sigma);
    most = std::max(most, level.sigma);
    if (level.given)
      ++given;
    else
      ++(level.from_the_run ? from_run : from_rest);
    if (!level.colour.empty()) colours.insert(level.colour);
  }

  [[nodiscard]] std::string source() const {
    std::vector<std::string> parts;
    if (given > 0) parts.push_back(fmt::format("given in {}", counted(given, "run")));
    if (from_rest > 0) parts.push_back(fmt::format("measured at rest for {}", counted(from_rest, "run")));
    if (from_run > 0) parts.push_back(fmt::format("estimated in {}", counted(from_run, "run")));
    return fmt::format("{}", fmt::join(parts, ", "));
  }
};

std::string noise_text(const Diagnosis& diagnosis) {
  std::map<std::string, Channel> channels;
  for (const signals::NoiseLevel& each : diagnosis.noise) channels[each.channel].add(each);
  std::string text;
  for (const auto& [name, channel] : channels) {
    const units::Unit unit = units::difference_unit(name);
    const std::string most = in_unit_text(channel.most, unit);
    const std::string range = channel.least == channel.most
                                  ? most
                                  : fmt::format("{} to {}", number_text(units::from_si(channel.least, unit)), most);
    text += fmt::format("    {}: {}, {}\n", name, range, channel.source());
    for (const std::string& colour : channel.colours) text += fmt::format("      {}\n", colour);
  }
  return text.empty() ? text : "  Noise, one standard deviation:\n" + text;
}

std::string outliers_text(const Diagnosis& diagnosis) {
  std::string text;
  for (const Outliers& each : diagnosis.outliers) {
    const std::size_t shown = std::min(each.times.size(), most_times);
    std::vector<std::string> times;
    for (const double time : std::span(each.times).first(shown)) times.push_back(number_text(time));
    text += fmt::format("    {}, {}: {} at {}{} s{}\n", each.run, each.channel, counted(each.times.size(), "sample"),
                        fmt::join(times, ", "), each.times.size() > shown ? ", ..." : "",
                        each.validate ? " (left out of the errors)" : "");
  }
  return text.empty() ? text
                      : "  Taken as outliers and left out, because they stand apart from their neighbours as no motion "
                        "does (all of them in diagnosis.json):\n" +
                            text;
}

}  // namespace

Section assumptions_section(const formats::DiagnosisReport& report) {
  Section section{.id = "assumptions", .title = "What was assumed"};
  section.say(runs_text(report));
  add_calibration(section, report.diagnosis);
  add_nominal(section, report);
  section.say(exact_text(report.diagnosis) + noise_text(report.diagnosis) + outliers_text(report.diagnosis));
  return section;
}

}  // namespace coilwright::report
