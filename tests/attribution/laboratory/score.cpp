#include "attribution/laboratory/score.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <string_view>

#include "degree.hpp"

namespace attribution::laboratory {
namespace {

using nlohmann::json;
using truth::laboratory::Deviation;
using truth::laboratory::LaboratorySet;
using truth::laboratory::Number;
using truth::laboratory::Tolerances;

// Standard deviations over all samples that must be left of an effect when tolerances and clocks have taken theirs:
// five times six, with which an effect can be told from noise at all; of one at its physical bound, or at five times
// what a plan says, twice that.
constexpr double clear = 30.0;
constexpr double clear_at_bound = 12.0;
constexpr double least_stated = 0.01;  // a probability below counts as none

bool contains(const std::vector<std::string>& ids, const std::string& id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

// Whether a reported effect stands for a hidden one.
bool stands_for(const Outcome& outcome, const std::string& reported, const std::string& hidden) {
  return reported == hidden || std::any_of(outcome.ambiguous.begin(), outcome.ambiguous.end(), [&](const auto& set) {
           return contains(set, reported) && contains(set, hidden);
         });
}

// The effect that a declared number is called where it alone has moved.
std::string effect_of(const std::string& number) {
  if (number.find("remanence_T") != std::string::npos) return "force_gain";
  if (number == "/links/1/mass_kg") return "added_mass";
  if (number == "joint_stiffness_ratio") return "joint_asymmetry";
  return "";
}

// Names that are true although nothing is hidden: of one number that is far off, and of a camera whose scale is off.
std::vector<std::string> true_names(const LaboratorySet& set) {
  std::vector<std::string> ids;
  std::size_t moved = 0;
  for (const Number& number : set.answer.built.numbers) {
    if (!number.far) continue;
    const std::string id = effect_of(number.name);
    if (contains(ids, id)) continue;  // both magnets
    ids.push_back(id);
    ++moved;
  }
  if (moved > 1) ids.clear();
  std::erase(ids, "");
  if (set.answer.built.angle_scale != 1.0) ids.emplace_back("angle_scale");
  return ids;
}

bool is_right_verdict(const Outcome& outcome, const Case& asked, const LaboratorySet& set) {
  const auto& request = set.request;
  if (asked.category == Category::colour_unknown) return outcome.verdict != "explained";
  if (asked.category == Category::far)
    return outcome.verdict == "declared_numbers_off" ||
           (outcome.verdict == "explained" && !outcome.false_name && !outcome.reported.empty());
  if (outcome.verdict == "no_missing_effect") return true;
  // Nobody said how exact the numbers are, or faces are declared that the finger does not have there.
  const bool may_be_off = (request.deviation == Deviation::within && request.tolerances == Tolerances::absent) ||
                          request.faces != truth::laboratory::DeclaredFaces::none;
  return may_be_off && outcome.verdict == "declared_numbers_off";
}

// An interval whose ends are numbers; one that is open contains everything and is not counted.
void count_interval(const json& estimate, double value, Count& count) {
  if (!estimate.is_object() || !estimate.contains("ci95") || !estimate.value("determined", true)) return;
  const json& ends = estimate.at("ci95");
  if (ends.size() != 2 || !ends[0].is_number() || !ends[1].is_number()) return;
  const double slack = 1e-9 * std::abs(value);  // of the unit's conversion
  count.add(ends[0].get<double>() - slack <= value && value <= ends[1].get<double>() + slack);
}

void count_effect_intervals(const json& diagnosis, const LaboratorySet& set, Outcome& outcome) {
  for (const json& effect : diagnosis.at("effects"))
    for (const truth::HiddenEffect& hidden : set.answer.common.hidden) {
      if (hidden.id != effect.at("id")) continue;
      for (const auto& number : hidden.numbers)
        if (number.key != "side" && number.key != "warm_start" && effect.at("parameters").contains(number.key))
          count_interval(effect.at("parameters").at(number.key), number.value, outcome.effect_intervals);
    }
}

void count_number_intervals(const json& diagnosis, const LaboratorySet& set, Outcome& outcome) {
  std::map<std::string, double> is{{"joint_stiffness_Nmm_rad", set.answer.common.joint_stiffness * 1e3},
                                   {"joint_damping_Nmms_rad", set.answer.common.joint_damping * 1e3}};
  for (const Number& number : set.answer.built.numbers) {
    if (number.declared == 0.0) continue;  // a curve has no one number
    if (number.name != "joint_stiffness_ratio" && number.name != "joint_damping_ratio") {
      is[number.name] = number.is;
      continue;
    }
    // The simulation has the second joint over the first; the format the difference over the mean, and one value for
    // all joints is that mean.
    is[number.name] = 2.0 * (number.is - 1.0) / (number.is + 1.0);
    is[number.name == "joint_stiffness_ratio" ? "joint_stiffness_Nmm_rad" : "joint_damping_Nmms_rad"] *=
        0.5 * (1.0 + number.is);
  }
  // Two stiffnesses are three numbers of such a model: no interval is that of the truth.
  if (contains(outcome.hidden, "joint_asymmetry") && set.request.tolerances != Tolerances::exact)
    for (const char* name : {"joint_stiffness_Nmm_rad", "joint_stiffness_ratio"}) is.erase(name);
  for (const char* list : {"calibration", "nominal"}) {
    if (!diagnosis.contains(list)) continue;
    for (const auto& [name, value] : is)
      if (diagnosis.at(list).contains(name))
        count_interval(diagnosis.at(list).at(name), value, outcome.number_intervals);
  }
}

// Of the validate runs. Pictures that are wrong count as noise unless the diagnosis says that it sets some aside: then
// its errors are without them.
double true_noise_deg(const json& diagnosis, const LaboratorySet& set) {
  const double plain = std::hypot(set.answer.common.noise, set.answer.common.resolution / std::sqrt(12.0)) / degree;
  if (diagnosis.contains("outliers") && !diagnosis.at("outliers").empty()) return plain;
  double squares = 0.0;
  double pictures = 0.0;
  for (const auto& run : set.runs) {
    if (!run.planned.validate) continue;
    pictures += static_cast<double>(run.stamps.size());
    for (const auto& outlier : run.outliers) squares += std::pow(outlier.by / degree, 2);
  }
  return std::sqrt(plain * plain + (pictures > 0.0 ? squares / pictures : 0.0));
}

std::optional<double> rmse(const json& diagnosis, const char* model) {
  const json& validate = diagnosis.at("error").at("validate");
  if (!validate.contains(model) || !validate.at(model).is_object()) return std::nullopt;
  const json value = validate.at(model).value("rmse_deg", json());
  return value.is_number() ? std::optional<double>(value.get<double>()) : std::nullopt;
}

bool has_validate_runs(const LaboratorySet& set) {
  return std::any_of(set.runs.begin(), set.runs.end(), [](const auto& run) { return run.planned.validate; });
}

void take_errors(const json& diagnosis, const LaboratorySet& set, Outcome& outcome) {
  if (!has_validate_runs(set)) return;
  const double noise = true_noise_deg(diagnosis, set);
  if (const auto after = rmse(diagnosis, "after")) outcome.after_over_noise = *after / noise;
  const auto before = rmse(diagnosis, "before");
  const auto corrected = rmse(diagnosis, "corrected");
  if (!before || !corrected) return;
  outcome.corrected_over_before = *corrected / *before;
  if (*before > 1.1 * noise) outcome.excess_left = (*corrected - noise) / (*before - noise);
}

// Outsiders that act on angle, rate or current of the moment.
bool depends_on_state(const std::string& id) {
  static constexpr std::array<std::string_view, 6> ids{"friction_of_bent_hinge", "contact_between_coils",
                                                       "saturating_iron",        "torque_ripple",
                                                       "coupled_joints",         "camera_parallax"};
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

}  // namespace

Outcome score(const Case& asked, const LaboratorySet& set, const std::string& diagnosis_json) {
  const json diagnosis = json::parse(diagnosis_json);
  Outcome outcome;
  outcome.number = asked.number;
  outcome.category = name_of(asked.category);
  outcome.conditions = asked.conditions;
  outcome.at_bound = asked.request.at_bound;
  outcome.verdict = diagnosis.at("verdict");
  for (const json& effect : diagnosis.at("effects")) outcome.reported.push_back(effect.at("id"));
  outcome.ambiguous = diagnosis.at("indistinguishable").get<std::vector<std::vector<std::string>>>();
  for (const truth::HiddenEffect& hidden : set.answer.common.hidden) {
    outcome.hidden.push_back(hidden.id);
    outcome.evidence = outcome.hidden.size() == 1 ? hidden.evidence : std::min(outcome.evidence, hidden.evidence);
    outcome.state_dependent = outcome.state_dependent || depends_on_state(hidden.id);
  }

  const bool eased = asked.request.at_bound || !asked.request.values.empty();
  const double enough = eased ? clear_at_bound : clear;
  outcome.visible = outcome.hidden.empty() || outcome.evidence >= enough;

  const std::vector<std::string> allowed = true_names(set);
  const auto is_true = [&](const std::string& reported) {
    return contains(allowed, reported) ||
           std::any_of(outcome.hidden.begin(), outcome.hidden.end(),
                       [&](const auto& id) { return stands_for(outcome, reported, id); });
  };
  outcome.invented = !std::all_of(outcome.reported.begin(), outcome.reported.end(), is_true);
  outcome.false_name = outcome.hidden.empty() && outcome.invented;
  outcome.found = !outcome.hidden.empty();
  for (const truth::HiddenEffect& hidden : set.answer.common.hidden) {
    const bool is_found =
        std::any_of(outcome.reported.begin(), outcome.reported.end(),
                    [&](const std::string& reported) { return stands_for(outcome, reported, hidden.id); });
    outcome.found = outcome.found && is_found;
    outcome.clear_missed = outcome.clear_missed || (!is_found && hidden.evidence >= enough);
  }
  if (outcome.hidden.empty()) outcome.right_verdict = is_right_verdict(outcome, asked, set);
  if (diagnosis.contains("odds") && diagnosis.at("odds").is_object())
    for (const auto& [id, probability] : diagnosis.at("odds").at("effects").items())
      if (probability.get<double>() >= least_stated)
        outcome.odds.push_back(
            {.probability = probability, .is_there = contains(outcome.hidden, id) || contains(allowed, id)});
  const bool all_there = outcome.hidden.empty() ? !outcome.reported.empty() : outcome.found;
  outcome.explained_wrong = outcome.verdict == "explained" && (outcome.invented || !all_there);
  count_effect_intervals(diagnosis, set, outcome);
  if (!outcome.invented && (outcome.hidden.empty() || outcome.found)) count_number_intervals(diagnosis, set, outcome);
  take_errors(diagnosis, set, outcome);
  outcome.warned = diagnosis.contains("warnings") && !diagnosis.at("warnings").empty();
  return outcome;
}

}  // namespace attribution::laboratory
