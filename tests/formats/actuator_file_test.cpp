#include "coilwright/formats/actuator_file.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <string>

#include "coilwright/simulation/performance.hpp"
#include "input_error_text.hpp"

namespace coilwright::formats {
namespace {

using testing::error_of;

constexpr double degree = std::numbers::pi / 180.0;

// `text` with the first `old` in it replaced.
std::string changed(std::string text, const std::string& old, const std::string& replacement) {
  return text.replace(text.find(old), old.size(), replacement);
}

std::string refusal(const std::string& text) {
  return error_of([&] { (void)parse_actuator(text, "a.json"); });
}

actuator::Design design_of(const std::string& text) {
  return std::get<actuator::Design>(parse_actuator(text, "a.json").content);
}

const std::string full_design = R"({
  "format": "actuator/1", "name": "full", "description": "every section",
  "layout": ["coil", "magnet", "coil", "magnet"], "polarity": [1, -1, -1, 1],
  "coil": {"inner_radius_mm": 3.1, "turns_radial": 14, "turns_axial": 29, "wire_gauge_AWG": 27},
  "magnet": {"radius_mm": 9.3, "length_mm": 5.7, "remanence_T": 1.31, "density_kg_m3": 7450,
             "temperature_limit_degC": 85},
  "body": {"gap_mm": 0.95, "bottom_layer_mm": 2.4, "loss_time_ms": 9.7, "shore_hardness_A": 31},
  "surroundings": {"gravity_m_s2": 9.79, "base_tilt_deg": 12, "ambient_degC": 22, "coil_limit_degC": 130,
                   "heat_transfer_W_m2K": 47},
  "model": {"winding": "layer_centres", "torque": "line_of_centres", "face_contact": "walls",
            "segment_mass": "on_axis_points"},
  "calibration": {"joint_damping_factor": 1.07, "tip_com_factor": 0.93}
})";

TEST(ActuatorFile, PutsEveryKeyIntoItsPlaceInSi) {
  const ActuatorFile file = parse_actuator(full_design, "a.json");
  EXPECT_EQ(file.name, "full");
  const auto& design = std::get<actuator::Design>(file.content);
  ASSERT_EQ(design.layout.size(), 4u);
  EXPECT_EQ(design.layout[3].kind, actuator::ComponentKind::magnet);
  EXPECT_EQ(design.layout[2].polarity, -1);
  // 3.1 / 1000 and 3.1e-3 may be neighbouring doubles.
  EXPECT_DOUBLE_EQ(design.coil.inner_radius, 3.1e-3);
  EXPECT_EQ(design.coil.turns_axial, 29);
  EXPECT_EQ(design.coil.wire_gauge, 27);
  EXPECT_DOUBLE_EQ(design.magnet.radius, 9.3e-3);
  EXPECT_EQ(design.magnet.remanence, 1.31);
  EXPECT_DOUBLE_EQ(design.body.gap, 0.95e-3);
  EXPECT_DOUBLE_EQ(design.body.loss_time, 9.7e-3);
  EXPECT_EQ(design.body.shore_hardness, 31.0);
  EXPECT_DOUBLE_EQ(design.surroundings.base_tilt, 12.0 * degree);
  EXPECT_EQ(design.surroundings.ambient, 22.0);
  EXPECT_EQ(design.choices.winding, magnetics::Winding::layer_centres);
  EXPECT_EQ(design.choices.torque, magnetics::Fidelity::line_of_centres);
  EXPECT_EQ(design.choices.faces, actuator::FaceContact::walls);
  EXPECT_EQ(design.choices.masses, actuator::SegmentMass::on_axis_points);
  EXPECT_EQ(design.calibration.joint_damping, 1.07);
  EXPECT_EQ(design.calibration.tip_com, 0.93);
}

TEST(ActuatorFile, LeavesWhatIsAbsentAtItsDefault) {
  const actuator::Design design = design_of(R"({"format": "actuator/1", "configuration": "C"})");
  const actuator::Design usual;
  EXPECT_EQ(design.layout.size(), 5u);
  EXPECT_EQ(design.coil.inner_radius, usual.coil.inner_radius);
  EXPECT_EQ(design.body.hinge_length, usual.body.hinge_length);
  EXPECT_EQ(design.choices.winding, usual.choices.winding);
  EXPECT_EQ(design.calibration.heat_transfer, 1.0);
}

TEST(ActuatorFile, TurnsMeasuredValuesIntoFactorsThatGiveThemBack) {
  const actuator::Design design = design_of(R"({"format": "actuator/1", "configuration": "B",
      "measured": {"joint_stiffness_Nmm_rad": 14.2, "coil_resistance_Ohm": 4.1}})");
  const actuator::Assembly assembly = actuator::assemble_or_throw(design);
  // A factor and its product round once each.
  EXPECT_DOUBLE_EQ(assembly.model.hinges().front().stiffness, 14.2e-3);
  EXPECT_DOUBLE_EQ(assembly.coil.resistance, 4.1);
  EXPECT_EQ(design.calibration.axis_offset, 1.0);
}

TEST(ActuatorFile, RefusesALayoutThatCannotBeBuilt) {
  EXPECT_EQ(refusal(changed(full_design, R"("coil", "magnet", "coil", "magnet")", R"("coil", "coil", "coil", "coil")")),
            "a.json: /layout: layout must have at least one magnet; got none");
  EXPECT_EQ(refusal(changed(full_design, "[1, -1, -1, 1]", "[1, -1, -1]")),
            "a.json: /polarity: must have 4 elements; got an array of 3");
  EXPECT_EQ(refusal(changed(full_design, "[1, -1, -1, 1]", "[1, -1, 2, 1]")),
            "a.json: /polarity/2: must be 1 or -1; got 2");
  EXPECT_EQ(refusal(changed(full_design, R"("magnet", "coil", "magnet")", R"("magnet", "coil", "glue")")),
            R"(a.json: /layout/3: must be one of "coil", "magnet"; got text "glue")");
  EXPECT_EQ(refusal(changed(full_design, R"("layout": [)", R"("configuration": "B", "layout": [)")),
            R"(a.json: /layout: cannot stand beside "configuration")");
}

TEST(ActuatorFile, RefusesWordsAndMeasurementsThatDoNotExist) {
  EXPECT_EQ(refusal(changed(full_design, "layer_centres", "layers")),
            R"(a.json: /model/winding: must be one of "paper_shells", "layer_centres", "uniform"; got text "layers")");
  EXPECT_EQ(refusal(changed(full_design, R"("calibration": {)", R"("measured": {}, "calibration": {)")),
            R"(a.json: /: gives "measured" and "calibration"; only one of them may be there)");
  EXPECT_EQ(refusal(R"({"format": "actuator/1", "configuration": "B", "measured": {"tip_com_mm": 1e9}})"),
            "a.json: /measured/tip_com_mm: must be > 0 and <= 1000000; got 1000000000");
  EXPECT_EQ(refusal(changed(full_design, R"("tip_com_factor": 0.93)", R"("tip_com_factor": 0)")),
            "a.json: /calibration/tip_com_factor: must be > 0 and <= 1000000; got 0");
}

const std::string lumped = R"({
  "format": "lumped-model/1", "gravity_m_s2": 9.7,
  "links": [{"length_m": 0.019, "com_along_m": 0.011, "com_offset_m": 0.004, "mass_kg": 0.017, "inertia_kgm2": 0},
            {"length_m": 0.021, "com_along_m": 0.009, "com_offset_m": 0.003, "mass_kg": 0.022, "inertia_kgm2": 1e-6}],
  "joints": [{"stiffness_Nm_rad": 0.0125, "damping_Nms_rad": 1.3e-4,
              "contact": {"closing_angle_deg": -3, "stiffness_Nm_rad": 0.4}},
             {"stiffness_Nm_rad": 0.0131, "damping_Nms_rad": 1.4e-4, "torque_offset_Nm": 2e-4}],
  "magnetics": [null, {"angle_deg": [-10, 0, 30, 60, 110], "torque_Nmm_A": [19.0, 17.5, 9.0, 4.1, 1.3]}]
})";

TEST(LumpedModel, IsReadJointByJoint) {
  const auto model = std::get<actuator::Model>(parse_actuator(lumped, "a.json").content);
  EXPECT_EQ(model.joints(), 2);
  EXPECT_EQ(model.coils(), 1);
  EXPECT_DOUBLE_EQ(model.hinges()[0].contact.closing_angle, -3.0 * degree);
  EXPECT_EQ(model.hinges()[0].contact.stiffness, 0.4);
  EXPECT_EQ(model.hinges()[1].torque_offset, 2e-4);
}

TEST(LumpedModel, PassesThroughTheTorquesOfItsTable) {
  const auto model = std::get<actuator::Model>(parse_actuator(lumped, "a.json").content);
  // The table's torque at 30 degrees, times 0.7 A, is all that current adds. 1e-4 of the largest torque is what the
  // curve is built to.
  const mechanics::JointVector angles = (mechanics::JointVector(2) << 0.1, 30.0 * degree).finished();
  const mechanics::JointVector added =
      model.static_residual(angles, model.all_coils(0.7)) - model.static_residual(angles, model.all_coils(0.0));
  EXPECT_EQ(added[0], 0.0);
  EXPECT_NEAR(added[1], 0.7 * 9.0e-3, 0.7 * 19.0e-3 * 1e-4);
}

TEST(LumpedModel, RefusesWhatDoesNotFitTogether) {
  EXPECT_EQ(refusal(changed(lumped, "[null, {", "[{")), "a.json: /magnetics: must have 2 elements; got an array of 1");
  EXPECT_EQ(refusal(changed(lumped, "[-10, 0, 30, 60, 110]", "[-10, 0, 60, 30, 110]")),
            "a.json: /magnetics/1/angle_deg: must increase from one angle to the next");
  EXPECT_EQ(refusal(changed(lumped, "[19.0, 17.5, 9.0, 4.1, 1.3]", "[19.0, 17.5, 9.0]")),
            "a.json: /magnetics/1/torque_Nmm_A: must have 5 elements; got an array of 3");
  EXPECT_EQ(refusal(changed(lumped, "[-10, 0, 30, 60, 110]", "[-10, 0, 30]")),
            "a.json: /magnetics/1/angle_deg: must have at least 4 elements; got an array of 3");
  EXPECT_EQ(refusal(changed(lumped, R"("mass_kg": 0.017)", R"("mass_kg": -0.017)")),
            "a.json: /links/0/mass_kg: must be > 0; got -0.017");
  EXPECT_EQ(refusal(changed(lumped, R"("stiffness_Nm_rad": 0.0125)", R"("stiffness_Nmm_rad": 12.5)")),
            R"(a.json: /joints/0/stiffness_Nmm_rad: unknown key; did you mean "stiffness_Nm_rad"?)");
  EXPECT_EQ(refusal(changed(lumped, R"("links": [)", R"("segments": 3, "links": [)")),
            "a.json: /segments: unknown key; the keys here are \"description\", \"format\", \"gravity_m_s2\", "
            "\"joints\", \"links\", \"magnetics\", \"name\"");
}

}  // namespace
}  // namespace coilwright::formats
