#include "attribution/laboratory/outcome_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace attribution::laboratory {
namespace {

using Json = nlohmann::ordered_json;

Json optional_json(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

std::optional<double> optional_from(const Json& value) {
  return value.is_null() ? std::nullopt : std::optional<double>(value.get<double>());
}

Json count_json(const Count& count) {
  return {count.hits, count.of};
}

Count count_from(const Json& value) {
  return {.hits = value.at(0), .of = value.at(1)};
}

Json odds_json(const std::vector<StatedOdds>& odds) {
  Json out = Json::array();
  for (const StatedOdds& each : odds) out.push_back({each.probability, each.is_there});
  return out;
}

std::vector<StatedOdds> odds_from(const Json& value) {
  std::vector<StatedOdds> out;
  for (const Json& each : value) out.push_back({.probability = each.at(0), .is_there = each.at(1)});
  return out;
}

}  // namespace

void write_outcome(const Outcome& outcome, const std::filesystem::path& file) {
  const Json all = {{"number", outcome.number},
                    {"category", outcome.category},
                    {"conditions", outcome.conditions},
                    {"hidden", outcome.hidden},
                    {"visible", outcome.visible},
                    {"evidence", outcome.evidence},
                    {"at_bound", outcome.at_bound},
                    {"state_dependent", outcome.state_dependent},
                    {"verdict", outcome.verdict},
                    {"reported", outcome.reported},
                    {"ambiguous", outcome.ambiguous},
                    {"false_name", outcome.false_name},
                    {"right_verdict", outcome.right_verdict},
                    {"found", outcome.found},
                    {"invented", outcome.invented},
                    {"explained_wrong", outcome.explained_wrong},
                    {"clear_missed", outcome.clear_missed},
                    {"odds", odds_json(outcome.odds)},
                    {"effect_intervals", count_json(outcome.effect_intervals)},
                    {"number_intervals", count_json(outcome.number_intervals)},
                    {"after_over_noise", optional_json(outcome.after_over_noise)},
                    {"excess_left", optional_json(outcome.excess_left)},
                    {"corrected_over_before", optional_json(outcome.corrected_over_before)},
                    {"warned", outcome.warned},
                    {"seconds", outcome.seconds}};
  std::filesystem::path unfinished = file;
  unfinished += ".unfinished";
  std::ofstream out(unfinished, std::ios::binary);
  out << all.dump(1) << "\n";
  out.close();
  if (!out) throw std::runtime_error(fmt::format("{}: cannot be written", unfinished.string()));
  std::filesystem::rename(unfinished, file);
}

Outcome read_outcome(const std::filesystem::path& file) {
  try {
    std::ifstream in(file);
    const Json all = Json::parse(in);
    return {.number = all.at("number"),
            .category = all.at("category"),
            .conditions = all.at("conditions"),
            .hidden = all.at("hidden"),
            .visible = all.at("visible"),
            .evidence = all.at("evidence"),
            .at_bound = all.at("at_bound"),
            .state_dependent = all.at("state_dependent"),
            .verdict = all.at("verdict"),
            .reported = all.at("reported"),
            .ambiguous = all.at("ambiguous"),
            .false_name = all.at("false_name"),
            .right_verdict = all.at("right_verdict"),
            .found = all.at("found"),
            .invented = all.at("invented"),
            .explained_wrong = all.at("explained_wrong"),
            .clear_missed = all.at("clear_missed"),
            .odds = odds_from(all.at("odds")),
            .effect_intervals = count_from(all.at("effect_intervals")),
            .number_intervals = count_from(all.at("number_intervals")),
            .after_over_noise = optional_from(all.at("after_over_noise")),
            .excess_left = optional_from(all.at("excess_left")),
            .corrected_over_before = optional_from(all.at("corrected_over_before")),
            .warned = all.at("warned"),
            .seconds = all.at("seconds")};
  } catch (const Json::exception& error) {
    throw std::runtime_error(fmt::format("{}: must be an outcome of the benchmark; {}", file.string(), error.what()));
  }
}

std::vector<Outcome> read_outcomes(const std::filesystem::path& folder) {
  std::vector<Outcome> out;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".json") out.push_back(read_outcome(entry.path()));
  std::sort(out.begin(), out.end(), [](const Outcome& a, const Outcome& b) { return a.number < b.number; });
  return out;
}

}  // namespace attribution::laboratory
