#include "coilwright/formats/data/declared_actuator.hpp"

#include <gmock/gmock.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/formats/actuator/actuator_file.hpp"
#include "coilwright/formats/data/diagnosis_formatting.hpp"
#include "coilwright/units/unit.hpp"
#include "degree.hpp"
#include "text/input_error_text.hpp"

namespace coilwright::formats {
namespace {

using ::testing::DoubleEq;
using ::testing::ElementsAre;

constexpr double infinity = std::numeric_limits<double>::infinity();

using Names = std::vector<std::string>;

const std::string two_joints = R"({
  "format": "lumped-model/1", "name": "two joints",
  "links": [{"length_m": 0.19, "com_along_m": 0.11, "com_offset_m": 0.0, "mass_kg": 0.17, "inertia_kgm2": 0},
            {"length_m": 0.21, "com_along_m": 0.09, "com_offset_m": 0.03, "mass_kg": 0.22, "inertia_kgm2": 1e-4}],
  "joints": [{"stiffness_Nm_rad": 0.125, "damping_Nms_rad": 1.3e-3,
              "contact": {"closing_angle_deg": -3, "stiffness_Nm_rad": 4}},
             {"stiffness_Nm_rad": 0.125, "damping_Nms_rad": 1.7e-3}],
  "magnetics": [null, {"angle_deg": [-10, 0, 30, 60, 110], "torque_Nmm_A": [19.0, 17.5, 9.0, 4.1, 1.3]}],
  "effects": [{"id": "dry_friction", "parameters": {"torque_Nmm": 0.61}}]
})";

DeclaredActuator declared(const std::string& text, const Names& names) {
  return parse_declared_actuator(text, "a.json", {.names = names, .file = "dataset.json"});
}

std::string refusal(const std::string& text, const Names& names) {
  return text::testing::error_of([&] { (void)declared(text, names); });
}

actuator::ModelSpec file_spec(const std::string& text) {
  return std::get<actuator::Model>(parse_actuator(text, "a.json").content).nominal_spec();
}

std::vector<double> declared_values(const DeclaredActuator& actuator) {
  std::vector<double> values;
  for (const auto& parameter : actuator.model.calibration) values.push_back(parameter.declared);
  return values;
}

// One of the unit that the parameter's key names, SI.
double si_of_one(const measurement::replay::CalibrationParameter& parameter) {
  return units::to_memory(1.0, units::key_with_unit(parameter.key));
}

// Everything but curves, of which it only looks at values.
void expect_same(const actuator::ModelSpec& a, const actuator::ModelSpec& b) {
  EXPECT_EQ(a.chain.gravity(), b.chain.gravity());
  EXPECT_EQ(a.chain.base_tilt(), b.chain.base_tilt());
  ASSERT_EQ(a.chain.joints(), b.chain.joints());
  for (int j = 0; j < a.chain.joints(); ++j) {
    EXPECT_EQ(a.chain.link(j).length, b.chain.link(j).length);
    EXPECT_EQ(a.chain.link(j).com_along, b.chain.link(j).com_along);
    EXPECT_EQ(a.chain.link(j).com_offset, b.chain.link(j).com_offset);
    EXPECT_EQ(a.chain.link(j).mass, b.chain.link(j).mass);
    EXPECT_EQ(a.chain.link(j).inertia, b.chain.link(j).inertia);
    EXPECT_EQ(a.hinges[j].stiffness, b.hinges[j].stiffness);
    EXPECT_EQ(a.hinges[j].damping, b.hinges[j].damping);
    EXPECT_EQ(a.hinges[j].torque_offset, b.hinges[j].torque_offset);
    EXPECT_EQ(a.hinges[j].contact.closing_angle, b.hinges[j].contact.closing_angle);
    EXPECT_EQ(a.hinges[j].contact.stiffness, b.hinges[j].contact.stiffness);
    EXPECT_EQ(a.hinges[j].contact.damping, b.hinges[j].contact.damping);
  }
  ASSERT_EQ(a.magnetics.hinge_pairs().size(), b.magnetics.hinge_pairs().size());
  for (std::size_t i = 0; i < a.magnetics.hinge_pairs().size(); ++i)
    for (const double angle : {0.1, 0.7, 1.3})
      EXPECT_EQ(a.magnetics.hinge_pairs()[i].torque_per_ampere->value(angle),
                b.magnetics.hinge_pairs()[i].torque_per_ampere->value(angle));
  ASSERT_EQ(a.effects.size(), b.effects.size());
  for (std::size_t i = 0; i < a.effects.size(); ++i) {
    EXPECT_EQ(a.effects[i].kind, b.effects[i].kind);
    EXPECT_EQ(a.effects[i].values, b.effects[i].values);
  }
  EXPECT_EQ(a.tip.along, b.tip.along);
}

const Names every_kind = {"joint_stiffness",
                          "/gravity_m_s2",
                          "/links/0/mass_kg",
                          "/links/1/com_offset_m",
                          "/joints/0/damping_Nms_rad",
                          "/joints/1/torque_offset_Nm",
                          "/joints/0/contact/closing_angle_deg",
                          "/joints/0/contact/damping_Nms_rad",
                          "/magnetics/1/torque_Nmm_A/2",
                          "/effects/0/parameters/torque_Nmm"};

TEST(DeclaredLumpedModel, IsTheModelOfTheFileAtTheDeclaredNumbers) {
  const DeclaredActuator actuator = declared(two_joints, every_kind);
  EXPECT_EQ(actuator.name, "two joints");
  EXPECT_THAT(declared_values(actuator),
              ElementsAre(0.125, 9.81, 0.17, 0.03, 1.3e-3, 0.0, DoubleEq(-3.0 * degree), 0.0, 9e-3, 0.61e-3));
  expect_same(actuator.model.build(declared_values(actuator)), file_spec(two_joints));
  EXPECT_FALSE(actuator.model.build(declared_values(actuator)).coil_resistance);
  EXPECT_FALSE(actuator.model.heat);
}

TEST(DeclaredLumpedModel, PutsEveryNumberIntoItsPlace) {
  const DeclaredActuator actuator = declared(two_joints, every_kind);
  const std::vector<double> values = {0.31, 1.62, 0.41, -0.02, 7e-4, 0.013, -0.1, 2e-5, 0.011, 0.9e-3};
  const actuator::ModelSpec spec = actuator.model.build(values);
  EXPECT_EQ(spec.hinges[0].stiffness, 0.31);
  EXPECT_EQ(spec.hinges[1].stiffness, 0.31);
  EXPECT_EQ(spec.chain.gravity(), 1.62);
  EXPECT_EQ(spec.chain.link(0).mass, 0.41);
  EXPECT_EQ(spec.chain.link(1).com_offset, -0.02);
  EXPECT_EQ(spec.hinges[0].damping, 7e-4);
  EXPECT_EQ(spec.hinges[1].damping, 1.7e-3);
  EXPECT_EQ(spec.hinges[1].torque_offset, 0.013);
  EXPECT_EQ(spec.hinges[0].contact.closing_angle, -0.1);
  EXPECT_EQ(spec.hinges[0].contact.damping, 2e-5);
  // A curve passes within 1e-4 of its largest torque.
  EXPECT_NEAR(spec.magnetics.hinge_pairs()[0].torque_per_ampere->value(30.0 * degree), 0.011, 19e-3 * 1e-4);
  EXPECT_EQ(spec.effects[0].values, std::vector{0.9e-3});
  // And the next one starts from the file again.
  expect_same(actuator.model.build(declared_values(actuator)), file_spec(two_joints));
}

TEST(DeclaredLumpedModel, BoundsNumbersByWhatTheyCanBe) {
  const DeclaredActuator actuator = declared(two_joints, every_kind);
  const auto& parameters = actuator.model.calibration;
  EXPECT_EQ(parameters[0].key, "joint_stiffness_Nmm_rad");
  EXPECT_EQ(si_of_one(parameters[0]), 1e-3);
  EXPECT_EQ(parameters[0].lower, 0.0);
  EXPECT_EQ(parameters[0].upper, infinity);
  EXPECT_EQ(parameters[2].key, "/links/0/mass_kg");
  EXPECT_EQ(si_of_one(parameters[2]), 1.0);
  EXPECT_GT(parameters[2].lower, 0.0);
  EXPECT_LT(parameters[2].lower, 1e-6);
  EXPECT_EQ(parameters[3].lower, -infinity);
  EXPECT_EQ(si_of_one(parameters[6]), std::numbers::pi / 180.0);
  EXPECT_EQ(parameters[9].lower, 0.0);
  EXPECT_EQ(si_of_one(parameters[9]), 1e-3);
  EXPECT_EQ(parameters[1].scale, 9.81);
  for (const auto& parameter : parameters) {
    EXPECT_GT(parameter.scale, 0.0) << parameter.key;
    EXPECT_LT(parameter.scale, 100.0) << parameter.key;
  }
  // Every bound makes a model.
  std::vector<double> lowest = declared_values(actuator);
  for (std::size_t i = 0; i < lowest.size(); ++i)
    if (std::isfinite(parameters[i].lower)) lowest[i] = parameters[i].lower;
  EXPECT_NO_THROW((void)actuator::Model(actuator.model.build(lowest)));
}

TEST(DeclaredLumpedModel, KeepsTheRatiosOfUnlikeJoints) {
  const DeclaredActuator actuator = declared(two_joints, {"joint_damping"});
  EXPECT_DOUBLE_EQ(actuator.model.calibration[0].declared, 1.5e-3);
  const actuator::ModelSpec spec = actuator.model.build(std::vector{3e-3});
  EXPECT_DOUBLE_EQ(spec.hinges[0].damping, 2.6e-3);
  EXPECT_DOUBLE_EQ(spec.hinges[1].damping, 3.4e-3);
}

TEST(DeclaredLumpedModel, LeavesTheSchemaOfItsFileBehind) {
  const DeclaredActuator actuator = declared(R"({"$schema": "lumped-model.schema.json", )" + two_joints.substr(1), {});
  EXPECT_EQ(to_json(actuator.updated({}, {}), "x").text(),
            to_json(declared(two_joints, {}).updated({}, {}), "x").text());
}

TEST(DeclaredLumpedModel, SaysWhyNumbersMakeNoModel) {
  const DeclaredActuator actuator = declared(two_joints, {"/magnetics/1/angle_deg/1"});
  EXPECT_THROW((void)actuator.model.build(std::vector{1.0}), std::invalid_argument);  // beyond the next angle
  EXPECT_THROW((void)actuator.model.build(std::vector{0.1, 0.2}), std::invalid_argument);
}

TEST(DeclaredLumpedModel, RefusesNamesThatMeanNoNumber) {
  const std::string at = "dataset.json: /calibrate/0: ";
  EXPECT_EQ(refusal(two_joints, {"/links/2/mass_kg"}),
            at + "must lead to a number of a.json, and leads nowhere; got text \"/links/2/mass_kg\"");
  EXPECT_EQ(refusal(two_joints, {"/links/0/mass"}),
            at + "must lead to a number of a.json, and leads nowhere; got text \"/links/0/mass\"");
  EXPECT_EQ(refusal(two_joints, {"/joints/1/contact/stiffness_Nm_rad"}),
            at + "must lead to a number of a.json, and leads nowhere; got text \"/joints/1/contact/stiffness_Nm_rad\"");
  EXPECT_EQ(refusal(two_joints, {"/links"}),
            at + "must lead to a number, and leads to an array of 2; got text \"/links\"");
  EXPECT_EQ(refusal(two_joints, {"/name"}),
            at + "must lead to a number, and leads to text \"two joints\"; got text \"/name\"");
  EXPECT_EQ(refusal(two_joints, {"/magnetics/0"}),
            at + "must lead to a number, and leads to null; got text \"/magnetics/0\"");
  EXPECT_EQ(refusal(two_joints, {"/effects/0/parameters/torque_Nm"}),
            at + "must lead to a number of a.json, and leads nowhere; got text \"/effects/0/parameters/torque_Nm\"");
  EXPECT_EQ(refusal(two_joints, {"/links~2"}),
            at + "must be \"joint_stiffness\", \"joint_damping\" or a JSON pointer into the actuator file; got text "
                 "\"/links~2\"");
  EXPECT_EQ(refusal(two_joints, {"joint_stiffness", "/joints/1/stiffness_Nm_rad"}),
            "dataset.json: /calibrate/1: must not mean a number that another name means: \"joint_stiffness\"; got text "
            "\"/joints/1/stiffness_Nm_rad\"");
  EXPECT_EQ(refusal("{", {}), "a.json: line 1, column 2: ends before its JSON value is complete");
}

TEST(DeclaredLumpedModel, IsFastToBuild) {
  const DeclaredActuator actuator = declared(two_joints, {"joint_stiffness", "joint_damping", "/links/0/mass_kg"});
  const auto start = std::chrono::steady_clock::now();
  constexpr int rounds = 1000;
  for (int i = 0; i < rounds; ++i) (void)actuator.model.build(std::vector{0.1 + i * 1e-6, 1e-3, 0.2});
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  // It takes a few microseconds; curves built anew would take a thousand times that.
  EXPECT_LT(taken.count() / rounds, 1e-3);
}

const std::string design = R"({
  "format": "actuator/1", "name": "finger", "configuration": "B",
  "body": {"gap_mm": 0.95},
  "model": {"torque": "line_of_centres"},
  "measured": {"joint_stiffness_Nmm_rad": 12.5, "tip_segment_mass_g": 22.5},
  "effects": [{"id": "dry_friction", "parameters": {"torque_Nmm": 0.61}}]
})";

actuator::Design design_of(const DeclaredActuator& actuator, const std::vector<double>& values,
                           const std::vector<actuator::Effect>& effects = {}) {
  return std::get<actuator::Design>(actuator.updated(values, effects));
}

TEST(DeclaredDesign, IsTheModelOfTheFileAtTheDeclaredNumbers) {
  const Names names = {"joint_stiffness",
                       "joint_damping",
                       "/surroundings/base_tilt_deg",
                       "/surroundings/gravity_m_s2",
                       "/body/gap_mm",
                       "/measured/tip_segment_mass_g",
                       "/effects/0/parameters/torque_Nmm"};
  const DeclaredActuator actuator = declared(design, names);
  const auto read = std::get<actuator::Design>(parse_actuator(design, "a.json").content);
  const actuator::Assembly assembly = actuator::assemble_or_throw(read);
  expect_same(actuator.model.build(declared_values(actuator)), assembly.model.nominal_spec());
  EXPECT_EQ(actuator.model.calibration[0].declared, assembly.model.hinges()[0].stiffness);
  EXPECT_DOUBLE_EQ(actuator.model.calibration[0].declared, 12.5e-3);
  EXPECT_EQ(si_of_one(actuator.model.calibration[5]), 1e-3);
  EXPECT_EQ(actuator.model.build(declared_values(actuator)).coil_resistance, assembly.coil.resistance);
  ASSERT_TRUE(actuator.model.heat);
  EXPECT_EQ(actuator.model.heat->nodes().size(), 8u);  // three parts, the silicone round each, and two solid ends
}

TEST(DeclaredDesign, BuildsWhatItsUpdatedFileAssembles) {
  const Names names = {"joint_stiffness",
                       "joint_damping",
                       "/surroundings/base_tilt_deg",
                       "/surroundings/gravity_m_s2",
                       "/body/gap_mm",
                       "/measured/tip_segment_mass_g",
                       "/calibration/tip_com_factor",
                       "/effects/0/parameters/torque_Nmm"};
  const DeclaredActuator actuator = declared(design, names);
  const std::vector<double> values = {14.1e-3, 0.21e-3, 4.0 * degree, 9.7, 1.05e-3, 23.7e-3, 1.08, 0.8e-3};
  const actuator::ModelSpec built = actuator.model.build(values);
  EXPECT_EQ(built.hinges[1].stiffness, 14.1e-3);
  EXPECT_EQ(built.hinges[0].damping, 0.21e-3);
  EXPECT_EQ(built.chain.base_tilt(), 4.0 * degree);
  EXPECT_EQ(built.chain.gravity(), 9.7);
  // Weighed at the file's own gap: a wider one adds its silicone.
  EXPECT_NEAR(built.chain.link(1).mass, 23.7e-3, 0.2e-3);
  EXPECT_EQ(built.effects[0].values, std::vector{0.8e-3});

  const actuator::Design updated = design_of(actuator, values);
  EXPECT_EQ(updated.body.gap, 1.05e-3);
  actuator::ModelSpec assembled = actuator::assemble_or_throw(updated).model.nominal_spec();
  for (std::size_t j = 0; j < assembled.hinges.size(); ++j) {
    // Through a factor that rounds.
    EXPECT_DOUBLE_EQ(assembled.hinges[j].stiffness, built.hinges[j].stiffness);
    EXPECT_DOUBLE_EQ(assembled.hinges[j].damping, built.hinges[j].damping);
    assembled.hinges[j].stiffness = built.hinges[j].stiffness;
    assembled.hinges[j].damping = built.hinges[j].damping;
  }
  expect_same(built, assembled);
}

TEST(DeclaredDesign, TakesEffectsBesideThoseOfItsFile) {
  const DeclaredActuator actuator = declared(design, {"joint_stiffness"});
  const actuator::Effect friction{.kind = actuator::standard_effects().find("dry_friction"), .values = {1.1e-3}};
  const actuator::Effect tilt{.kind = actuator::standard_effects().find("base_tilt"), .values = {0.03}};
  const auto effects = design_of(actuator, {12e-3}, {tilt, friction}).effects;
  ASSERT_EQ(effects.size(), 2u);
  EXPECT_EQ(effects[0].kind, friction.kind);
  EXPECT_EQ(effects[0].values, friction.values);
  EXPECT_EQ(effects[1].kind, tilt.kind);
}

TEST(DeclaredDesign, RefusesNamesThatNoFitCanMove) {
  const std::string at = "dataset.json: /calibrate/0: ";
  EXPECT_EQ(refusal(design, {"/coil/turns_axial"}),
            at + "must lead to a number that a fit can move: this one is a whole number; got text "
                 "\"/coil/turns_axial\"");
  EXPECT_EQ(refusal(design, {"/model/torque"}),
            at + "must lead to a number, and leads to text \"line_of_centres\"; got text \"/model/torque\"");
  EXPECT_EQ(refusal(design, {"/links/0/mass_kg"}),
            at + "must lead to a number of a.json, and leads nowhere; got text \"/links/0/mass_kg\"");
  EXPECT_EQ(refusal(design, {"/measured/joint_stiffness_Nmm_rad", "joint_stiffness"}),
            "dataset.json: /calibrate/1: must not mean a number that another name means: "
            "\"/measured/joint_stiffness_Nmm_rad\"; got text "
            "\"joint_stiffness\"");
  const std::string impossible = R"({"format": "actuator/1", "configuration": "B", "coil": {"inner_radius_mm": 0.06}})";
  EXPECT_THAT(refusal(impossible, {}), ::testing::StartsWith("a.json: /: "));
}

}  // namespace
}  // namespace coilwright::formats
