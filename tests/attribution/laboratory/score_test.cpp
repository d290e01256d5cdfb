#include "attribution/laboratory/score.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "degree.hpp"

namespace attribution::laboratory {
namespace {

using nlohmann::json;
using truth::laboratory::DeclaredFaces;
using truth::laboratory::Deviation;
using truth::laboratory::LaboratorySet;
using truth::laboratory::Tolerances;

json diagnosis(const std::string& verdict, const std::vector<std::string>& effects = {},
               const std::vector<std::vector<std::string>>& ambiguous = {}) {
  json out = {{"format", "diagnosis/1"},        {"verdict", verdict},
              {"effects", json::array()},       {"error", {{"validate", json::object()}, {"fit", json::object()}}},
              {"indistinguishable", ambiguous}, {"calibration", json::object()}};
  for (const std::string& id : effects) out["effects"].push_back({{"id", id}, {"parameters", json::object()}});
  return out;
}

LaboratorySet hiding(const std::vector<std::string>& ids) {
  LaboratorySet set;
  set.answer.common.noise = 0.3 * degree;
  set.answer.common.joint_stiffness = 0.0125;
  set.answer.common.joint_damping = 1.3e-4;
  for (const std::string& id : ids) {
    truth::HiddenEffect effect;
    effect.id = id;
    effect.evidence = 100.0;
    set.answer.common.hidden.push_back(effect);
  }
  set.runs.emplace_back().planned.validate = true;
  return set;
}

Outcome scored(Category category, const LaboratorySet& set, const json& found) {
  const Case asked{.number = 3, .category = category, .conditions = {"clocks"}, .request = set.request};
  return score(asked, set, found.dump());
}

TEST(LaboratoryScore, FindsWhatIsReportedOrInASetReported) {
  const LaboratorySet one = hiding({"drag"});
  EXPECT_TRUE(scored(Category::one, one, diagnosis("explained", {"drag"})).found);
  const Outcome in_set = scored(Category::one, one, diagnosis("explained", {"lag"}, {{"lag", "drag"}}));
  EXPECT_TRUE(in_set.found);
  EXPECT_FALSE(in_set.invented);
  EXPECT_FALSE(in_set.explained_wrong);
  const Outcome further = scored(Category::one, one, diagnosis("explained", {"tilt", "drag"}));
  EXPECT_TRUE(further.found);
  EXPECT_TRUE(further.invented);
  EXPECT_TRUE(further.explained_wrong);
  const Outcome missed = scored(Category::one, one, diagnosis("partly_explained", {"tilt"}));
  EXPECT_FALSE(missed.found);
  EXPECT_FALSE(missed.explained_wrong);
  const Outcome half = scored(Category::two, hiding({"drag", "tilt"}), diagnosis("explained", {"drag"}));
  EXPECT_FALSE(half.found);
  EXPECT_FALSE(half.invented);
  EXPECT_TRUE(half.explained_wrong);
  EXPECT_TRUE(half.clear_missed);
  LaboratorySet weak = hiding({"drag", "tilt"});
  weak.answer.common.hidden[1].evidence = 5.0;
  EXPECT_FALSE(scored(Category::two, weak, diagnosis("explained", {"drag"})).clear_missed);
  EXPECT_TRUE(scored(Category::two, weak, diagnosis("explained", {"tilt"})).clear_missed);
  EXPECT_TRUE(scored(Category::outsider, hiding({"gusts"}), diagnosis("explained", {"drag"})).explained_wrong);
}

TEST(LaboratoryScore, AsksForEffectsThatAreClear) {
  LaboratorySet set = hiding({"drag", "tilt"});
  EXPECT_TRUE(scored(Category::two, set, diagnosis("unexplained")).visible);
  set.answer.common.hidden[1].evidence = 29.0;
  const Outcome weak = scored(Category::two, set, diagnosis("unexplained"));
  EXPECT_FALSE(weak.visible);
  EXPECT_EQ(weak.evidence, 29.0);
  set.request.at_bound = true;
  EXPECT_TRUE(scored(Category::two, set, diagnosis("unexplained")).visible);
}

TEST(LaboratoryScore, KnowsTheRightVerdictWhereNothingIsHidden) {
  LaboratorySet set = hiding({});
  const auto right = [&](const json& found) { return scored(Category::nothing, set, found).right_verdict; };
  EXPECT_TRUE(right(diagnosis("no_missing_effect")));
  EXPECT_FALSE(right(diagnosis("unexplained")));
  EXPECT_FALSE(right(diagnosis("declared_numbers_off")));
  set.request.faces = DeclaredFaces::absent;
  EXPECT_TRUE(right(diagnosis("declared_numbers_off")));
  set.request.faces = DeclaredFaces::none;
  set.request.deviation = Deviation::within;
  set.request.tolerances = Tolerances::listed;
  EXPECT_FALSE(right(diagnosis("declared_numbers_off")));
  set.request.tolerances = Tolerances::absent;
  EXPECT_TRUE(right(diagnosis("declared_numbers_off")));
  const Outcome invented = scored(Category::nothing, set, diagnosis("explained", {"creep"}));
  EXPECT_TRUE(invented.false_name);
  EXPECT_TRUE(invented.explained_wrong);
  EXPECT_TRUE(scored(Category::colour_unknown, set, diagnosis("unexplained")).right_verdict);
  EXPECT_FALSE(scored(Category::colour_unknown, set, diagnosis("explained", {"creep"})).right_verdict);
}

TEST(LaboratoryScore, LetsANumberThatIsFarOffBearItsName) {
  LaboratorySet set = hiding({});
  set.answer.built.numbers = {{.name = "/magnetics/0/magnet/remanence_T", .far = true},
                              {.name = "/magnetics/1/magnet/remanence_T", .far = true},
                              {.name = "/links/1/mass_kg", .far = false}};
  const auto outcome = [&](const json& found) { return scored(Category::far, set, found); };
  EXPECT_TRUE(outcome(diagnosis("declared_numbers_off")).right_verdict);
  EXPECT_TRUE(outcome(diagnosis("explained", {"force_gain"})).right_verdict);
  EXPECT_FALSE(outcome(diagnosis("explained", {"added_mass"})).right_verdict);
  EXPECT_TRUE(outcome(diagnosis("explained", {"added_mass"})).false_name);
  EXPECT_FALSE(outcome(diagnosis("no_missing_effect")).right_verdict);
  set.answer.built.numbers[2].far = true;  // two numbers: there is no one name
  EXPECT_TRUE(outcome(diagnosis("explained", {"force_gain"})).false_name);
  EXPECT_TRUE(outcome(diagnosis("declared_numbers_off")).right_verdict);
}

TEST(LaboratoryScore, CountsIntervalsInTheUnitsOfTheirKeys) {
  LaboratorySet set = hiding({"friction"});
  set.answer.common.hidden[0].numbers = {{.key = "torque_Nmm", .value = 0.2}, {.key = "side", .value = 1.0}};
  set.answer.built.numbers = {{.name = "/links/1/mass_kg", .declared = 0.0225, .is = 0.024, .tolerance = 1e-3},
                              {.name = "force_curve", .declared = 0.0, .is = 0.03, .tolerance = 0.03}};
  json found = diagnosis("explained", {"friction"});
  found["effects"][0]["parameters"] = {{"torque_Nmm", {{"value", 0.21}, {"ci95", {0.19, 0.23}}}},
                                       {"side", {{"value", 1}, {"ci95", {2, 3}}}}};
  found["calibration"] = {{"joint_stiffness_Nmm_rad", {{"value", 12.4}, {"ci95", {12.3, 12.6}}}},
                          {"joint_damping_Nmms_rad", {{"value", 0.2}, {"ci95", {0.19, 0.21}}}}};
  found["nominal"] = {{"/links/1/mass_kg", {{"value", 0.0238}, {"ci95", {0.0236, 0.0241}}}},
                      {"force_curve", {{"value", 0.01}, {"ci95", {0.0, 0.02}}}}};
  Outcome outcome = scored(Category::one, set, found);
  EXPECT_EQ(outcome.effect_intervals.of, 1);
  EXPECT_EQ(outcome.effect_intervals.hits, 1);
  EXPECT_EQ(outcome.number_intervals.of, 3);
  EXPECT_EQ(outcome.number_intervals.hits, 2);  // not the damping
  // A second joint that is 8 % stiffer: the mean is 4 % above the first.
  LaboratorySet unlike = set;
  unlike.answer.built.numbers = {{.name = "joint_stiffness_ratio", .declared = 1.0, .is = 1.08, .tolerance = 0.06}};
  json mean = found;
  mean["calibration"] = {{"joint_stiffness_Nmm_rad", {{"value", 13.0}, {"ci95", {12.95, 13.05}}}}};
  mean["nominal"] = {{"joint_stiffness_ratio", {{"value", 0.0769}, {"ci95", {0.076, 0.078}}}}};
  EXPECT_EQ(scored(Category::one, unlike, mean).number_intervals.hits, 2);
  found["effects"][0]["parameters"]["torque_Nmm"]["ci95"] = {0.19, nullptr};
  found["calibration"]["joint_damping_Nmms_rad"]["determined"] = false;
  outcome = scored(Category::one, set, found);
  EXPECT_EQ(outcome.effect_intervals.of, 0);
  EXPECT_EQ(outcome.number_intervals.of, 2);
  found["effects"].push_back({{"id", "creep"}, {"parameters", json::object()}});
  EXPECT_EQ(scored(Category::one, set, found).number_intervals.of, 0);  // those of another model
}

TEST(LaboratoryScore, TakesErrorsOverTheTrueNoise) {
  LaboratorySet set = hiding({"saturating_iron"});
  json found = diagnosis("partly_explained", {"force_gain"});
  found["error"]["validate"] = {
      {"before", {{"rmse_deg", 0.9}}}, {"after", {{"rmse_deg", 0.45}}}, {"corrected", {{"rmse_deg", 0.36}}}};
  Outcome outcome = scored(Category::outsider, set, found);
  EXPECT_TRUE(outcome.state_dependent);
  EXPECT_NEAR(*outcome.after_over_noise, 1.5, 1e-12);
  EXPECT_NEAR(*outcome.excess_left, 0.1, 1e-12);
  EXPECT_NEAR(*outcome.corrected_over_before, 0.4, 1e-12);
  // A picture in four is wrong by 0.8 degrees: with the noise 0.5 together.
  set.runs[0].stamps = {0.0, 0.1, 0.2, 0.3};
  set.runs[0].outliers = {{.time = 0.1, .by = -0.8 * degree}};
  outcome = scored(Category::outsider, set, found);
  EXPECT_NEAR(*outcome.after_over_noise, 0.9, 1e-12);
  found["outliers"] = {{{"run", "step.csv"}, {"times_s", {0.1}}}};  // set aside
  EXPECT_NEAR(*scored(Category::outsider, set, found).after_over_noise, 1.5, 1e-12);
  set.runs[0].planned.validate = false;  // what was held out is the tool's choice
  EXPECT_FALSE(scored(Category::outsider, set, found).after_over_noise);
  EXPECT_FALSE(scored(Category::outsider, hiding({"saturating_iron"}), diagnosis("unexplained")).excess_left);
  EXPECT_THROW((void)scored(Category::one, set, "no diagnosis"), json::exception);
}

}  // namespace
}  // namespace attribution::laboratory
