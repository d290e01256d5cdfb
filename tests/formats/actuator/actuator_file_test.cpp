#include "coilwright/formats/actuator/actuator_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "coilwright/simulation/performance.hpp"
#include "degree.hpp"
#include "text/input_error_text.hpp"

namespace coilwright::formats {
namespace {

using text::testing::error_of;

// `text` with the first `old` in it replaced.
std::string changed(std::string text, const std::string& old, const std::string& replacement) {
  return text.replace(text.find(old), old.size(), replacement);
}

std::string actuator_refusal(const std::string& text) {
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
  "body": {"gap_mm": 0.95, "bottom_layer_mm": 2.4, "loss_time_ms": 9.7, "shore_hardness_A": 31,
           "slot_width_mm": 0.7, "poisson_ratio": 0.48, "loss_factor": 0.11, "constant_damping_Nmms_rad": 0.06},
  "surroundings": {"gravity_m_s2": 9.79, "base_tilt_deg": 12, "ambient_degC": 22, "coil_limit_degC": 130,
                   "heat_transfer_W_m2K": 47},
  "model": {"winding": "layer_centres", "torque": "line_of_centres", "face_contact": "walls",
            "segment_mass": "on_axis_points", "hinge": "slot", "damping": "proportional"},
  "calibration": {"joint_damping_factor": 1.07, "tip_com_factor": 0.93, "constant_damping_factor": 0.4,
                  "hinge_reference": {"width_mm": 21, "bottom_layer_mm": 2.3, "joint_stiffness_Nmm_rad": 11.5,
                                      "joint_damping_Nmms_rad": 0.12, "first_mode_Hz": 6.1}}
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
  EXPECT_EQ(design.choices.winding, magnetics::CurrentDistribution::layer_centres);
  EXPECT_EQ(design.choices.torque, magnetics::Fidelity::line_of_centres);
  EXPECT_EQ(design.choices.faces, actuator::ContactChoice::walls);
  EXPECT_EQ(design.choices.masses, actuator::SegmentMass::on_axis_points);
  EXPECT_DOUBLE_EQ(design.body.slot_width, 0.7e-3);
  EXPECT_EQ(design.body.poisson_ratio, 0.48);
  EXPECT_EQ(design.body.loss_factor, 0.11);
  EXPECT_DOUBLE_EQ(design.body.constant_damping, 0.06e-3);
  EXPECT_EQ(design.choices.hinge, actuator::HingeLaw::slot);
  EXPECT_EQ(design.choices.damping, actuator::DampingLaw::proportional);
  EXPECT_EQ(design.calibration.constant_damping, 0.4);
  ASSERT_TRUE(design.calibration.hinge.has_value());
  EXPECT_DOUBLE_EQ(design.calibration.hinge->width, 21e-3);
  EXPECT_DOUBLE_EQ(design.calibration.hinge->bottom_layer, 2.3e-3);
  EXPECT_DOUBLE_EQ(design.calibration.hinge->stiffness, 11.5e-3);
  EXPECT_DOUBLE_EQ(design.calibration.hinge->damping, 0.12e-3);
  EXPECT_EQ(design.calibration.hinge->first_mode, 6.1);
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

// The actuator.json that version 0.1 wrote for fastest_finger, its numbers of the hinge as they were: k of a beam
// of 2.4 mm, all of b proportional to it, worked out by hand from E = 1.05116 MPa.
TEST(ActuatorFile, OfTheFirstVersionKeepsItsNumbers) {
  const std::string written = R"({"format": "actuator/1", "configuration": "B",
      "magnet": {"radius_mm": 8.5}, "coil": {"turns_radial": 14, "turns_axial": 10, "wire_gauge_AWG": 29},
      "body": {"bottom_layer_mm": 1.6, "hinge_length_mm": 2.4, "loss_time_ms": 10.3},
      "calibration": {"joint_stiffness_factor": 0.9963013666625398, "joint_damping_factor": 0.9982359324230494}})";
  const actuator::Design design = design_of(written);
  EXPECT_EQ(design.choices.hinge, actuator::HingeLaw::beam);
  EXPECT_EQ(design.choices.damping, actuator::DampingLaw::proportional);
  EXPECT_EQ(design.choices.faces, actuator::ContactChoice::hard_parts);
  EXPECT_EQ(design.body.constant_damping, 0.0);
  EXPECT_FALSE(design.calibration.hinge.has_value());
  const actuator::Hinge hinge = actuator::assemble_or_throw(design).model.hinges().front();
  const double beam = 1.05116e6 * 19e-3 * 1.6e-3 * 1.6e-3 * 1.6e-3 / (12.0 * 2.4e-3);  // 19 mm: 2 (8.5 + 1)
  EXPECT_NEAR(hinge.stiffness, 0.9963013666625398 * beam, 1e-5 * beam);
  EXPECT_NEAR(hinge.damping, 0.9982359324230494 * beam * 10.3e-3, 1e-5 * beam * 10.3e-3);
  // What it left out was another default then.
  const actuator::Design bare = design_of(changed(written, R"(, "loss_time_ms": 10.3)", ""));
  EXPECT_DOUBLE_EQ(bare.body.loss_time, 10.3e-3);
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
  EXPECT_EQ(actuator_refusal(
                changed(full_design, R"("coil", "magnet", "coil", "magnet")", R"("coil", "coil", "coil", "coil")")),
            "a.json: /layout: layout must have at least one magnet; got none");
  EXPECT_EQ(actuator_refusal(changed(full_design, "[1, -1, -1, 1]", "[1, -1, -1]")),
            "a.json: /polarity: must have 4 elements; got an array of 3");
  EXPECT_EQ(actuator_refusal(changed(full_design, "[1, -1, -1, 1]", "[1, -1, 2, 1]")),
            "a.json: /polarity/2: must be 1 or -1; got 2");
  EXPECT_EQ(actuator_refusal(changed(full_design, R"("magnet", "coil", "magnet")", R"("magnet", "coil", "glue")")),
            R"(a.json: /layout/3: must be one of "coil", "magnet"; got text "glue")");
  EXPECT_EQ(actuator_refusal(changed(full_design, R"("layout": [)", R"("configuration": "B", "layout": [)")),
            R"(a.json: /layout: cannot stand beside "configuration")");
}

TEST(ActuatorFile, RefusesWordsAndMeasurementsThatDoNotExist) {
  EXPECT_EQ(actuator_refusal(changed(full_design, "layer_centres", "layers")),
            R"(a.json: /model/winding: must be one of "paper_shells", "layer_centres", "uniform"; got text "layers")");
  EXPECT_EQ(actuator_refusal(changed(full_design, R"("calibration": {)", R"("measured": {}, "calibration": {)")),
            R"(a.json: /: gives "measured" and "calibration"; only one of them may be there)");
  EXPECT_EQ(actuator_refusal(R"({"format": "actuator/1", "configuration": "B", "measured": {"tip_com_mm": 1e9}})"),
            "a.json: /measured/tip_com_mm: must be from 0.05 to 1000; got 1000000000");
  EXPECT_EQ(
      actuator_refusal(R"({"format": "actuator/1", "configuration": "B", "measured": {"tip_segment_mass_g": 0.0225}})")
          .substr(0, 30),
      "a.json: /measured: tip segment");  // kilograms
  EXPECT_EQ(actuator_refusal(changed(full_design, R"("hinge": "slot")", R"("hinge": "crack")")),
            R"(a.json: /model/hinge: must be one of "slit", "slot", "beam"; got text "crack")");
  EXPECT_EQ(actuator_refusal(changed(full_design, R"("poisson_ratio": 0.48)", R"("poisson_ratio": 0.51)")),
            "a.json: /body/poisson_ratio: must be from 0 to 0.5; got 0.51");
  EXPECT_EQ(actuator_refusal(changed(full_design, R"("width_mm": 21, )", "")),
            "a.json: /calibration/hinge_reference/width_mm: is missing");
  EXPECT_EQ(actuator_refusal(changed(full_design, R"("tip_com_factor": 0.93)", R"("tip_com_factor": 0)")),
            "a.json: /calibration/tip_com_factor: must be > 0 and <= 1000000; got 0");
}

TEST(ActuatorFile, ReadsTheSheetOfAMagnet) {
  const std::string sheet = R"({"format": "actuator/1", "configuration": "B",
      "magnet": {"coercivity_kA_m": 1100, "coercivity_coefficient_pct_K": -0.62, "remanence_coefficient_pct_K": -0.1,
                 "recoil_permeability": 1.04, "squareness": 0.93, "grade": "N42"}})";
  const actuator::MagnetDesign magnet = design_of(sheet).magnet;
  EXPECT_EQ(magnet.remanence, 1.315) << "the grade's, wherever it stands";
  EXPECT_DOUBLE_EQ(magnet.coercivity, 1100e3);
  EXPECT_DOUBLE_EQ(magnet.coercivity_coefficient, -0.0062);
  EXPECT_DOUBLE_EQ(magnet.remanence_coefficient, -0.001);
  EXPECT_EQ(magnet.recoil_permeability, 1.04);
  EXPECT_EQ(magnet.squareness, 0.93);
  EXPECT_TRUE(design_of(changed(sheet, R"(, "grade": "N42")", "")).magnet.has_coercivity()) << "a sheet needs no grade";
  EXPECT_EQ(actuator_refusal(changed(sheet, "1100", "1.1")),
            "a.json: /magnet/coercivity_kA_m: must be from 10 to 5000; got 1.1");  // in MA/m
  EXPECT_EQ(actuator_refusal(changed(sheet, "-0.62", "-62")),
            "a.json: /magnet/coercivity_coefficient_pct_K: must be from -2 to 2; got -62");
  EXPECT_EQ(actuator_refusal(changed(sheet, "-0.1,", "-10,")),
            "a.json: /magnet/remanence_coefficient_pct_K: must be from -2 to 2; got -10");
  EXPECT_EQ(actuator_refusal(changed(sheet, "1.04", "0.98")),
            "a.json: /magnet/recoil_permeability: must be from 1 to 1.2; got 0.98");
  EXPECT_EQ(actuator_refusal(changed(sheet, "0.93", "1")),
            "a.json: /magnet/squareness: must be from 0.6 to 0.99; got 1");
}

std::string with_effects(const std::string& list) {
  return R"({"format": "actuator/1", "configuration": "B", "effects": )" + list + "}";
}

TEST(ActuatorFile, CarriesEffectsWithTheirNumbersInSi) {
  const actuator::Design design = design_of(with_effects(
      R"([{"id": "end_stop", "parameters": {"side": -1, "angle_deg": -12, "stiffness_Nmm_rad": 430}},
          {"id": "viscoelastic_creep", "parameters": {"stiffness_ratio": 0.21, "time_constant_s": 0.7}}])"));
  ASSERT_EQ(design.effects.size(), 2u);
  EXPECT_EQ(design.effects[0].kind, actuator::standard_effects().find("end_stop"));
  ASSERT_EQ(design.effects[0].values.size(), 3u);
  EXPECT_DOUBLE_EQ(design.effects[0].values[0], -12.0 * degree);
  EXPECT_DOUBLE_EQ(design.effects[0].values[1], 0.43);
  EXPECT_EQ(design.effects[0].values[2], -1.0);
  EXPECT_EQ(design.effects[1].values, (std::vector{0.21, 0.7}));
}

TEST(ActuatorFile, RefusesEffectsThatDoNotExistOrBreakTheirRules) {
  const auto refused = [](const std::string& list) { return actuator_refusal(with_effects(list)); };
  EXPECT_EQ(
      refused(R"([{"id": "dry_fricton", "parameters": {"torque_Nmm": 1}}])"),
      R"(a.json: /effects/0/id: must be the id of an effect; did you mean "dry_friction"?; got text "dry_fricton")");
  EXPECT_EQ(refused(R"([{"id": "dry_friction"}])"), "a.json: /effects/0/parameters: is missing");
  EXPECT_EQ(refused(R"([{"id": "dry_friction", "parameters": {}}])"),
            "a.json: /effects/0/parameters/torque_Nmm: is missing");
  EXPECT_EQ(refused(R"([{"id": "dry_friction", "parameters": {"torque_Nm": 1}}])"),
            R"(a.json: /effects/0/parameters/torque_Nm: unknown key; did you mean "torque_Nmm"?)");
  EXPECT_EQ(refused(R"([{"id": "dry_friction", "parameters": {"torque_Nmm": -0.61}}])"),
            "a.json: /effects/0/parameters/torque_Nmm: must be from 0 to 1000000000000; got -0.61");
  EXPECT_EQ(refused(R"([{"id": "dry_friction", "parameters": {"torque_Nmm": "much"}}])"),
            "a.json: /effects/0/parameters/torque_Nmm: must be a number; got text \"much\"");
  EXPECT_EQ(refused(R"([{"id": "dry_friction", "parameters": {"torque_Nmm": 1}},
                        {"id": "dry_friction", "parameters": {"torque_Nmm": 2}}])"),
            "a.json: /effects/1/id: must not be there twice; got text \"dry_friction\"");
  EXPECT_EQ(refused(R"([{"id": "end_stop", "parameters": {"side": 0.5, "angle_deg": 1, "stiffness_Nmm_rad": 4}}])"),
            "a.json: /effects/0/parameters/side: must be -1 or 1; got 0.5");
  EXPECT_EQ(refused(R"({"dry_friction": 1})"), "a.json: /effects: must be an array; got an object");
}

const std::string two_joints = R"({
  "format": "lumped-model/1", "gravity_m_s2": 9.7,
  "links": [{"length_m": 0.019, "com_along_m": 0.011, "com_offset_m": 0.004, "mass_kg": 0.017, "inertia_kgm2": 0},
            {"length_m": 0.021, "com_along_m": 0.009, "com_offset_m": 0.003, "mass_kg": 0.022, "inertia_kgm2": 1e-6}],
  "joints": [{"stiffness_Nm_rad": 0.0125, "damping_Nms_rad": 1.3e-4,
              "contact": {"closing_angle_deg": -3, "stiffness_Nm_rad": 0.4}},
             {"stiffness_Nm_rad": 0.0131, "damping_Nms_rad": 1.4e-4, "torque_offset_Nm": 2e-4}],
  "magnetics": [null, {"angle_deg": [-10, 0, 30, 60, 110], "torque_Nmm_A": [19.0, 17.5, 9.0, 4.1, 1.3]}]
})";

TEST(LumpedModel, IsReadJointByJoint) {
  const auto model = std::get<actuator::Model>(parse_actuator(two_joints, "a.json").content);
  EXPECT_EQ(model.joints(), 2);
  EXPECT_EQ(model.coils(), 1);
  EXPECT_DOUBLE_EQ(model.hinges()[0].contact.closing_angle, -3.0 * degree);
  EXPECT_EQ(model.hinges()[0].contact.stiffness, 0.4);
  EXPECT_EQ(model.hinges()[1].torque_offset, 2e-4);
}

TEST(LumpedModel, PassesThroughTheTorquesOfItsTable) {
  const auto model = std::get<actuator::Model>(parse_actuator(two_joints, "a.json").content);
  // The table's torque at 30 degrees, times 0.7 A, is all that current adds. 1e-4 of the largest torque is what the
  // curve is built to.
  const mechanics::JointVector angles = (mechanics::JointVector(2) << 0.1, 30.0 * degree).finished();
  const mechanics::JointVector added =
      model.static_residual(angles, model.all_coils(0.7)) - model.static_residual(angles, model.all_coils(0.0));
  EXPECT_EQ(added[0], 0.0);
  EXPECT_NEAR(added[1], 0.7 * 9.0e-3, 0.7 * 19.0e-3 * 1e-4);
}

TEST(LumpedModel, CarriesEffectsThatItCanHave) {
  const auto file =
      parse_actuator(changed(two_joints, R"("links": [)",
                             R"("effects": [{"id": "added_mass", "parameters": {"mass_g": 3.5}}], "links": [)"),
                     "a.json");
  const auto& spec = std::get<actuator::Model>(file.content).nominal_spec();
  ASSERT_EQ(spec.effects.size(), 1u);
  EXPECT_EQ(spec.effects[0].kind, actuator::standard_effects().find("added_mass"));
  EXPECT_EQ(spec.effects[0].values, std::vector{3.5e-3});
  EXPECT_EQ(actuator_refusal(R"({"format": "lumped-model/1",
                        "links": [{"length_m": 0.2, "com_along_m": 0.2, "com_offset_m": 0.01, "mass_kg": 0.5,
                                   "inertia_kgm2": 0.01}],
                        "joints": [{"stiffness_Nm_rad": 0.1, "damping_Nms_rad": 0.001}],
                        "effects": [{"id": "current_offset", "parameters": {"current_mA": 12}}]})"),
            "a.json: /effects/0: cannot be in this model: the model has no coils");
}

std::string with_friction(const std::string& numbers) {
  return changed(two_joints, R"("links": [)",
                 R"("effects": [{"id": "dry_friction", "parameters": {)" + numbers + R"(}}], "links": [)");
}

TEST(LumpedModel, ReadsFrictionWithAndWithoutItsFall) {
  const auto effect = [](const std::string& numbers) {
    return std::get<actuator::Model>(parse_actuator(with_friction(numbers), "a.json").content)
        .nominal_spec()
        .effects.at(0);
  };
  const actuator::EffectKind* plain = actuator::standard_effects().find("dry_friction");
  EXPECT_EQ(effect(R"("torque_Nmm": 0.6)").kind, plain);
  const actuator::Effect falling = effect(R"("torque_Nmm": 0.6, "stribeck_ratio": 1.3, "stribeck_rate_rad_s": 0.5)");
  EXPECT_EQ(falling.kind, plain->with_further_numbers());
  EXPECT_EQ(falling.values, (std::vector<double>{0.6e-3, 1.3, 0.5}));
  EXPECT_EQ(actuator_refusal(with_friction(R"("torque_Nmm": 0.6, "stribeck_ratio": 1.3)")),
            "a.json: /effects/0/parameters/stribeck_rate_rad_s: is missing");
  EXPECT_EQ(actuator_refusal(with_friction(R"("torque_Nmm": 0.6, "stribeck_ratio": 0.9, "stribeck_rate_rad_s": 0.5)")),
            "a.json: /effects/0/parameters/stribeck_ratio: must be from 1 to 3; got 0.9");
}

const std::string pair = R"({
  "format": "lumped-model/1",
  "links": [{"length_m": 0.019, "com_along_m": 0.011, "com_offset_m": 0.004, "mass_kg": 0.017, "inertia_kgm2": 0}],
  "joints": [{"stiffness_Nm_rad": 0.0125, "damping_Nms_rad": 1.3e-4}],
  "magnetics": [{
    "coil": {"inner_radius_mm": 3, "outer_radius_mm": 9.5, "length_mm": 12, "turns_radial": 15, "turns_axial": 30},
    "magnet": {"radius_mm": 10, "length_mm": 6, "remanence_T": 1.44},
    "coil_offset_mm": 6.4, "magnet_offset_mm": 3.4, "axis_offset_mm": 11.5}]
})";

TEST(LumpedModel, TakesThePapersNamesInAnyUnitOfLength) {
  const auto torque = [](const std::string& text) {
    const auto model = std::get<actuator::Model>(parse_actuator(text, "a.json").content);
    return model.magnetics().hinge_pairs()[0].torque_per_ampere->value(0.4);
  };
  const double ours = torque(pair);
  EXPECT_GT(std::abs(ours), 1e-4);
  EXPECT_EQ(torque(changed(changed(changed(pair, R"("coil_offset_mm")", R"("l_a_mm")"), R"("magnet_offset_mm": 3.4)",
                                   R"("l_b_m": 0.0034)"),
                           R"("axis_offset_mm": 11.5)", R"("h_cm": 1.15)")),
            ours);
  EXPECT_EQ(actuator_refusal(changed(pair, R"("coil_offset_mm")", R"("l_a_mm": 6.4, "coil_offset_mm")")),
            R"(a.json: /magnetics/0/l_a_mm: cannot stand beside "coil_offset_mm")");
  EXPECT_EQ(actuator_refusal(changed(pair, R"("coil_offset_mm": 6.4,)", "")),
            "a.json: /magnetics/0/coil_offset_mm: is missing; is \"axis_offset_mm\" meant to be it?");
}

// Nothing stops this joint where it closes: its torque goes on, by the coaxial force itself.
TEST(LumpedModel, FollowsAPairsTorqueWhereNothingStopsTheJoint) {
  const auto model = std::get<actuator::Model>(parse_actuator(pair, "a.json").content);
  const magnetics::ThickCoil coil(
      {.inner_radius = 3e-3, .outer_radius = 9.5e-3, .length = 12e-3, .turns_radial = 15, .turns_axial = 30});
  const magnetics::CylinderMagnet magnet({.radius = 10e-3, .length = 6e-3, .remanence = 1.44});
  const magnetics::HingeGeometry geometry{.coil_offset = 6.4e-3, .magnet_offset = 3.4e-3, .axis_offset = 11.5e-3};
  for (const double angle : {-25.0 * degree, -8.0 * degree, 30.0 * degree}) {
    const double direct =
        magnetics::hinge_torque_per_ampere(coil, magnet, geometry, magnetics::Fidelity::line_of_centres, angle);
    EXPECT_NEAR(model.magnetics().hinge_pairs()[0].torque_per_ampere->value(angle), direct, 3e-8);
  }
}

// The share of the force that finite elements leave the prototype's magnet at 0.9 mm: 2.0481 of 2.1247 N.
TEST(LumpedModel, MayHaveAMagnetWithRecoil) {
  const auto torque = [](const std::string& text) {
    const auto model = std::get<actuator::Model>(parse_actuator(text, "a.json").content);
    return model.magnetics().hinge_pairs()[0].torque_per_ampere->value(0.0);
  };
  const std::string near = changed(pair, R"("coil_offset_mm": 6.4)", R"("coil_offset_mm": 6.5)");
  const auto with = [&](const std::string& recoil) {
    return changed(near, R"("remanence_T": 1.44)", R"("remanence_T": 1.44, "recoil_permeability": )" + recoil);
  };
  EXPECT_NEAR(torque(with("1.05")) / torque(near), 2.0481 / 2.1247, 4e-4);
  EXPECT_EQ(torque(with("1")), torque(near));
  EXPECT_EQ(actuator_refusal(with("1.3")),
            "a.json: /magnetics/0/magnet/recoil_permeability: must be from 1 to 1.2; got 1.3");
}

// A fit makes a magnet as strong as the records ask for, and its result must be a file that can be read.
TEST(LumpedModel, MayHaveAMagnetStrongerThanAnyMaterial) {
  const auto with = [](const std::string& remanence) {
    return changed(pair, R"("remanence_T": 1.44)", R"("remanence_T": )" + remanence);
  };
  EXPECT_NO_THROW((void)parse_actuator(with("2.0067"), "a.json"));
  EXPECT_EQ(actuator_refusal(with("14.4")), "a.json: /magnetics/0/magnet/remanence_T: must be > 0 and <= 5; got 14.4");
}

// Two joints with a pair on each are configuration B: coils on the base and on the last link, magnets between them.
TEST(LumpedModel, KnowsWhereTheCoilsOfTwoPairsAre) {
  const auto rig = [](const std::string& text) {
    return std::get<actuator::Model>(parse_actuator(text, "a.json").content).nominal_spec();
  };
  EXPECT_EQ(rig(pair).coil_row, nullptr);
  EXPECT_EQ(rig(two_joints).coil_row, nullptr);
  std::string two = changed(pair, R"("inertia_kgm2": 0})", R"("inertia_kgm2": 0},
    {"length_m": 0.021, "com_along_m": 0.009, "com_offset_m": 0.003, "mass_kg": 0.022, "inertia_kgm2": 1e-6})");
  two = changed(two, R"(1.3e-4})", R"(1.3e-4}, {"stiffness_Nm_rad": 0.0125, "damping_Nms_rad": 1.3e-4})");
  two = changed(two, R"("axis_offset_mm": 11.5})", R"("axis_offset_mm": 11.5}, {
    "coil": {"inner_radius_mm": 3, "outer_radius_mm": 9.5, "length_mm": 12, "turns_radial": 15, "turns_axial": 30},
    "magnet": {"radius_mm": 10, "length_mm": 6, "remanence_T": 1.44},
    "coil_offset_mm": 6.2, "magnet_offset_mm": 3.4, "axis_offset_mm": 11.0})");
  const actuator::ModelSpec spec = rig(two);
  ASSERT_NE(spec.coil_row, nullptr);
  const std::vector<actuator::PlacedCoil>& coils = spec.coil_row->coils();
  EXPECT_EQ(coils[0].centre.link, -1);
  EXPECT_DOUBLE_EQ(coils[0].centre.along, -6.4e-3);
  EXPECT_DOUBLE_EQ(coils[0].centre.offset, 11.5e-3);
  EXPECT_EQ(coils[1].centre.link, 1);
  EXPECT_DOUBLE_EQ(coils[1].centre.along, 6.2e-3);
  EXPECT_DOUBLE_EQ(coils[1].centre.offset, 11.0e-3);
}

TEST(LumpedModel, TakesATableInOtherUnits) {
  const auto torque = [](const std::string& text) {
    const auto model = std::get<actuator::Model>(parse_actuator(text, "a.json").content);
    return model.magnetics().hinge_pairs()[0].torque_per_ampere->value(0.5);
  };
  // 30 degrees and 0.5235987755982988 rad are the same double; the others are not asked for digit by digit.
  EXPECT_NEAR(torque(changed(changed(two_joints, R"("angle_deg": [-10, 0, 30, 60, 110])",
                                     R"("angle_rad": [-0.17453292519943295, 0, 0.5235987755982988,
                                                      1.0471975511965976, 1.9198621771937625])"),
                             R"("torque_Nmm_A": [19.0, 17.5, 9.0, 4.1, 1.3])",
                             R"("torque_Nm_A": [0.019, 0.0175, 0.009, 0.0041, 0.0013])")),
              torque(two_joints), 1e-9);
  EXPECT_EQ(actuator_refusal(changed(two_joints, R"("angle_deg")", R"("coil": 1, "angle_deg")")),
            R"(a.json: /magnetics/1/angle_deg: cannot stand beside "coil")");
}

TEST(LumpedModel, RefusesGramsForKilograms) {
  EXPECT_EQ(actuator_refusal(changed(two_joints, R"("mass_kg": 0.017)", R"("mass_kg": 17)")),
            "a.json: /links/0/mass_kg: must be a mass in kg that a chain of 0.04 m can have: is it in g?; got 17");
}

// Where a key's rule has no end, its unit has: one table for every reader.
TEST(LumpedModel, RefusesNumbersBeyondAnyHardware) {
  EXPECT_EQ(actuator_refusal(changed(two_joints, R"("mass_kg": 0.017)", R"("mass_kg": 1e298)")),
            "a.json: /links/0/mass_kg: must be > 0 and <= 1000; got 1e+298");
  EXPECT_EQ(actuator_refusal(changed(two_joints, R"("stiffness_Nm_rad": 0.0125)", R"("stiffness_Nm_rad": 1e298)")),
            "a.json: /joints/0/stiffness_Nm_rad: must be from 0 to 1000000; got 1e+298");
  EXPECT_EQ(actuator_refusal(changed(two_joints, R"("damping_Nms_rad": 1.3e-4)", R"("damping_Nms_rad": 1e7)")),
            "a.json: /joints/0/damping_Nms_rad: must be from 0 to 1000; got 10000000");
  EXPECT_EQ(actuator_refusal(changed(two_joints, R"("closing_angle_deg": -3)", R"("closing_angle_deg": -1e298)")),
            "a.json: /joints/0/contact/closing_angle_deg: must be from -3600 to 3600; got -1e+298");
  EXPECT_EQ(actuator_refusal(changed(two_joints, "[19.0, 17.5, 9.0, 4.1, 1.3]", "[19.0, 1e30, 9.0, 4.1, 1.3]")),
            "a.json: /magnetics/1/torque_Nmm_A/1: must be from -10000000 to 10000000; got 1e+30");
  EXPECT_THAT(actuator_refusal(changed(two_joints, "[-10, 0, 30, 60, 110]", "[-10, 0, 1e-310, 60, 110]")),
              ::testing::StartsWith("a.json: /magnetics/1: must give a smooth torque over the angle: "));
}

TEST(LumpedModel, RefusesWhatDoesNotFitTogether) {
  EXPECT_EQ(actuator_refusal(changed(two_joints, "[null, {", "[{")),
            "a.json: /magnetics: must have 2 elements; got an array of 1");
  EXPECT_EQ(actuator_refusal(changed(two_joints, "[-10, 0, 30, 60, 110]", "[-10, 0, 60, 30, 110]")),
            "a.json: /magnetics/1/angle_deg: must increase from one angle to the next");
  EXPECT_EQ(actuator_refusal(changed(two_joints, "[19.0, 17.5, 9.0, 4.1, 1.3]", "[19.0, 17.5, 9.0]")),
            "a.json: /magnetics/1/torque_Nmm_A: must have 5 elements; got an array of 3");
  EXPECT_EQ(actuator_refusal(changed(two_joints, "[-10, 0, 30, 60, 110]", "[-10, 0, 30]")),
            "a.json: /magnetics/1/angle_deg: must have at least 4 elements; got an array of 3");
  EXPECT_EQ(actuator_refusal(changed(two_joints, R"("mass_kg": 0.017)", R"("mass_kg": -0.017)")),
            "a.json: /links/0/mass_kg: must be > 0; got -0.017");
  EXPECT_EQ(actuator_refusal(changed(two_joints, R"("stiffness_Nm_rad": 0.0125)", R"("stiffness_Nmm_rad": 12.5)")),
            R"(a.json: /joints/0/stiffness_Nmm_rad: unknown key; did you mean "stiffness_Nm_rad"?)");
  EXPECT_EQ(actuator_refusal(changed(two_joints, R"("links": [)", R"("segments": 3, "links": [)")),
            "a.json: /segments: unknown key; the keys here are \"as_built\", \"description\", \"effects\", \"format\", "
            "\"gravity_m_s2\", "
            "\"joints\", \"links\", \"magnetics\", \"name\", \"torque_correction\"");
}

}  // namespace
}  // namespace coilwright::formats
