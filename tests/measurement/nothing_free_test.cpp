// A finished model is scored: nothing is calibrated and nothing has a tolerance, whatever is measured.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "coilwright/formats/data/diagnosis_json.hpp"
#include "coilwright/measurement/diagnosis.hpp"
#include "measurement/random_numbers.hpp"
#include "measurement/slider_model.hpp"

namespace coilwright::measurement {
namespace {

// The true slide, of which every number is exact.
replay::DeclaredModel finished() {
  replay::DeclaredModel declared = slide(true_mass, true_damping);
  declared.build = [free = declared.build](std::span<const double>) {
    return free(std::vector<double>{true_mass, true_damping});
  };
  declared.calibration.clear();
  return declared;
}

data::Run motion(const std::string& name, data::Start start, std::optional<double> window, unsigned seed) {
  Normal normal(seed);
  data::Run run = slide_run(150, {}, [&] { return noise_sigma * normal(); });
  run.name = name;
  run.start = start;
  run.window = window;
  return run;
}

// Of a hinge without a spring.
data::Run bench(const std::string& name, unsigned seed) {
  Normal normal(seed);
  data::Run run{.name = name,
                .kind = data::RunKind::joint_stiffness,
                .channels = {{.name = "torque_Nmm", .kind = data::ChannelKind::torque}}};
  for (int i = 0; i < 12; ++i) {
    run.angles.push_back(0.05 * i);
    run.channels.front().values.push_back(1e-4 * normal());
  }
  return run;
}

Diagnosis scored(std::vector<data::Run> fit, std::vector<data::Run> validate,
                 const actuator::EffectCatalogue& effects) {
  data::Dataset data{.name = "finished", .validate = data::SealedRuns(std::move(validate))};
  data.fit = std::move(fit);
  return diagnose(data, finished(), {.threads = 2, .effects = effects});
}

void expect_scored(const Diagnosis& found, std::size_t validated) {
  EXPECT_TRUE(found.calibration.empty());
  EXPECT_TRUE(found.nominal.empty());
  EXPECT_EQ(found.probability_of_declared, 1.0);
  ASSERT_FALSE(found.fit_errors.empty());
  EXPECT_EQ(found.validate_errors.size(), validated);
  for (const ErrorComparison& each : found.fit_errors) EXPECT_DOUBLE_EQ(each.declared.rmse, each.before.rmse);
  const auto json = nlohmann::json::parse(
      formats::to_json({.diagnosis = found, .dataset = "finished", .updated_actuator = "actuator.json"}).text());
  EXPECT_TRUE(json["calibration"].empty());
}

TEST(NothingFree, IsScoredFromEveryStart) {
  const actuator::EffectCatalogue& all = actuator::standard_effects();
  for (const data::Start start : {data::Start::at_rest, data::Start::measured, data::Start::free})
    for (const std::optional<double> window : {std::optional<double>(), std::optional(0.3)}) {
      std::vector<data::Run> held_out;
      if (window) held_out.push_back(motion("v.csv", start, window, 2));
      expect_scored(scored({motion("a.csv", start, window, 1)}, held_out, all), held_out.size());
    }
}

TEST(NothingFree, IsScoredWhereNothingMovesAndWhereNoEffectIsKnown) {
  const actuator::EffectCatalogue none;
  for (const actuator::EffectCatalogue* effects : {&actuator::standard_effects(), &none}) {
    expect_scored(scored({bench("b.csv", 1)}, {}, *effects), 0);
    expect_scored(scored({bench("b.csv", 1), bench("c.csv", 2)}, {bench("v.csv", 3)}, *effects), 1);
    expect_scored(scored({motion("a.csv", data::Start::at_rest, {}, 1), bench("b.csv", 1)}, {}, *effects), 0);
  }
}

}  // namespace
}  // namespace coilwright::measurement
