#include "coilwright/formats/data/diagnosis_json.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numbers>

#include "formats/data/diagnosis_by_hand.hpp"

namespace coilwright::formats {
namespace {

using namespace coilwright::testing;
using namespace measurement;
using nlohmann::ordered_json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

ordered_json json_of(const Diagnosis& diagnosis) {
  return ordered_json::parse(to_json(report_of(diagnosis)).text());
}

std::vector<std::string> keys_of(const ordered_json& object) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  return keys;
}

// Every key of `expected` is in `seen`, in the same order among themselves and with the same value; more may be there.
void expect_holds(const ordered_json& seen, const ordered_json& expected, const std::string& pointer) {
  if (!expected.is_object()) {
    if (expected.is_array() && !expected.empty() && expected[0].is_object()) {
      ASSERT_EQ(seen.size(), expected.size()) << pointer;
      for (std::size_t i = 0; i < expected.size(); ++i)
        expect_holds(seen[i], expected[i], pointer + "/" + std::to_string(i));
      return;
    }
    EXPECT_EQ(seen, expected) << pointer;
    return;
  }
  ASSERT_TRUE(seen.is_object()) << pointer;
  const std::vector<std::string> there = keys_of(seen);
  auto from = there.begin();
  for (const auto& [key, value] : expected.items()) {
    from = std::find(from, there.end(), key);
    ASSERT_NE(from, there.end()) << pointer << "/" << key << " is missing, or not in the order of the format";
    expect_holds(seen[key], value, pointer + "/" + key);
  }
}

TEST(DiagnosisJson, IsTheFormatsExampleToTheLetter) {
  const auto example_of_the_format = ordered_json::parse(R"({
    "format": "diagnosis/1",
    "verdict": "explained",
    "effects": [
      {"id": "dry_friction", "parameters": {"torque_Nmm": {"value": 0.61, "ci95": [0.58, 0.64]}}, "evidence": {}}
    ],
    "indistinguishable": [["coil_heating", "magnet_heating"]],
    "error": {
      "validate": {
        "declared": {"mae_deg": 2.9, "rmse_deg": 3.5, "max_deg": 9.1},
        "before":   {"mae_deg": 1.1, "rmse_deg": 1.4, "max_deg": 5.0},
        "after":    {"mae_deg": 0.24, "rmse_deg": 0.30, "max_deg": 1.2},
        "noise_floor_rmse_deg": 0.30
      },
      "fit": {}
    },
    "calibration": {"joint_stiffness_Nmm_rad": {"value": 12.4, "ci95": [12.3, 12.5]}},
    "updated_actuator": "actuator.json",
    "next_experiment": null
  })");
  expect_holds(json_of(example()), example_of_the_format, "");
  const auto first = keys_of(json_of(example()));
  EXPECT_THAT(std::vector(first.begin(), first.begin() + 8),
              ElementsAre("format", "verdict", "effects", "indistinguishable", "error", "calibration",
                          "updated_actuator", "next_experiment"));
}

TEST(DiagnosisJson, HasTheFourthColumnAndThePictureOfANamelessCorrection) {
  const Diagnosis diagnosis = corrected_example();
  DiagnosisReport report = report_of(diagnosis);
  report.corrected_actuator = "corrected_actuator.json";
  const auto seen = ordered_json::parse(to_json(report).text());
  expect_holds(seen, ordered_json::parse(R"({
    "error": {"validate": {"corrected": {"mae_deg": 0.2, "rmse_deg": 0.25, "max_deg": 1.0}}},
    "corrected_actuator": "corrected_actuator.json",
    "nameless_correction": {
      "variables": [{"variable": "angle", "from_deg": -5.0, "to_deg": 40.0},
                    {"variable": "rate", "from_deg_s": -90.0, "to_deg_s": 90.0}],
      "effects": [], "rms_Nmm": 0.5, "explained": 0.8, "cross_validated_gain": 0.71, "degrees_of_freedom": 6.5,
      "products": [0.97, 0.99, 1.0],
      "largest": {"angle_deg": 40.0, "rate_deg_s": -90.0, "torque_Nmm": 0.3},
      "smallest": {"angle_deg": 40.0, "rate_deg_s": 90.0, "torque_Nmm": -0.25}
    },
    "no_correction": null
  })"),
               "");
  const auto without = json_of(example());
  EXPECT_FALSE(without["error"]["validate"].contains("corrected"));
  EXPECT_TRUE(without["corrected_actuator"].is_null());
  EXPECT_TRUE(without["nameless_correction"].is_null());
}

TEST(DiagnosisJson, HasAWordForEachVerdict) {
  Diagnosis diagnosis;
  for (const auto& [verdict, word] :
       {std::pair(Verdict::no_missing_effect, "no_missing_effect"), std::pair(Verdict::explained, "explained"),
        std::pair(Verdict::partly_explained, "partly_explained"), std::pair(Verdict::unexplained, "unexplained"),
        std::pair(Verdict::declared_numbers_off, "declared_numbers_off")}) {
    diagnosis.verdict = verdict;
    EXPECT_EQ(json_of(diagnosis)["verdict"], word);
  }
}

// Whatever its further numbers, and whatever stands beside it.
TEST(DiagnosisJson, GivesTheProbabilityOfAnEffectOverAllHypothesesWithIt) {
  const NamedEffect with_further_numbers("dry_friction", "friction that falls with the speed");
  Diagnosis diagnosis = example();
  EXPECT_EQ(json_of(diagnosis)["effects"][0]["evidence"], ordered_json::parse(R"({"probability": 0.9375})"));
  diagnosis.odds.hypotheses = {weighed({&dry_friction}, 12000.0, 0.5), weighed({&with_further_numbers}, 11900.0, 0.25),
                               weighed({&end_stop, &dry_friction}, 11900.0, 0.125), weighed({}, 52000.0, 0.125)};
  EXPECT_EQ(json_of(diagnosis)["effects"][0]["evidence"], ordered_json::parse(R"({"probability": 0.875})"));
}

TEST(DiagnosisJson, HasNullForASideWithoutABound) {
  Diagnosis diagnosis = example();
  identification::Estimate& estimate = diagnosis.effects[0].parameters[0];
  estimate.lower = -infinity;
  auto parameter = json_of(diagnosis)["effects"][0]["parameters"]["torque_Nmm"];
  EXPECT_EQ(parameter, ordered_json::parse(R"({"value": 0.61, "ci95": [null, 0.64]})"));
  estimate.upper = infinity;
  estimate.determined = false;
  parameter = json_of(diagnosis)["effects"][0]["parameters"]["torque_Nmm"];
  EXPECT_EQ(parameter, ordered_json::parse(R"({"value": 0.61, "ci95": [null, null], "determined": false})"));
}

TEST(DiagnosisJson, SaysOfAChoiceThatItIsOne) {
  Diagnosis diagnosis = example();
  diagnosis.effects = {stopped()};
  const auto parameters = json_of(diagnosis)["effects"][0]["parameters"];
  EXPECT_NEAR(parameters["angle_deg"]["ci95"][0].get<double>(), 39.0, 1e-12);  // some roundings
  EXPECT_FALSE(parameters["angle_deg"].contains("choice"));
  EXPECT_EQ(parameters["side"], ordered_json::parse(R"({"value": -1.0, "ci95": [-1.0, -1.0], "choice": true})"));
}

TEST(DiagnosisJson, SaysOfANumberThatItHasManyOptima) {
  Diagnosis diagnosis = example();
  diagnosis.effects[0].parameters[0].has_many_optima = true;
  const auto parameter = json_of(diagnosis)["effects"][0]["parameters"]["torque_Nmm"];
  EXPECT_EQ(parameter, ordered_json::parse(R"({"value": 0.61, "ci95": [0.58, 0.64], "many_optima": true})"));
}

TEST(DiagnosisJson, PutsOtherQuantitiesBesideTheAngle) {
  Diagnosis diagnosis = example();
  ErrorComparison torque = comparison(data::ChannelKind::torque, 12, 1e-3);
  torque.after = {.mae = 0.5e-3, .rmse = 0.75e-3, .max = 2e-3};
  ErrorComparison rate = comparison(data::ChannelKind::joint_rate, 3, 0.5 * degree);
  ErrorComparison heat = comparison(data::ChannelKind::temperature, 4, 0.25);
  ErrorComparison force = comparison(data::ChannelKind::force, 5, 0.125);
  // An angle comes first wherever it stands.
  diagnosis.validate_errors.insert(diagnosis.validate_errors.begin(), torque);
  for (const auto& each : {rate, heat, force}) diagnosis.validate_errors.push_back(each);
  const auto block = json_of(diagnosis)["error"]["validate"];
  EXPECT_EQ(block["after"]["rmse_deg"], 0.30);
  EXPECT_EQ(block["quantity"], "angle");
  EXPECT_EQ(block["samples"], 900);
  EXPECT_EQ(block["torque"]["after"], ordered_json::parse(R"({"mae_Nmm": 0.5, "rmse_Nmm": 0.75, "max_Nmm": 2.0})"));
  EXPECT_EQ(block["torque"]["noise_floor_rmse_Nmm"], 1.0);
  EXPECT_EQ(block["torque"]["samples"], 12);
  EXPECT_EQ(block["joint_rate"]["noise_floor_rmse_deg_s"], 0.5);
  EXPECT_EQ(block["temperature"]["noise_floor_rmse_K"], 0.25);
  EXPECT_EQ(block["force"]["noise_floor_rmse_N"], 0.125);
}

TEST(DiagnosisJson, UsesTheQuantitysUnitWhereThereIsNoAngle) {
  Diagnosis diagnosis;
  diagnosis.fit_errors = {comparison(data::ChannelKind::force, 5, 0.125)};
  const auto block = json_of(diagnosis)["error"];
  EXPECT_EQ(block["fit"]["noise_floor_rmse_N"], 0.125);
  EXPECT_EQ(block["fit"]["after"], ordered_json::parse(R"({"mae_N": 0.0, "rmse_N": 0.0, "max_N": 0.0})"));
  EXPECT_EQ(block["validate"], ordered_json::object());
}

TEST(DiagnosisJson, DescribesTheNextExperimentTheResidualAndTheNoise) {
  Diagnosis diagnosis = example();
  diagnosis.next_experiment = {.kind = "hot_hold",
                               .input = "1.05 A for 60 s",
                               .why = "they part when hot",
                               .open_bits = 1.5,
                               .remaining_bits = 0.25,
                               .experiment = {}};
  diagnosis.residual = localise::ResidualTorque{
      .rms = 0.2e-3,
      .noise_floor = 0.05e-3,
      .dependences =
          {{.variable = "rate", .explained = 0.5, .at = {-90.0 * degree, 90.0 * degree}, .residual = {0.1e-3, -0.1e-3}},
           {.variable = "current history", .explained = 0.25, .at = {1.0}, .residual = {nan}}},
      .frequency = 5.0};
  diagnosis.noise = {
      {.run = "a.csv", .channel = "bending_angle_deg", .sigma = 0.3 * degree, .given = true, .source = "given"},
      {.run = "b.csv",
       .channel = "torque_Nm",
       .sigma = 0.002,
       .source = "second differences",
       .colour = "white, as the still run"},
      {.run = "c.csv", .channel = "temperature_degC", .sigma = 0.5, .given = true, .source = "given"}};
  diagnosis.warnings = {{.run = "a.csv", .text = "saturated"}, {.run = "", .text = "few runs"}};
  const auto json = json_of(diagnosis);
  EXPECT_EQ(json["next_experiment"], ordered_json::parse(R"({"kind": "hot_hold", "input": "1.05 A for 60 s",
      "why": "they part when hot", "open_bits": 1.5, "remaining_bits": 0.25, "file": null})"));
  EXPECT_EQ(json["residual"], ordered_json::parse(R"({"rms_Nmm": 0.2, "smallest_visible_Nmm": 0.05, "dependences": [
      {"variable": "rate", "explained": 0.5, "at_deg_s": [-90.0, 90.0], "residual_Nmm": [0.1, -0.1]},
      {"variable": "current history", "explained": 0.25, "at": [1.0], "residual_Nmm": [null]}],
      "frequency_Hz": 5.0})"));
  EXPECT_EQ(json["noise"], ordered_json::parse(R"([
      {"run": "a.csv", "channel": "bending_angle_deg", "sigma_deg": 0.3, "source": "given", "colour": null},
      {"run": "b.csv", "channel": "torque_Nm", "sigma_Nm": 0.002, "source": "second differences",
       "colour": "white, as the still run"},
      {"run": "c.csv", "channel": "temperature_degC", "sigma_K": 0.5, "source": "given", "colour": null}])"));
  EXPECT_EQ(json["warnings"],
            ordered_json::parse(R"([{"run": "a.csv", "text": "saturated"}, {"run": null, "text": "few runs"}])"));
  EXPECT_EQ(json["adequacy"]["after"]["noise_only"], true);
  EXPECT_EQ(json["seed"], 7);
  EXPECT_EQ(json["dataset"], "finger-2024-03-11");
}

TEST(DiagnosisJson, HasTheHypothesesThatWereComparedAndThoseThatWereNot) {
  Diagnosis diagnosis = example();
  diagnosis.odds.hypotheses = {weighed({&coil_heating, &dry_friction}, 12000.0, 0.75, 0.5), weighed({}, 52000.0, 0.25)};
  diagnosis.odds.hypotheses.front().at_optimum = false;
  diagnosis.odds.ruled_out = {
      {.effects = {&coil_heating}, .remark = "no coils"},
      {.effects = {&end_stop}, .remark = std::string(measurement::identification::not_tested_remark)}};
  const auto json = json_of(diagnosis);
  EXPECT_EQ(json["candidates"], ordered_json::parse(R"([
      {"effects": ["coil_heating", "dry_friction"], "probability": 0.75, "log_evidence": 20000.0,
       "chi_square": 12000.0, "lacks_over_noise": 0.0625, "lacks_over_samples": 8.0, "probability_of_noise": 0.5,
       "at_optimum": false},
      {"effects": [], "probability": 0.25, "log_evidence": 0.0, "chi_square": 52000.0, "lacks_over_noise": 0.0625,
       "lacks_over_samples": 8.0, "probability_of_noise": 0.0, "at_optimum": true}])"));
  EXPECT_EQ(json["ruled_out"][0], ordered_json::parse(R"({"effects": ["coil_heating"], "remark": "no coils"})"));
  EXPECT_EQ(json["ruled_out"][1]["effects"], ordered_json::parse(R"(["end_stop"])"));
  EXPECT_EQ(json["not_tested"], ordered_json::parse(R"(["end_stop"])"));
}

TEST(DiagnosisJson, HasTheOddsOfEachEffectOfNoneAndOfNoise) {
  Diagnosis diagnosis = example();
  diagnosis.odds.hypotheses = {weighed({&dry_friction, &end_stop}, 12000.0, 0.5, 0.875),
                               weighed({&dry_friction}, 12100.0, 0.25, 0.75), weighed({}, 52000.0, 0.25, 0.125)};
  EXPECT_EQ(json_of(diagnosis)["odds"], ordered_json::parse(R"({"no_effect": 0.25,
      "effects": {"dry_friction": 0.75, "end_stop": 0.5}, "noise": 0.75})"));
  // In whatever order the effects are reported.
  diagnosis.effects.insert(diagnosis.effects.begin(), stopped());
  EXPECT_EQ(json_of(diagnosis)["odds"]["noise"], 0.875);
  diagnosis.effects.clear();
  EXPECT_EQ(json_of(diagnosis)["odds"]["noise"], 0.125);
  diagnosis.odds = {};
  EXPECT_TRUE(json_of(diagnosis)["odds"].is_null());
}

// Before anything was compared with it the recalibrated model has no probability, and of what is missing a diagnosis
// says nothing until its end.
TEST(DiagnosisJson, HasNullForWhatAnInterruptedDiagnosisDoesNotKnow) {
  Diagnosis diagnosis = example();
  diagnosis.effects.clear();
  diagnosis.verdict = Verdict::incomplete;
  identification::WeighedHypothesis first = weighed({}, 52000.0, nan, nan);
  first.lacks = first.lacks_over = nan;
  diagnosis.odds.hypotheses = {first};
  const auto json = json_of(diagnosis);
  EXPECT_EQ(json["candidates"], ordered_json::parse(R"([{"effects": [], "probability": null, "log_evidence": 0.0,
      "chi_square": 52000.0, "lacks_over_noise": null, "lacks_over_samples": null, "probability_of_noise": null,
      "at_optimum": true}])"));
  EXPECT_EQ(json["odds"], ordered_json::parse(R"({"no_effect": null, "effects": {}, "noise": null})"));
}

TEST(DiagnosisJson, HasTheDeclaredNumbersThatTheFitMoved) {
  Diagnosis diagnosis = example();
  diagnosis.nominal = {
      {.estimate = {.key = "/measured/tip_segment_mass_g", .value = 0.0205, .lower = 0.02, .upper = 0.021},
       .declared = 0.02,
       .tolerance = 0.0005,
       .named = true},
      {.estimate = {.key = "force_curve", .value = 0.01, .lower = -infinity, .upper = infinity, .determined = false},
       .declared = 0.0,
       .tolerance = 0.03}};
  diagnosis.probability_of_declared = 0.25;
  diagnosis.model_error = 512.0;
  diagnosis.held_exact = {"/magnet/remanence_T"};
  const auto json = json_of(diagnosis);
  EXPECT_EQ(json["nominal"], ordered_json::parse(R"({
      "/measured/tip_segment_mass_g": {"value": 20.5, "ci95": [20.0, 21.0], "declared": 20.0, "tolerance": 0.5,
                                       "tolerance_from": "set"},
      "force_curve": {"value": 0.01, "ci95": [null, null], "determined": false, "declared": 0.0, "tolerance": 0.03,
                      "tolerance_from": "default"}})"));
  EXPECT_EQ(json["probability_of_declared"], 0.25);
  diagnosis.nominal.clear();
  EXPECT_TRUE(json_of(diagnosis)["probability_of_declared"].is_null());
  EXPECT_EQ(json["model_error"], 512.0);
  EXPECT_EQ(json["held_exact"], ordered_json({"/magnet/remanence_T"}));
}

TEST(DiagnosisJson, HasTheEffectsThatAreHintedAt) {
  Diagnosis diagnosis = example();
  EXPECT_EQ(json_of(diagnosis)["hinted"], ordered_json::array());
  diagnosis.hinted = {
      {.kind = diagnosis.effects.front().kind, .gain = -1.5, .number = "joint_stiffness_Nmm_rad", .wider = 2.5}};
  const std::string id(diagnosis.effects.front().kind->id());
  EXPECT_EQ(json_of(diagnosis)["hinted"],
            ordered_json::array(
                {{{"id", id}, {"criterion_gain", -1.5}, {"number", "joint_stiffness_Nmm_rad"}, {"wider", 2.5}}}));
}

TEST(DiagnosisJson, HasTheNumbersOfWhichOneIsOff) {
  Diagnosis diagnosis = example();
  EXPECT_EQ(json_of(diagnosis)["numbers_off"], ordered_json::array());
  diagnosis.numbers_off = {
      {.name = "/measured/tip_segment_mass_g",
       .estimate =
           identification::Estimate{
               .key = "/measured/tip_segment_mass_g", .value = 0.0185, .lower = 0.018, .upper = 0.019},
       .gain = 12.5},
      {.name = "force_curve", .gain = 8.0}};
  EXPECT_EQ(json_of(diagnosis)["numbers_off"], ordered_json::parse(R"([
      {"name": "/measured/tip_segment_mass_g", "criterion_gain": 12.5,
       "estimate": {"value": 18.5, "ci95": [18.0, 19.0]}},
      {"name": "force_curve", "criterion_gain": 8.0}])"));
}

TEST(DiagnosisJson, SaysFromWhereOnADeclaredNumberChangesNothing) {
  Diagnosis diagnosis = example();
  constexpr double degree = std::numbers::pi / 180;
  diagnosis.nominal = {
      {.estimate = {.key = "face_closing_deg", .value = -41 * degree, .lower = -infinity, .upper = -7.75 * degree},
       .declared = 4 * degree,
       .tolerance = 1 * degree,
       .idle_from = -7.75 * degree}};
  const auto faces = json_of(diagnosis)["nominal"]["face_closing_deg"];
  EXPECT_NEAR(faces["idle_from"].get<double>(), -7.75, 1e-12);
  EXPECT_TRUE(faces["ci95"][0].is_null());
  EXPECT_NEAR(faces["ci95"][1].get<double>(), -7.75, 1e-12);
  EXPECT_FALSE(faces.contains("determined"));
}

TEST(DiagnosisJson, ListsOutliers) {
  Diagnosis diagnosis = example();
  EXPECT_EQ(json_of(diagnosis)["outliers"], ordered_json::array());
  diagnosis.outliers = {{.run = "a.csv", .channel = "bending_angle_deg", .times = {0.5, 1.25}}};
  EXPECT_EQ(json_of(diagnosis)["outliers"], ordered_json::parse(R"([
      {"run": "a.csv", "role": "fit", "channel": "bending_angle_deg", "samples": 2, "times_s": [0.5, 1.25]}])"));
  diagnosis.outliers.front().validate = true;
  EXPECT_EQ(json_of(diagnosis)["outliers"][0]["role"], "validate");
}

TEST(DiagnosisJson, SaysNothingOfTime) {
  Diagnosis diagnosis = example();
  const std::string text = to_json(report_of(diagnosis)).text();
  diagnosis.phases = {{.name = "pairs", .seconds = 12.5, .simulated_runs = 4000}};
  EXPECT_EQ(to_json(report_of(diagnosis)).text(), text);
}

}  // namespace
}  // namespace coilwright::formats
