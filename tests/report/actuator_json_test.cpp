#include "coilwright/report/actuator_json.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <random>
#include <variant>

#include "coilwright/actuator/parameters.hpp"
#include "coilwright/formats/actuator_file.hpp"
#include "coilwright/formats/declared_actuator.hpp"

namespace coilwright::report {
namespace {

using actuator::Design;

Design read_back(const Design& design) {
  return std::get<Design>(formats::parse_actuator(to_json(design, "x").text(), "x").content);
}

void expect_same_bits(const Design& a, const Design& b) {
  for (const actuator::Parameter& parameter : actuator::parameters())
    EXPECT_EQ(std::bit_cast<std::uint64_t>(parameter.get(a)), std::bit_cast<std::uint64_t>(parameter.get(b)))
        << parameter.name << ": " << parameter.get(a) << " became " << parameter.get(b);
  ASSERT_EQ(a.layout.size(), b.layout.size());
  for (std::size_t i = 0; i < a.layout.size(); ++i) {
    EXPECT_EQ(a.layout[i].kind, b.layout[i].kind);
    EXPECT_EQ(a.layout[i].polarity, b.layout[i].polarity);
  }
  EXPECT_EQ(a.choices.winding, b.choices.winding);
  EXPECT_EQ(a.choices.torque, b.choices.torque);
  EXPECT_EQ(a.choices.faces, b.choices.faces);
  EXPECT_EQ(a.choices.masses, b.choices.masses);
}

TEST(ActuatorJson, ReadsBackAsTheSameBitsForEveryChoice) {
  Design design;
  design.layout = actuator::layout_of(actuator::Configuration::C);
  design.layout[3].polarity = -1;
  for (const auto winding :
       {magnetics::Winding::paper_shells, magnetics::Winding::layer_centres, magnetics::Winding::uniform})
    for (const auto torque : {magnetics::Fidelity::line_of_centres, magnetics::Fidelity::exact})
      for (const auto faces : {actuator::FaceContact::hard_parts, actuator::FaceContact::walls})
        for (const auto masses : {actuator::SegmentMass::on_axis_points, actuator::SegmentMass::rigid_bodies}) {
          design.choices = {.winding = winding, .torque = torque, .faces = faces, .masses = masses};
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
      const double value = parameter.get(design) * parameter.denominator * factor(random);
      parameter.set(design, value / parameter.denominator);
    }
    design.coil.wire_gauge = 20 + i % 21;
    design.coil.inner_radius = 4.0 * factor(random) / 1e3;  // no bore too tight for the wire
    design.body.shore_hardness = 40.0 * factor(random);     // within Gent's relation
    const actuator::Parameter& tilt = *actuator::find_parameter("base_tilt_deg");
    tilt.set(design, 17.0 * factor(random) / tilt.denominator);
    expect_same_bits(read_back(design), design);
  }
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
    for (const actuator::EffectKind* kind : actuator::standard_effects().kinds()) {
      actuator::Effect effect{.kind = kind, .values = {}};
      for (const actuator::EffectParameter& parameter : kind->parameters()) {
        const double lower = std::max(parameter.lower, -3.0), upper = std::min(parameter.upper, 3.0);
        // Numbers that some decimal in the key's unit means; between those there are doubles that none does.
        const double value = (lower + share(random) * (upper - lower)) * parameter.denominator;
        effect.values.push_back(parameter.choices.empty() ? value / parameter.denominator
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

TEST(ActuatorJson, ReadsAnUpdatedLumpedModelBackAsTheModelThatWasBuilt) {
  const std::string file = R"({
    "format": "lumped-model/1", "name": "arm", "gravity_m_s2": 9.7, "description": "kept",
    "links": [{"length_m": 0.19, "com_along_m": 0.11, "com_offset_m": 0.004, "mass_kg": 0.17, "inertia_kgm2": 0}],
    "joints": [{"stiffness_Nm_rad": 0.125, "damping_Nms_rad": 1.3e-3, "torque_offset_Nm": -2.5e-4}],
    "magnetics": [{"angle_deg": [-10, 0, 30, 60, 110], "torque_Nmm_A": [19.0, 17.5, 9.0, 4.1, 1.3]}],
    "effects": [{"id": "dry_friction", "parameters": {"torque_Nmm": 0.61}}]})";
  const std::vector<std::string> names = {"joint_stiffness", "/links/0/mass_kg", "/magnetics/0/torque_Nmm_A/1",
                                          "/effects/0/parameters/torque_Nmm"};
  const auto declared = formats::parse_declared_actuator(file, "a.json", {.names = names, .file = "dataset.json"});
  const std::vector<double> values = {0.1234567890123456, 0.1 + 0.2, 16.9 / 1e3, 0.77 / 1e3};
  const actuator::Effect tilt{.kind = actuator::standard_effects().find("quadratic_drag"), .values = {1.7 / 1e3}};

  const std::string text = to_json(declared.updated(values, {tilt}), "unused").text();
  EXPECT_NE(text.find("\"name\": \"arm\""), std::string::npos) << text;
  EXPECT_NE(text.find("\"description\": \"kept\""), std::string::npos) << text;
  EXPECT_NE(text.find("\"gravity_m_s2\": 9.7,"), std::string::npos) << text;
  EXPECT_NE(text.find("\"angle_deg\": [-10, 0, 30, 60, 110]"), std::string::npos) << text;

  const auto back = std::get<actuator::Model>(formats::parse_actuator(text, "x").content).spec();
  const auto built = declared.model.build(values);
  EXPECT_EQ(back.hinges[0].stiffness, values[0]);
  EXPECT_EQ(back.chain.link(0).mass, values[1]);
  EXPECT_EQ(back.hinges[0].torque_offset, -2.5e-4);
  EXPECT_EQ(back.chain.link(0).com_offset, built.chain.link(0).com_offset);
  for (const double angle : {0.0, 0.4, 1.2})
    EXPECT_EQ(back.magnetics.hinge_pairs()[0].torque_per_ampere->value(angle),
              built.magnetics.hinge_pairs()[0].torque_per_ampere->value(angle));
  ASSERT_EQ(back.effects.size(), 2u);
  EXPECT_EQ(back.effects[0].values, built.effects[0].values);
  EXPECT_EQ(back.effects[1].kind, tilt.kind);
  EXPECT_EQ(back.effects[1].values, tilt.values);
}

TEST(ActuatorJson, ReadsAnUpdatedDesignBackAsTheDesign) {
  const std::vector<std::string> names = {"joint_stiffness", "joint_damping"};
  const auto declared = formats::parse_declared_actuator(
      R"({"format": "actuator/1", "configuration": "B", "model": {"torque": "line_of_centres"},
          "measured": {"joint_stiffness_Nmm_rad": 12.5}})",
      "a.json", {.names = names, .file = "dataset.json"});
  const std::vector<double> values = {13.7e-3, 0.19e-3};
  const auto updated = declared.updated(values, {});
  const Design back = std::get<Design>(formats::parse_actuator(to_json(updated, "corrected").text(), "x").content);
  expect_same_bits(back, std::get<Design>(updated));
}

TEST(ActuatorJson, NamesNoEffectsWhereThereAreNone) {
  EXPECT_EQ(to_json(Design(), "plain").text().find("effects"), std::string::npos);
}

}  // namespace
}  // namespace coilwright::report
