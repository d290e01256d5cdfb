// The key "torque_correction" of both formats of an actuator.

#include <gtest/gtest.h>

#include <string>
#include <variant>

#include "coilwright/formats/actuator/actuator_argument.hpp"
#include "coilwright/formats/actuator/actuator_file.hpp"
#include "coilwright/formats/actuator/actuator_json.hpp"
#include "text/input_error_text.hpp"

namespace coilwright::formats {
namespace {

using actuator::CorrectionVariable;
using actuator::Design;
using actuator::TorqueCorrection;
using text::testing::error_of;

std::string pendulum_with(const std::string& correction) {
  return R"({"format": "lumped-model/1", "gravity_m_s2": 9.81,
    "links": [{"length_m": 0.2, "com_along_m": 0.2, "com_offset_m": 0.0, "mass_kg": 0.52, "inertia_kgm2": 0.01}],
    "joints": [{"stiffness_Nm_rad": 0.1, "damping_Nms_rad": 0.001}],
    "torque_correction": )" +
         correction + "}";
}

constexpr const char* good =
    R"({"angle_deg": [-10, 0, 30], "rate_rad_s": [-5, 0, 2, 9], "linear_below_rad_s": 0.4, "joint": 1,
        "torque_Nmm": [[1, 2, 3, 4], [0.5, 0, -0.5, -1], [2, -2, 0.25, 8]]})";

std::string correction_refusal(const std::string& correction) {
  return error_of([&] { (void)parse_actuator(pendulum_with(correction), "rig.json"); });
}

TEST(TorqueCorrectionFormat, IsReadInTheUnitsOfItsKeys) {
  const ActuatorFile file = parse_actuator(pendulum_with(good), "rig.json");
  const auto& correction = std::get<actuator::Model>(file.content).nominal_spec().torque_correction;
  ASSERT_TRUE(correction.has_value());
  ASSERT_EQ(correction->axes.size(), 2U);
  EXPECT_EQ(correction->axes[0].variable, CorrectionVariable::angle);
  EXPECT_DOUBLE_EQ(correction->axes[0].nodes[2], 0.52359877559829887);  // 30 deg
  EXPECT_EQ(correction->axes[1].nodes, (std::vector<double>{-5.0, 0.0, 2.0, 9.0}));
  EXPECT_EQ(correction->axes[1].linear_below, 0.4);
  EXPECT_EQ(correction->joint, 0);
  EXPECT_DOUBLE_EQ(correction->torques[4], 0.5e-3);
  EXPECT_DOUBLE_EQ(correction->torques[11], 8e-3);
}

TEST(TorqueCorrectionFormat, OfADesignIsWrittenAndReadBackTheSame) {
  Design design;
  design.as_built.torque_correction =
      TorqueCorrection{.axes = {{.variable = CorrectionVariable::angle, .nodes = {-0.07, 0.31, 0.52}},
                                {.variable = CorrectionVariable::current, .nodes = {-0.2, 0.7, 1.4}}},
                       .torques = {1e-3, -2e-3, 3e-3, 0.4e-3, 0.0, -0.7e-3, 0.1e-3, 0.3e-3, 0.9e-3},
                       .joint = 1};
  const std::string text = to_json(design, "corrected").text();
  EXPECT_EQ(text.find("as_built"), std::string::npos);
  const Design back = std::get<Design>(parse_actuator(text, "corrected.json").content);
  const TorqueCorrection& was = *design.as_built.torque_correction;
  ASSERT_TRUE(back.as_built.torque_correction.has_value());
  const TorqueCorrection& is = *back.as_built.torque_correction;
  EXPECT_EQ(is.joint, was.joint);
  ASSERT_EQ(is.torques.size(), was.torques.size());
  // Degrees and millimetres round, by two units in the last place at most.
  for (std::size_t i = 0; i < was.torques.size(); ++i) EXPECT_DOUBLE_EQ(is.torques[i], was.torques[i]);
  for (std::size_t a = 0; a < 2; ++a)
    for (std::size_t i = 0; i < 3; ++i) EXPECT_DOUBLE_EQ(is.axes[a].nodes[i], was.axes[a].nodes[i]);
}

TEST(TorqueCorrectionFormat, MayBeOverOneVariable) {
  const ActuatorFile file =
      parse_actuator(pendulum_with(R"({"rate_rad_s": [-5, 0, 9], "torque_Nmm": [1, 0, -2]})"), "rig.json");
  const auto& correction = std::get<actuator::Model>(file.content).nominal_spec().torque_correction;
  EXPECT_EQ(correction->axes.size(), 1U);
  EXPECT_EQ(correction->torques.size(), 3U);
  EXPECT_EQ(correction->joint, std::nullopt);
}

TEST(TorqueCorrectionFormat, IsRefusedAtThePlaceOfTheMistake) {
  EXPECT_EQ(correction_refusal(R"({"torque_Nmm": [1, 2, 3]})"),
            "rig.json: /torque_correction: needs one or two of \"angle_deg\", \"rate_rad_s\", \"current_A\"");
  EXPECT_EQ(correction_refusal(R"({"angle_deg": [0, 1], "torque_Nmm": [1, 2]})"),
            "rig.json: /torque_correction/angle_deg: must have 3 to 100 elements; got an array of 2");
  EXPECT_EQ(correction_refusal(R"({"angle_deg": [0, 2, 1], "torque_Nmm": [1, 2, 3]})"),
            "rig.json: /torque_correction/angle_deg/2: must exceed the value before it; got 1");
  EXPECT_EQ(correction_refusal(R"({"angle_deg": [0, 1, 2], "torque_Nmm": [1, 2]})"),
            "rig.json: /torque_correction/torque_Nmm: must have 3 elements; got an array of 2");
  EXPECT_EQ(correction_refusal(
                R"({"angle_deg": [0, 1, 2], "rate_rad_s": [0, 1, 2], "torque_Nmm": [[1, 2, 3], [1, 2], [1, 2, 3]]})"),
            "rig.json: /torque_correction/torque_Nmm/1: must have 3 elements; got an array of 2");
  EXPECT_EQ(correction_refusal(R"({"angle_deg": [0, 1, 2], "linear_below_rad_s": 1, "torque_Nmm": [1, 2, 3]})"),
            "rig.json: /torque_correction/linear_below_rad_s: must stand beside \"rate_rad_s\"");
  EXPECT_EQ(correction_refusal(R"({"angle_deg": [0, 1, 2], "torque_mNm": [1, 2, 3]})"),
            "rig.json: /torque_correction/torque_mNm: unknown key; did you mean \"torque_Nmm\"?");
  EXPECT_EQ(correction_refusal(R"({"angle_deg": [0, 1, 2], "joint": 2, "torque_Nmm": [1, 2, 3]})"),
            "rig.json: /: torque_correction: joint must be 1 to 1; got 2");
  EXPECT_EQ(correction_refusal(R"({"current_A": [0, 1, 2], "torque_Nmm": [1, 2, 3]})"),
            "rig.json: /: torque_correction: over the current needs coils, and the model has none");
}

TEST(TorqueCorrectionFormat, HoldsForTheGeometryThatWasMeasured) {
  Design design;
  design.as_built.torque_correction = TorqueCorrection{
      .axes = {{.variable = CorrectionVariable::angle, .nodes = {-0.07, 0.31, 0.52}}}, .torques = {1e-3, -2e-3, 3e-3}};
  EXPECT_EQ(error_of([&] { (void)with_assignment(design, "gap_mm=1.2"); }),
            "gap_mm=1.2: must not change: the actuator has a nameless torque correction, which holds for the finger "
            "that was measured alone");
  EXPECT_EQ(error_of([&] { (void)with_assignment(design, "configuration=C"); }),
            "configuration=C: must not change: the actuator has a nameless torque correction, which holds for the "
            "finger that was measured alone");
  EXPECT_NO_THROW((void)with_assignment(design, "ambient_degC=30"));
}

}  // namespace
}  // namespace coilwright::formats
