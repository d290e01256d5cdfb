#include "coilwright/formats/actuator/actuator_json.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <variant>

#include "coilwright/actuator/calibrate.hpp"
#include "coilwright/actuator/design/parameters.hpp"
#include "coilwright/formats/actuator/actuator_file.hpp"
#include "coilwright/units/unit.hpp"
#include "formats/actuator/same_bits.hpp"
#include "text/input_error_text.hpp"

namespace coilwright::formats {
namespace {

using actuator::Design;
using coilwright::testing::expect_same_bits;

Design read_back(const Design& design) {
  return std::get<Design>(parse_actuator(to_json(design, "x").text(), "x").content);
}

TEST(ActuatorJson, ReadsBackAsTheSameBitsForEveryChoice) {
  Design design;
  design.layout = actuator::layout_of(actuator::Configuration::C);
  design.layout[3].polarity = -1;
  for (const auto winding : {magnetics::CurrentDistribution::paper_shells,
                             magnetics::CurrentDistribution::layer_centres, magnetics::CurrentDistribution::uniform})
    for (const auto torque : {magnetics::Fidelity::line_of_centres, magnetics::Fidelity::exact})
      for (const auto faces : {actuator::ContactChoice::hard_parts, actuator::ContactChoice::walls})
        for (const auto masses : {actuator::SegmentMass::on_axis_points, actuator::SegmentMass::rigid_bodies}) {
          design.choices = {.winding = winding, .torque = torque, .faces = faces, .masses = masses};
          expect_same_bits(read_back(design), design);
        }
}

TEST(ActuatorJson, ReadsBackAsTheSameBitsForEveryLawAndItsReference) {
  for (const auto hinge : {actuator::HingeLaw::slit, actuator::HingeLaw::slot, actuator::HingeLaw::beam})
    for (const auto damping : {actuator::DampingLaw::loss_factor, actuator::DampingLaw::proportional}) {
      Design design;
      design.choices.hinge = hinge;
      design.choices.damping = damping;
      design.calibration = actuator::calibrate(design, {.joint_stiffness = 12.7e-3, .joint_damping = 0.131e-3});
      ASSERT_TRUE(design.calibration.hinge.has_value());
      expect_same_bits(read_back(design), design);
    }
}

TEST(ActuatorJson, ReadsBackAsTheSameBitsWhateverTheNumbers) {
  // Numbers as a search finds them: what a study says in millimetres, divided by a thousand.
  std::mt19937_64 random(20240907);
  std::uniform_real_distribution<double> factor(0.7, 1.4);
  for (int i = 0; i < 300; ++i) {
    Design design;
    for (const actuator::Parameter& parameter : actuator::parameters()) {
      const double value = units::from_memory(parameter.get(design), parameter.key) * factor(random);
      parameter.set(design, units::to_memory(value, parameter.key));
    }
    // By a gauge, a diameter, or a diameter with an enamel of its own; by every name of a stiffness.
    const auto set = [&design](std::string_view name, double si) { actuator::find_parameter(name)->set(design, si); };
    if (i % 3 == 0) set("wire_gauge_AWG", 20 + i % 21);
    if (i % 3 == 1) set("wire_diameter_mm", 0.3 * factor(random) / 1e3);
    if (i % 3 == 2) set("wire_overall_mm", 1.2 * (design.coil.wire_diameter * 1e3) / 1e3);
    set("enamel", i % 2);
    design.coil.inner_radius = 4.0 * factor(random) / 1e3;           // no bore too tight for the wire
    if (i % 4 != 1) set("shore_hardness_A", 40.0 * factor(random));  // within Gent's relation
    if (i % 4 == 1) set("shore_hardness_00", 30.0 * factor(random));
    set("bottom_shore_hardness_A", 40.0 * factor(random));
    if (i % 4 == 3) design.bottom_silicone.reset();
    design.magnet.remanence = 1.4 * factor(random);                                        // up to 2 T
    design.body.poisson_ratio = 0.35 * factor(random);                                     // up to 0.5
    design.coil.current_shares = {0.7 * factor(random), -0.7 * factor(random), 1.0, 1.0};  // of two coils, up to 1
    set("coercivity_kA_m", units::to_memory(900.0 * factor(random), "coercivity_kA_m"));
    for (const auto& [name, percent] :
         {std::pair("remanence_coefficient_pct_K", -0.11), {"coercivity_coefficient_pct_K", -0.6}})
      set(name, units::to_memory(percent * factor(random), name));
    design.magnet.recoil_permeability = 1.0 + 0.14 * factor(random);  // 1 to 1.2
    design.magnet.squareness = 0.5 + 0.35 * factor(random);           // 0.6 to 0.99
    const actuator::Parameter& tilt = *actuator::find_parameter("base_tilt_deg");
    tilt.set(design, units::to_memory(17.0 * factor(random), tilt.key));
    expect_same_bits(read_back(design), design);
  }
}

TEST(ActuatorJson, HasTheSharesOfTheCoilsThatThereAre) {
  Design design;
  EXPECT_EQ(to_json(design, "plain").text().find("current_share"), std::string::npos);
  design.coil.current_shares = {1.0, 0.25, 0.5, -0.5};  // as a search over configurations leaves them
  const std::string text = to_json(design, "split").text();
  EXPECT_NE(text.find("\"current_share_2\": 0.25"), std::string::npos);
  EXPECT_EQ(text.find("current_share_1"), std::string::npos);
  EXPECT_EQ(text.find("current_share_3"), std::string::npos);
}

TEST(ActuatorJson, CallsTheGradeOfAMagnetByItsName) {
  Design design;
  EXPECT_NE(to_json(design, "plain").text().find("\"grade\": \"none\""), std::string::npos);
  design.magnet.make_of(magnetics::find_magnet_grade("N45SH"));
  design.magnet.remanence = 1.33;  // measured
  EXPECT_NE(to_json(design, "plain").text().find("\"grade\": \"N45SH\""), std::string::npos);
  expect_same_bits(read_back(design), design);
}

// A file has of a grade its name, and beside it what a person knows better.
TEST(ActuatorJson, StatesOfAGradeWhatIsAnother) {
  Design design;
  design.magnet.make_of(magnetics::find_magnet_grade("N42"));
  const std::string plain = to_json(design, "plain").text();
  for (const char* key : {"coercivity", "coefficient", "recoil", "squareness"})
    EXPECT_EQ(plain.find(key), std::string::npos) << key;
  design.magnet.coercivity = 1020e3;
  design.magnet.squareness = 0.9;
  const std::string stated = to_json(design, "stated").text();
  EXPECT_NE(stated.find("\"coercivity_kA_m\": 1020"), std::string::npos);
  EXPECT_NE(stated.find("\"squareness\": 0.9"), std::string::npos);
  EXPECT_EQ(stated.find("coefficient"), std::string::npos);
  expect_same_bits(read_back(design), design);
}

std::string refusal_of(const std::string& keys) {
  return text::testing::error_of(
      [&] { (void)parse_actuator(R"({"format": "actuator/1", "configuration": "B", )" + keys + "}", "finger.json"); });
}

TEST(ActuatorJson, NamesAWireByItsDiameter) {
  const auto coil = [](const std::string& keys) {
    return std::get<Design>(
               parse_actuator(R"({"format": "actuator/1", "configuration": "B", "coil": {)" + keys + "}}", "x").content)
        .coil;
  };
  EXPECT_EQ(wire_of(coil(R"("wire_diameter_mm": 0.25)")).insulated_diameter, 0.281e-3);  // IEC 60317-0-1
  EXPECT_NEAR(wire_of(coil(R"("wire_diameter_mm": 0.25, "enamel": "grade_2")")).insulated_diameter, 0.297e-3, 1e-12);
  EXPECT_EQ(wire_of(coil(R"("wire_overall_mm": 0.3, "wire_diameter_mm": 0.25)")).insulated_diameter, 0.3 / 1e3);
  EXPECT_EQ(wire_of(coil(R"("wire_gauge_AWG": 16)")).name(), "AWG 16");
  Design design;
  design.coil.wire_diameter = 0.25e-3;
  const std::string text = to_json(design, "metric").text();
  EXPECT_NE(text.find("\"wire_diameter_mm\": 0.25"), std::string::npos);
  EXPECT_EQ(text.find("AWG"), std::string::npos);
  EXPECT_EQ(to_json(Design{}, "plain").text().find("wire_diameter_mm"), std::string::npos);
}

TEST(ActuatorJson, TakesOneNameOfAWireAndOneOfAStiffness) {
  EXPECT_EQ(refusal_of(R"("coil": {"wire_gauge_AWG": 30, "wire_diameter_mm": 0.25})"),
            "finger.json: /coil/wire_diameter_mm: must not be there beside \"wire_gauge_AWG\": both give the wire");
  EXPECT_EQ(
      refusal_of(R"("body": {"youngs_modulus_MPa": 0.1, "shore_hardness_00": 30})"),
      "finger.json: /body/youngs_modulus_MPa: must not be there beside \"shore_hardness_00\": both give the stiffness "
      "of the silicone");
  EXPECT_EQ(refusal_of(R"("coil": {"wire_diameter_mm": 0.25, "wire_overall_mm": 0.2})"),
            "finger.json: /: wire over its enamel must be thicker than its copper, 0.254 mm at most; got 0.2 mm");
  EXPECT_EQ(refusal_of(R"("coil": {"wire_diameter_mm": 25})"),
            "finger.json: /coil/wire_diameter_mm: must be from 0.018 to 5; got 25");
}

TEST(ActuatorJson, KnowsSiliconesByTheirNameAndASecondOneInTheBottomLayer) {
  const auto read = [](const std::string& keys) {
    return std::get<Design>(
        parse_actuator(R"({"format": "actuator/1", "configuration": "B", )" + keys + "}", "x").content);
  };
  const Design soft = read(R"("body": {"silicone": "Ecoflex 00-30"})");
  EXPECT_NEAR(soft.body.modulus(), 10.0 * 6894.757 * 12.0 / 7.0, 1e-6);  // 10 psi at 100 %
  EXPECT_EQ(soft.body.density, 1070.0);
  EXPECT_EQ(soft.body.name(), "Ecoflex 00-30");
  EXPECT_FALSE(soft.bottom_silicone.has_value());
  EXPECT_EQ(read(R"("body": {"silicone": "Ecoflex 00-30", "youngs_modulus_MPa": 0.07})").body.modulus(), 0.07e6);
  const Design both = read(
      R"("body": {"silicone": "Ecoflex 00-30", "conductivity_W_mK": 0.25}, "bottom_layer_silicone": {"silicone": "Dragon Skin 30"})");
  ASSERT_TRUE(both.bottom_silicone.has_value());
  EXPECT_EQ(both.bottom_silicone->density, 1080.0);
  EXPECT_EQ(both.bottom_silicone->conductivity, 0.25);  // as the body, where nothing else is said
  expect_same_bits(read_back(both), both);
  EXPECT_NE(
      refusal_of(R"("body": {"silicone": "Ecoflex 30"})").find("/body/silicone: must be one of \"none\", \"Ecoflex"),
      std::string::npos);
}

TEST(ActuatorJson, ReadsTheNumbersOfAGradeUnlessTheFileHasItsOwn) {
  const auto magnet = [](const std::string& keys) {
    const ActuatorFile file =
        parse_actuator(R"({"format": "actuator/1", "configuration": "B", "magnet": {)" + keys + "}}", "finger.json");
    return std::get<Design>(file.content).magnet;
  };
  EXPECT_EQ(magnet(R"("radius_mm": 9)").grade, nullptr);
  EXPECT_EQ(magnet(R"("grade": "N42SH")").remanence, 1.315);
  EXPECT_EQ(magnet(R"("grade": "N42SH")").temperature_limit, 150.0);
  EXPECT_EQ(magnet(R"("remanence_T": 1.29, "grade": "N42SH")").remanence, 1.29);
}

TEST(ActuatorJson, SaysMillimetresAsAPersonWouldWriteThem) {
  Design design;
  design.body.gap = 0.9e-3;
  design.coil.inner_radius = 3.3e-3;
  const std::string text = to_json(design, "plain").text();
  EXPECT_NE(text.find("\"gap_mm\": 0.9,"), std::string::npos) << text;
  EXPECT_NE(text.find("\"inner_radius_mm\": 3.3,"), std::string::npos);
  EXPECT_NE(text.find("\"turns_axial\": 30,"), std::string::npos);
}

TEST(ActuatorJson, ReadsBackAsTheSameEffectsWhateverTheirNumbers) {
  std::mt19937_64 random(20241105);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (int round = 0; round < 200; ++round) {
    Design design;
    for (const actuator::EffectKind* known : actuator::standard_effects().kinds()) {
      const actuator::EffectKind* further = known->with_further_numbers();
      const actuator::EffectKind* kind = further != nullptr && round % 2 == 0 ? further : known;
      actuator::Effect effect{.kind = kind, .values = {}};
      for (const actuator::EffectParameter& parameter : kind->parameters()) {
        const double lower = std::max(parameter.lower, -3.0);
        const double upper = std::min(parameter.upper, std::max(3.0, 2.0 * lower));
        // Numbers that some decimal in the key's unit means; between those there are doubles that none does.
        const double value = units::from_memory(lower + share(random) * (upper - lower), parameter.key);
        effect.values.push_back(parameter.choices.empty() ? units::to_memory(value, parameter.key)
                                                          : parameter.choices[round % parameter.choices.size()]);
      }
      // The bounds themselves, too.
      if (round == 0 && !effect.values.empty() && std::isfinite(kind->parameters()[0].upper))
        effect.values[0] = kind->parameters()[0].upper;
      if (round == 1 && !effect.values.empty() && std::isfinite(kind->parameters()[0].lower))
        effect.values[0] = kind->parameters()[0].lower;
      design.effects.push_back(std::move(effect));
    }
    const Design back = read_back(design);
    ASSERT_EQ(back.effects.size(), design.effects.size());
    for (std::size_t i = 0; i < back.effects.size(); ++i) {
      EXPECT_EQ(back.effects[i].kind, design.effects[i].kind);
      EXPECT_EQ(back.effects[i].values, design.effects[i].values) << back.effects[i].kind->id();
    }
  }
}

TEST(ActuatorJson, CarriesTheOperatingPointForWhichItWasSized) {
  const actuator::OperatingPoint point{.current = 1.35, .duty = 0.45, .grasp = {.opening = 0.37, .height = 18.3e-3}};
  const ActuatorFile file = parse_actuator(to_json(Design{}, "x", point).text(), "x");
  ASSERT_TRUE(file.operating_point);
  EXPECT_EQ(file.operating_point->current, 1.35);
  EXPECT_EQ(file.operating_point->duty, 0.45);
  EXPECT_DOUBLE_EQ(file.operating_point->grasp.opening, 0.37);
  EXPECT_DOUBLE_EQ(file.operating_point->grasp.height.value(), 18.3e-3);
  EXPECT_FALSE(parse_actuator(to_json(Design{}, "x").text(), "x").operating_point);
}

TEST(ActuatorJson, CarriesSupplyAndCasesOfAnOperatingPoint) {
  const actuator::OperatingPoint point{
      .current = 1.35,
      .duty = 0.45,
      .period = 3.5,
      .cases = actuator::HeldCases::gripping,
      .supply = {.wiring = actuator::Wiring::series, .resistance = 0.2, .voltage = 7.4}};
  const ActuatorFile back = parse_actuator(to_json(Design{}, "x", point).text(), "x");
  ASSERT_TRUE(back.operating_point);
  EXPECT_EQ(back.operating_point->period, 3.5);
  EXPECT_EQ(back.operating_point->cases, actuator::HeldCases::gripping);
  EXPECT_EQ(back.operating_point->supply.wiring, actuator::Wiring::series);
  EXPECT_EQ(back.operating_point->supply.resistance, 0.2);
  EXPECT_EQ(back.operating_point->supply.voltage, 7.4);
}

TEST(ActuatorJson, RefusesAnOperatingPointByItsPlace) {
  const auto error = [](const std::string& point) {
    return text::testing::error_of([&] {
      (void)parse_actuator(R"({"format": "actuator/1", "configuration": "B", "operating_point": )" + point + "}", "x");
    });
  };
  EXPECT_EQ(error(R"({"duty": 0.5})"), "x: /operating_point/current_A: is missing");
  EXPECT_EQ(error(R"({"current_A": 1, "wiring": "star"})"),
            R"(x: /operating_point/wiring: must be one of "parallel", "series"; got text "star")");
  EXPECT_EQ(error(R"({"current_A": 1, "supply_resistance_Ohm": -1})"),
            "x: /operating_point/supply_resistance_Ohm: must be >= 0; got -1");
  EXPECT_EQ(error(R"({"current_A": 1, "duty": 1.5})"), "x: /operating_point/duty: must be from 0 to 1; got 1.5");
  EXPECT_EQ(error(R"({"current_A": 1, "grasp_opening_deg": -5})"),
            "x: /operating_point/grasp_opening_deg: must be from 0 to 360; got -5");
  EXPECT_EQ(error(R"({"current_A": 1, "current_limit": 2})").substr(0, 46),
            "x: /operating_point/current_limit: unknown key");
}

TEST(ActuatorJson, NamesNoEffectsWhereThereAreNone) {
  EXPECT_EQ(to_json(Design(), "plain").text().find("effects"), std::string::npos);
}

}  // namespace
}  // namespace coilwright::formats
