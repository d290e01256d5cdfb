// What a data set says of the accuracy of declared numbers, and the models that they then may be.
#include "coilwright/measurement/replay/tolerances.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/formats/actuator/actuator_file.hpp"
#include "coilwright/formats/actuator/actuator_json.hpp"
#include "coilwright/formats/data/declared_actuator.hpp"
#include "degree.hpp"
#include "text/input_error_text.hpp"

namespace coilwright::formats {
namespace {

using actuator::ModelSpec;
using measurement::replay::CalibrationParameter;
using measurement::replay::Tolerances;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

using Names = std::vector<std::string>;
const Names hinge_names = {"joint_stiffness", "joint_damping"};

const std::string loose_joints = R"({
  "format": "lumped-model/1", "name": "two joints",
  "links": [{"length_m": 0.0072, "com_along_m": 0.0036, "com_offset_m": 0.0115, "mass_kg": 0.0165, "inertia_kgm2": 0},
            {"length_m": 0.0212, "com_along_m": 0.0091, "com_offset_m": 0.0115, "mass_kg": 0.0225, "inertia_kgm2": 0}],
  "joints": [{"stiffness_Nm_rad": 0.0125, "damping_Nms_rad": 1.29e-4,
              "contact": {"closing_angle_deg": -2, "stiffness_Nm_rad": 4}},
             {"stiffness_Nm_rad": 0.0125, "damping_Nms_rad": 1.29e-4,
              "contact": {"closing_angle_deg": -3, "stiffness_Nm_rad": 4}}],
  "magnetics": [{"angle_deg": [-10, 0, 30, 60, 110], "torque_Nmm_A": [19.0, 17.5, 9.0, 4.1, 1.3]},
                {"winding": "paper_shells", "coil_offset_mm": 6.3, "magnet_offset_mm": 3.6, "axis_offset_mm": 11.5,
                 "coil": {"inner_radius_mm": 3, "outer_radius_mm": 9.5, "length_mm": 12, "turns_radial": 15,
                          "turns_axial": 30},
                 "magnet": {"radius_mm": 10, "length_mm": 6, "remanence_T": 1.44}}]
})";

std::string paper_finger() {
  std::ifstream file(COILWRIGHT_SOURCE_DIR "/configs/actuators/paper_finger.json");
  return {std::istreambuf_iterator<char>(file), {}};
}

DeclaredActuator declared(const std::string& text, const Names& names, const Tolerances& tolerances) {
  return parse_declared_actuator(text, "a.json", {.names = names, .file = "dataset.json", .tolerances = tolerances});
}

std::string refusal(const std::string& text, const Names& names, const Tolerances& tolerances) {
  return text::testing::error_of([&] { (void)declared(text, names, tolerances); });
}

std::vector<std::string> keys(const DeclaredActuator& actuator) {
  std::vector<std::string> out;
  for (const CalibrationParameter& each : actuator.model.calibration) out.push_back(each.key);
  return out;
}

const CalibrationParameter& parameter(const DeclaredActuator& actuator, const std::string& key) {
  for (const CalibrationParameter& each : actuator.model.calibration)
    if (each.key == key) return each;
  throw std::out_of_range(key);
}

// Every number at its declared value plus so many of its tolerances, another share for each.
std::vector<double> moved(const DeclaredActuator& actuator) {
  std::vector<double> out;
  double share = 0.9;
  for (const CalibrationParameter& each : actuator.model.calibration) {
    out.push_back(each.declared + share * (each.tolerance ? each.tolerance->deviation : 0.1 * each.declared));
    share = -0.93 * share;
  }
  return out;
}

std::vector<double> values_as_declared(const DeclaredActuator& actuator) {
  std::vector<double> out;
  for (const CalibrationParameter& each : actuator.model.calibration) out.push_back(each.declared);
  return out;
}

double torque(const ModelSpec& spec, std::size_t pair, double angle) {
  return spec.magnetics.hinge_pairs()[pair].torque_per_ampere->value(angle);
}

// Relative to the largest torque: what is written goes through decimals, and hinges of designs through factors.
void expect_same(const ModelSpec& a, const ModelSpec& b, double within) {
  ASSERT_EQ(a.chain.joints(), b.chain.joints());
  for (int j = 0; j < a.chain.joints(); ++j) {
    const auto i = static_cast<std::size_t>(j);
    EXPECT_NEAR(a.chain.link(j).mass, b.chain.link(j).mass, within * a.chain.link(j).mass);
    EXPECT_NEAR(a.chain.link(j).length, b.chain.link(j).length, within * a.chain.link(j).length);
    EXPECT_NEAR(a.chain.link(j).com_along, b.chain.link(j).com_along, within * a.chain.link(j).com_along);
    EXPECT_NEAR(a.chain.link(j).com_offset, b.chain.link(j).com_offset, within * a.chain.link(j).com_offset);
    EXPECT_NEAR(a.hinges[i].stiffness, b.hinges[i].stiffness, within * a.hinges[i].stiffness);
    EXPECT_NEAR(a.hinges[i].damping, b.hinges[i].damping, within * a.hinges[i].damping);
    EXPECT_NEAR(a.hinges[i].contact.closing_angle, b.hinges[i].contact.closing_angle, within);
  }
  ASSERT_EQ(a.magnetics.hinge_pairs().size(), b.magnetics.hinge_pairs().size());
  for (std::size_t i = 0; i < a.magnetics.hinge_pairs().size(); ++i)
    for (double angle = -2.0 * degree; angle < 2.0; angle += 0.05)
      EXPECT_NEAR(torque(a, i, angle), torque(b, i, angle), within * torque(a, i, 0.0)) << i << " at " << angle;
}

ModelSpec read_back(const DeclaredActuator& actuator, const std::vector<double>& values) {
  const ActuatorFile back = parse_actuator(to_json(actuator.updated(values, {}), "x").text(), "back.json");
  if (const auto* design = std::get_if<actuator::Design>(&back.content))
    return actuator::assemble_or_throw(*design).model.nominal_spec();
  return std::get<actuator::Model>(back.content).nominal_spec();
}

TEST(Tolerances, ThatAreExactAddNothing) {
  const DeclaredActuator actuator = declared(paper_finger(), hinge_names, Tolerances::exact());
  EXPECT_THAT(keys(actuator), ElementsAre("joint_stiffness_Nmm_rad", "joint_damping_Nmms_rad"));
  EXPECT_THAT(actuator.model.held_exact, ElementsAre("all declared numbers that are not calibrated"));
  for (const CalibrationParameter& each : actuator.model.calibration) {
    EXPECT_TRUE(each.calibrated);
    EXPECT_FALSE(each.tolerance);
  }
}

TEST(Tolerances, HaveDefaultsForWhatAnExperimenterDoubts) {
  const DeclaredActuator actuator = declared(paper_finger(), hinge_names, {});
  EXPECT_THAT(keys(actuator),
              ElementsAre("joint_stiffness_Nmm_rad", "joint_damping_Nmms_rad", "/measured/tip_segment_mass_g",
                          "/measured/magnet_segment_mass_g", "/measured/tip_com_mm", "/measured/axis_offset_mm",
                          "/magnet/remanence_T", "force_curve_1", "force_curve_2", "force_curve_3",
                          "joint_stiffness_ratio", "joint_damping_ratio", "face_closing_deg"));
  for (std::size_t i = 0; i < actuator.model.calibration.size(); ++i) {
    const CalibrationParameter& each = actuator.model.calibration[i];
    EXPECT_EQ(each.calibrated, i < 2) << each.key;
    EXPECT_EQ(each.tolerance.has_value(), i >= 2) << each.key;
    if (!each.tolerance) continue;
    EXPECT_FALSE(each.tolerance->named) << each.key;
    EXPECT_EQ(each.scale, each.tolerance->deviation) << each.key;
    EXPECT_LT(each.lower, each.declared - 3.0 * each.scale) << each.key;
    EXPECT_GT(each.upper, each.declared + 3.0 * each.scale) << each.key;
  }
  EXPECT_DOUBLE_EQ(parameter(actuator, "/measured/tip_segment_mass_g").tolerance->deviation, 0.03 * 22.5e-3);
  EXPECT_DOUBLE_EQ(parameter(actuator, "face_closing_deg").tolerance->deviation, degree);
  EXPECT_EQ(parameter(actuator, "/measured/tip_segment_mass_g").effect, "added_mass");
  EXPECT_EQ(parameter(actuator, "/magnet/remanence_T").effect, "force_gain");
  EXPECT_EQ(parameter(actuator, "joint_stiffness_ratio").effect, "joint_asymmetry");
  EXPECT_THAT(actuator.model.held_exact, ::testing::Contains("the resistance of the coils"));
}

TEST(Tolerances, OfTheForceCurveGiveItsRmsError) {
  const Tolerances said{.others_exact = true, .named = {{"force_curve", 0.04}}};
  const DeclaredActuator actuator = declared(paper_finger(), {}, said);
  ASSERT_THAT(keys(actuator), ElementsAre("force_curve_1", "force_curve_2", "force_curve_3"));
  for (const auto& number : actuator.model.calibration) EXPECT_EQ(number.function, "force_curve");
  // Over 0 to 60 degrees; the coefficients are independent, so the mean square is the sum of three.
  const ModelSpec nominal = actuator.model.build(std::vector{0.0, 0.0, 0.0});
  double mean_square = 0.0;
  for (std::size_t n = 0; n < 3; ++n) {
    std::vector<double> values(3, 0.0);
    values[n] = actuator.model.calibration[n].tolerance->deviation;
    const ModelSpec spec = actuator.model.build(values);
    constexpr int points = 600;
    for (int i = 0; i < points; ++i) {
      const double angle = (i + 0.5) / points * 60.0 * degree;
      const double error = torque(spec, 0, angle) / torque(nominal, 0, angle) - 1.0;
      mean_square += error * error / points;
    }
  }
  EXPECT_NEAR(std::sqrt(mean_square), 0.04, 1e-5);  // curves are interpolated to 1e-6
}

TEST(Tolerances, MoveTheLumpedModelAsOneMadeByHand) {
  const Tolerances said{.others_exact = true,
                        .named = {{"/links/1/mass_kg", 1e-3},
                                  {"joint_stiffness_ratio", 0.05},
                                  {"joint_damping_ratio", 0.1},
                                  {"face_closing_deg", 2.0},
                                  {"force_curve", 0.03}}};
  const DeclaredActuator actuator = declared(loose_joints, {"joint_stiffness"}, said);
  ASSERT_THAT(keys(actuator),
              ElementsAre("joint_stiffness_Nmm_rad", "/links/1/mass_kg", "joint_stiffness_ratio", "joint_damping_ratio",
                          "face_closing_deg", "force_curve_1", "force_curve_2", "force_curve_3"));
  EXPECT_EQ(parameter(actuator, "/links/1/mass_kg").tolerance->deviation, 1e-3);
  EXPECT_EQ(parameter(actuator, "/links/1/mass_kg").effect, "added_mass");
  EXPECT_NEAR(parameter(actuator, "face_closing_deg").declared, -2.5 * degree, 1e-15);  // the mean
  EXPECT_DOUBLE_EQ(parameter(actuator, "face_closing_deg").tolerance->deviation, 2.0 * degree);

  const ModelSpec nominal = actuator.model.build(values_as_declared(actuator));
  const ModelSpec spec = actuator.model.build(std::vector{0.013, 0.024, 0.06, -0.1, -4.0 * degree, 0.02, -0.015, 0.01});
  EXPECT_EQ(spec.chain.link(1).mass, 0.024);
  EXPECT_DOUBLE_EQ(spec.hinges[0].stiffness, 0.013 * 0.97);
  EXPECT_DOUBLE_EQ(spec.hinges[1].stiffness, 0.013 * 1.03);
  EXPECT_DOUBLE_EQ(spec.hinges[0].damping, 1.29e-4 * 1.05);
  EXPECT_DOUBLE_EQ(spec.hinges[1].damping, 1.29e-4 * 0.95);
  EXPECT_NEAR(spec.hinges[0].contact.closing_angle, -3.5 * degree, 1e-15);
  EXPECT_NEAR(spec.hinges[1].contact.closing_angle, -4.5 * degree, 1e-15);
  // Of a table over its own range, -10 to 110 degrees: x is 0 at 50 and 0.5 at 80 degrees.
  const double half = 1.0 + 0.02 * 0.5 - 0.015 * (-0.125) + 0.01 * (-0.4375);
  EXPECT_NEAR(torque(spec, 0, 80.0 * degree), half * torque(nominal, 0, 80.0 * degree), 19e-3 * 4e-4);
  EXPECT_NEAR(torque(spec, 1, 80.0 * degree), half * torque(nominal, 1, 80.0 * degree), 18e-3 * 2e-6);
  EXPECT_NEAR(torque(spec, 1, 50.0 * degree), (1.0 + 0.0075) * torque(nominal, 1, 50.0 * degree), 18e-3 * 2e-6);
}

TEST(Tolerances, ReachTheFileThatIsWritten) {
  for (const std::string& text : {loose_joints, paper_finger()}) {
    const DeclaredActuator actuator = declared(text, hinge_names, {});
    const std::vector<double> values = moved(actuator);
    expect_same(actuator.model.build(values), read_back(actuator, values), 1e-12);
    // And that file, declared in its turn, is where it was.
    const std::string written = to_json(actuator.updated(values, {}), "x").text();
    const DeclaredActuator again = declared(written, hinge_names, {});
    expect_same(actuator.model.build(values), again.model.build(values_as_declared(again)), 1e-12);
  }
}

TEST(Tolerances, OfACalibratedNumberAreItsPrior) {
  const Tolerances said{.others_exact = true, .named = {{"joint_stiffness", 0.4}, {"/links/0/mass_kg", 0.002}}};
  const DeclaredActuator actuator = declared(loose_joints, {"joint_stiffness", "/links/0/mass_kg"}, said);
  ASSERT_EQ(actuator.model.calibration.size(), 2u);
  EXPECT_TRUE(actuator.model.calibration[0].calibrated);
  EXPECT_DOUBLE_EQ(actuator.model.calibration[0].tolerance->deviation, 0.4e-3);
  EXPECT_TRUE(actuator.model.calibration[0].tolerance->named);
  EXPECT_DOUBLE_EQ(actuator.model.calibration[1].tolerance->deviation, 0.002);
}

TEST(Tolerances, OfAMagnetStandForTheGainOfALumpedModel) {
  const DeclaredActuator actuator =
      declared(loose_joints, hinge_names, {.named = {{"/magnetics/1/magnet/remanence_T", 0.02}}});
  EXPECT_EQ(parameter(actuator, "/magnetics/1/magnet/remanence_T").effect, "force_gain");
  EXPECT_THAT(keys(actuator), ::testing::Not(::testing::Contains("force_curve_0")));
  EXPECT_EQ(parameter(declared(loose_joints, hinge_names, {}), "force_curve_0").effect, "force_gain");
}

// Those of the tables, of the reader's refusal, and of every default.
TEST(Tolerances, HaveNoNameThatIsRefused) {
  std::ifstream file(COILWRIGHT_SOURCE_DIR "/docs/formats-dataset.md");
  const std::string all(std::istreambuf_iterator<char>(file), {});
  const std::string section =
      all.substr(all.find("## Tolerances"), all.find("## Columns of a run") - all.find("## Tol"));
  for (const std::string& text : {loose_joints, paper_finger()}) {
    Names names;
    for (const std::string_view each : measurement::replay::tolerance_names()) {
      EXPECT_THAT(section, HasSubstr(fmt::format("`{}`", each)));
      names.emplace_back(each);
    }
    for (const CalibrationParameter& each : declared(text, {}, {}).model.calibration)
      if (each.key.starts_with('/')) names.push_back(each.key);
    EXPECT_GT(names.size(), 10u);
    for (const std::string& name : names) {
      const DeclaredActuator actuator = declared(text, {}, {.others_exact = true, .named = {{name, 1e-6}}});
      ASSERT_FALSE(actuator.model.calibration.empty()) << name;
      for (const CalibrationParameter& each : actuator.model.calibration) EXPECT_TRUE(each.tolerance->named) << name;
    }
  }
}

TEST(Tolerances, LeaveOutDefaultsThatNoMotionCanTellApart) {
  // An axis without gravity: mass and place of its centre are one number.
  const std::string axis = R"({"format": "lumped-model/1", "gravity_m_s2": 0,
    "links": [{"length_m": 1, "com_along_m": 1, "com_offset_m": 0, "mass_kg": 95, "inertia_kgm2": 0}],
    "joints": [{"stiffness_Nm_rad": 0, "damping_Nms_rad": 200}]})";
  const DeclaredActuator actuator = declared(axis, {"joint_damping"}, {});
  EXPECT_THAT(keys(actuator), ElementsAre("joint_damping_Nmms_rad", "/links/0/mass_kg"));
  EXPECT_THAT(actuator.model.held_exact,
              ::testing::Contains("/links/0/com_along_m, which acts as /links/0/mass_kg does"));
  // Under gravity the two are apart; named, they stay.
  std::string pendulum = axis;
  pendulum.replace(pendulum.find("\"gravity_m_s2\": 0"), 17, "\"gravity_m_s2\": 9");
  EXPECT_THAT(keys(declared(pendulum, {"joint_damping"}, {})),
              ElementsAre("joint_damping_Nmms_rad", "/links/0/mass_kg", "/links/0/com_along_m"));
  EXPECT_THAT(keys(declared(axis, {"joint_damping"}, {.named = {{"/links/0/com_along_m", 0.1}}})),
              ElementsAre("joint_damping_Nmms_rad", "/links/0/com_along_m"));
}

TEST(Tolerances, OfZeroHoldANumberExact) {
  const DeclaredActuator actuator =
      declared(paper_finger(), hinge_names, {.named = {{"force_curve", 0.0}, {"/magnet/remanence_T", 0.0}}});
  EXPECT_THAT(keys(actuator), ::testing::Not(::testing::Contains(HasSubstr("force_curve"))));
  EXPECT_THAT(keys(actuator), ::testing::Not(::testing::Contains("/magnet/remanence_T")));
  EXPECT_THAT(actuator.model.held_exact, ::testing::Contains("force_curve"));
}

// A mass of 22.5 g known to 500 g is not declared: a fit would take it wherever it helps, and name effects by it.
TEST(Tolerances, AreRefusedWhereTheyExceedANumberThatCannotBeNegative) {
  EXPECT_EQ(refusal(loose_joints, {"joint_damping"}, {.named = {{"/links/1/mass_kg", 0.5}}}),
            "dataset.json: /tolerances/~1links~11~1mass_kg: must be at most the declared number, 0.0225; for a number "
            "of which nothing is known, \"calibrate\" it; got 0.5");
  EXPECT_EQ(
      refusal(paper_finger(), {"joint_damping"}, {.named = {{"joint_damping", 0.2}}}),
      "dataset.json: /tolerances/joint_damping: must be at most the declared number, 0.129; for a number of which "
      "nothing is known, \"calibrate\" it; got 0.2");
}

TEST(Tolerances, AreRefusedWhereTheActuatorHasNoSuchNumber) {
  const auto wrong = [](const std::string& text, const std::string& name, double deviation = 0.1) {
    return refusal(text, {"joint_damping"}, {.named = {{name, deviation}}});
  };
  EXPECT_EQ(wrong(loose_joints, "/links/2/mass_kg"),
            "dataset.json: /tolerances/~1links~12~1mass_kg: must lead to a number of a.json, and leads nowhere");
  EXPECT_EQ(wrong(loose_joints, "/name"),
            "dataset.json: /tolerances/~1name: must lead to a number, and leads to text \"two joints\"");
  EXPECT_EQ(wrong(paper_finger(), "/coil/turns_axial"),
            "dataset.json: /tolerances/~1coil~1turns_axial: must lead to a number that a fit can move: this one is a "
            "whole number");
  EXPECT_EQ(wrong(loose_joints, "joint_damping", 0.0),
            "dataset.json: /tolerances/joint_damping: must be > 0, because the number is calibrated; got 0");
  EXPECT_EQ(wrong(loose_joints, "/joints/1/damping_Nms_rad"),
            "dataset.json: /tolerances/~1joints~11~1damping_Nms_rad: must not mean a number that another name means: "
            "\"joint_damping\"");
  const std::string rod = R"({"format": "lumped-model/1",
    "links": [{"length_m": 1, "com_along_m": 1, "com_offset_m": 0, "mass_kg": 95, "inertia_kgm2": 0}],
    "joints": [{"stiffness_Nm_rad": 1, "damping_Nms_rad": 200}]})";
  EXPECT_EQ(wrong(rod, "force_curve"),
            "dataset.json: /tolerances/force_curve: must not be there: the actuator has no coil beside a magnet");
  EXPECT_EQ(wrong(rod, "joint_stiffness_ratio"),
            "dataset.json: /tolerances/joint_stiffness_ratio: must not be there: the actuator has no two joints to "
            "differ in it");
  EXPECT_EQ(wrong(rod, "face_closing_deg"),
            "dataset.json: /tolerances/face_closing_deg: must not be there: the actuator has no faces that touch");
}

}  // namespace
}  // namespace coilwright::formats
