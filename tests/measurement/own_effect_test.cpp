#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "coilwright/actuator/model/described_effect.hpp"
#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "coilwright/formats/actuator/actuator_argument.hpp"
#include "coilwright/formats/actuator/actuator_file.hpp"
#include "coilwright/formats/actuator/actuator_json.hpp"
#include "coilwright/formats/data/declared_actuator.hpp"
#include "coilwright/measurement/diagnosis.hpp"
#include "measurement/slider_model.hpp"

// An effect that a user's program brings along is read, diagnosed and written like one of ours.
namespace coilwright::measurement {
namespace {

using actuator::Effect;
using actuator::EffectCatalogue;
using mechanics::JointVector;

// q = +c rate |rate|: what pushed_run() hides.
class PushTerm final : public actuator::EffectTerm {
 public:
  explicit PushTerm(double strength) : strength_(strength) {}
  void add_torques(const Kinematics& motion, const actuator::CoilCurrents& /*strength*/, InternalStateView /*own*/,
                   JointVector& torques) const override {
    torques += strength_ * motion.rates.cwiseProduct(motion.rates.cwiseAbs());
  }

 private:
  double strength_;
};

const actuator::DescribedEffect push(
    {.id = "push",
     .stage = actuator::Stage::hinge,
     .description = "something pushes on, the harder the faster it goes",
     .equation = "q += c rate |rate|",
     .source = "this test",
     .parameters = {{.key = "push_Nmms2_rad2",
                     .text = "torque over squared rate",
                     .lower = 0.0,
                     .upper = std::numeric_limits<double>::infinity(),
                     .absent = 0.0}},
     .starts =
         [](const actuator::RigScale& scale) {
           return std::vector<std::vector<double>>{{0.1 * scale.torque / (scale.rate * scale.rate)}};
         },
     .build = [](std::span<const double> values,
                 actuator::ModelSpec& /*spec*/) { return std::make_unique<PushTerm>(values[0]); }});

const EffectCatalogue& own_effects() {
  static const EffectCatalogue all = actuator::standard_effects().with(push);
  return all;
}

// The slide of slider_model.hpp as a file.
std::string slide_file(const std::string& effects) {
  return R"({"format": "lumped-model/1", "gravity_m_s2": 0,
             "links": [{"length_m": 1, "com_along_m": 1, "com_offset_m": 0, "mass_kg": 2, "inertia_kgm2": 0}],
             "joints": [{"stiffness_Nm_rad": 0, "damping_Nms_rad": 3}], "effects": [)" +
         effects + "]}";
}

const std::string declared_push = R"({"id": "push", "parameters": {"push_Nmms2_rad2": 250}})";

TEST(OwnEffect, IsReadWhereTheReaderKnowsIt) {
  const auto file = formats::parse_actuator(slide_file(declared_push), "a.json", own_effects());
  const std::vector<Effect>& effects = std::get<actuator::Model>(file.content).nominal_spec().effects;
  ASSERT_EQ(effects.size(), 1u);
  EXPECT_EQ(effects.front().kind, &push);
  EXPECT_EQ(effects.front().values, std::vector{0.25});
  EXPECT_THROW((void)formats::parse_actuator(slide_file(declared_push), "a.json"), std::runtime_error);
  EXPECT_EQ(formats::parse_effect("push:push_Nmms2_rad2=250", own_effects()).kind, &push);
}

TEST(OwnEffect, IsFoundInMeasuredMotionAndWrittenIntoTheActuator) {
  const auto declared =
      formats::parse_declared_actuator(slide_file(""), "a.json", {.names = {}, .file = "dataset.json"}, own_effects());
  data::Dataset data;
  data.fit.push_back(pushed_run());
  const Diagnosis diagnosis = diagnose(data, declared.model, {.threads = 2, .effects = own_effects()});
  EXPECT_EQ(diagnosis.verdict, Verdict::explained);
  ASSERT_EQ(diagnosis.effects.size(), 1u);
  EXPECT_EQ(diagnosis.effects.front().kind, &push);
  const identification::Estimate& strength = diagnosis.effects.front().parameters.front();
  EXPECT_LE(strength.lower, 1.0);
  EXPECT_GE(strength.upper, 1.0);

  const std::vector<Effect> found = {{.kind = &push, .values = {strength.value}}};
  const std::string text = formats::to_json(declared.updated({}, found), "slide").text();
  const auto back = formats::parse_actuator(text, "a.json", own_effects());
  const std::vector<Effect>& effects = std::get<actuator::Model>(back.content).nominal_spec().effects;
  ASSERT_EQ(effects.size(), 1u);
  EXPECT_EQ(effects.front().kind, &push);
  EXPECT_EQ(effects.front().values, found.front().values);
}

}  // namespace
}  // namespace coilwright::measurement
