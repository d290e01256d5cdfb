// A declared actuator after a fit: written and read back, it is what was fitted.
#include <gtest/gtest.h>

#include <string>
#include <variant>
#include <vector>

#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "coilwright/formats/actuator/actuator_file.hpp"
#include "coilwright/formats/actuator/actuator_json.hpp"
#include "coilwright/formats/data/declared_actuator.hpp"
#include "formats/actuator/same_bits.hpp"

namespace coilwright::formats {
namespace {

using actuator::Design;
using coilwright::testing::expect_same_bits;

TEST(UpdatedActuator, IsReadBackAsTheLumpedModelThatWasBuilt) {
  const std::string file = R"({
    "format": "lumped-model/1", "name": "arm", "gravity_m_s2": 9.7, "description": "kept",
    "links": [{"length_m": 0.19, "com_along_m": 0.11, "com_offset_m": 0.004, "mass_kg": 0.17, "inertia_kgm2": 0}],
    "joints": [{"stiffness_Nm_rad": 0.125, "damping_Nms_rad": 1.3e-3, "torque_offset_Nm": -2.5e-4}],
    "magnetics": [{"angle_deg": [-10, 0, 30, 60, 110], "torque_Nmm_A": [19.0, 17.5, 9.0, 4.1, 1.3]}],
    "effects": [{"id": "dry_friction", "parameters": {"torque_Nmm": 0.61}}]})";
  const std::vector<std::string> names = {"joint_stiffness", "/links/0/mass_kg", "/magnetics/0/torque_Nmm_A/1",
                                          "/effects/0/parameters/torque_Nmm"};
  const auto declared = parse_declared_actuator(file, "a.json", {.names = names, .file = "dataset.json"});
  const std::vector<double> values = {0.1234567890123456, 0.1 + 0.2, 16.9 / 1e3, 0.77 / 1e3};
  const actuator::Effect tilt{.kind = actuator::standard_effects().find("quadratic_drag"), .values = {1.7 / 1e3}};

  const std::string text = to_json(declared.updated(values, {tilt}), "unused").text();
  EXPECT_NE(text.find("\"name\": \"arm\""), std::string::npos) << text;
  EXPECT_NE(text.find("\"description\": \"kept\""), std::string::npos) << text;
  EXPECT_NE(text.find("\"gravity_m_s2\": 9.7,"), std::string::npos) << text;
  EXPECT_NE(text.find("\"angle_deg\": [-10, 0, 30, 60, 110]"), std::string::npos) << text;

  const auto back = std::get<actuator::Model>(parse_actuator(text, "x").content).nominal_spec();
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

TEST(UpdatedActuator, IsReadBackAsTheDesign) {
  const std::vector<std::string> names = {"joint_stiffness", "joint_damping"};
  const auto declared = parse_declared_actuator(
      R"({"format": "actuator/1", "configuration": "B", "model": {"torque": "line_of_centres"},
          "measured": {"joint_stiffness_Nmm_rad": 12.5}})",
      "a.json", {.names = names, .file = "dataset.json"});
  const std::vector<double> values = {13.7e-3, 0.19e-3};
  const auto updated = declared.updated(values, {});
  const Design back = std::get<Design>(parse_actuator(to_json(updated, "corrected").text(), "x").content);
  expect_same_bits(back, std::get<Design>(updated));
}

}  // namespace
}  // namespace coilwright::formats
