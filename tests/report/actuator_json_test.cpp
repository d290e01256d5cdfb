#include "coilwright/report/actuator_json.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <random>
#include <variant>

#include "coilwright/actuator/parameters.hpp"
#include "coilwright/formats/actuator_file.hpp"

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

}  // namespace
}  // namespace coilwright::report
