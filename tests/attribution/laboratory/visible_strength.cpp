#include "attribution/laboratory/visible_strength.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "attribution/laboratory/program_run.hpp"
#include "attribution/temporary_set_folder.hpp"
#include "truth/hidden_effects.hpp"
#include "truth/laboratory/laboratory_set.hpp"

namespace attribution::laboratory {
namespace {

// The first number of a kind in the unit of its key, absent and at a bound of the drawn sign.
struct Range {
  double absent;
  double bound;
};
Range range_of(const truth::HiddenKind& kind) {
  truth::Random random(1);
  truth::UnmodelledEffects effects;
  const auto set_strength = kind.draw(random, {.lowest = -0.1, .highest = 0.9}, effects);
  const auto at = [&](double share) {
    set_strength(effects, share);
    return effects.*kind.numbers.front().member * kind.numbers.front().denominator;
  };
  return {.absent = at(0.0), .bound = at(1.0)};
}

}  // namespace

std::optional<double> five_times_visible(const std::string& plan_json, const std::string& name) {
  const truth::HiddenKind& kind = truth::hidden_kind(name);
  if (kind.numbers.empty() || kind.id == "end_stop") return std::nullopt;
  const std::string& key = kind.numbers.front().key;
  const nlohmann::json planned = nlohmann::json::parse(plan_json);
  for (const nlohmann::json& effect : planned.at("effects")) {
    if (effect.at("id") != kind.id || !effect.at("visible").get<bool>() || effect.at("strength") != key) continue;
    const Range range = range_of(kind);
    const double wanted = 5.0 * (effect.at("smallest").at(key).get<double>() - range.absent);
    const double most = std::abs(range.bound - range.absent);
    return range.absent + std::clamp(wanted, -most, most);
  }
  return std::nullopt;
}

std::optional<double> five_times_visible(const Case& asked, const std::filesystem::path& program, int threads) {
  const TemporarySetFolder folder("plan", asked.number);
  const auto set = truth::laboratory::make_laboratory_set(asked.request);
  truth::laboratory::write_experiment(set, folder.path());
  const bool exact = asked.request.tolerances == truth::laboratory::Tolerances::exact;
  const std::string text =
      words_of(fmt::format("'{}' plan '{}' --actuator '{}' --json --threads {}{}", program.string(),
                           (folder.path() / "experiment.json").string(), (folder.path() / "finger.json").string(),
                           threads, exact ? " --exact" : ""),
               folder.path() / "words.txt");
  return five_times_visible(text, asked.request.hidden.front());
}

}  // namespace attribution::laboratory
