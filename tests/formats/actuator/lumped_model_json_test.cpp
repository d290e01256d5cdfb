#include "coilwright/formats/actuator/actuator_json.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <variant>

#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "coilwright/formats/actuator/actuator_file.hpp"

namespace coilwright::formats {
namespace {

using actuator::LumpedModel;
using actuator::Model;

// Three links, of which the middle joint has no coil; no two numbers alike.
LumpedModel model_by_hand() {
  return {
      .gravity = 9.7,
      .links = {{.length = 7.2e-3, .com_along = 3.1e-3, .com_offset = 11.5e-3, .mass = 16.5e-3, .inertia = 4.1e-7},
                {.length = 8.3e-3,
                 .com_along = 2.9e-3,
                 .com_offset = 10.7e-3,
                 .mass = 14.2e-3,
                 .inertia = 3.3e-7,
                 .rotor_inertia = 2.7e-7},
                {.length = 21.2e-3, .com_along = 9.1e-3, .com_offset = -1.3e-3, .mass = 22.5e-3, .inertia = 0.0}},
      .hinges = {{.stiffness = 12.5e-3, .damping = 0.129e-3, .torque_offset = 0.2e-3, .contact = {}},
                 {.stiffness = 11.1e-3,
                  .damping = 0.117e-3,
                  .torque_offset = 0.0,
                  .contact = {.closing_angle = -0.03, .stiffness = 79.0, .damping = 0.004}},
                 {.stiffness = 13.9e-3, .damping = 0.141e-3}},
      .pairs = {{.joint = 0,
                 .source = actuator::TorqueTable{.angles = {-0.1, 0.3, 0.9, 1.4, 2.0},
                                                 .torques = {0.019, 0.012, 0.006, 0.003, 0.001}}},
                {.joint = 2,
                 .source =
                     actuator::PairDimensions{
                         .coil = {.inner_radius = 3e-3,
                                  .outer_radius = 9.5e-3,
                                  .length = 12e-3,
                                  .turns_radial = 15,
                                  .turns_axial = 30,
                                  .winding = magnetics::CurrentDistribution::layer_centres},
                         .magnet = {.radius = 10e-3, .length = 6e-3, .remanence = 1.44, .recoil_permeability = 1.05},
                         .geometry = {.coil_offset = 6.3e-3, .magnet_offset = 3.6e-3, .axis_offset = 11.5e-3},
                         .fidelity = magnetics::Fidelity::line_of_centres}}},
      .effects = {{.kind = actuator::standard_effects().find("base_tilt"), .values = {0.2}}},
      .as_built = {.joint_stiffness_ratio = 0.04}};
}

Model read_back(const LumpedModel& model) {
  return std::get<Model>(parse_actuator(to_json(model, "by hand", "of a test").text(), "x").content);
}

TEST(LumpedModelJson, ReadsBackAsTheSameLinksAndJoints) {
  const LumpedModel written = model_by_hand();
  const Model read = read_back(written);
  const Model direct(actuator::spec_of(written, actuator::magnetics_of(written)));
  ASSERT_EQ(read.joints(), 3);
  EXPECT_DOUBLE_EQ(read.chain().gravity(), 9.7);
  EXPECT_DOUBLE_EQ(read.chain().base_tilt(), 0.2);
  for (int j = 0; j < 3; ++j) {
    const mechanics::Link& link = read.chain().link(j);
    const mechanics::Link& expected = written.links[static_cast<std::size_t>(j)];
    EXPECT_DOUBLE_EQ(link.length, expected.length);
    EXPECT_DOUBLE_EQ(link.com_along, expected.com_along);
    EXPECT_DOUBLE_EQ(link.com_offset, expected.com_offset);
    EXPECT_DOUBLE_EQ(link.mass, expected.mass);
    EXPECT_DOUBLE_EQ(link.inertia, expected.inertia);
    EXPECT_DOUBLE_EQ(link.rotor_inertia, expected.rotor_inertia);
    const actuator::Hinge& hinge = read.hinges()[static_cast<std::size_t>(j)];
    const actuator::Hinge& made = direct.hinges()[static_cast<std::size_t>(j)];
    EXPECT_DOUBLE_EQ(hinge.stiffness, made.stiffness);
    EXPECT_DOUBLE_EQ(hinge.damping, made.damping);
    EXPECT_DOUBLE_EQ(hinge.torque_offset, made.torque_offset);
    EXPECT_DOUBLE_EQ(hinge.contact.closing_angle, made.contact.closing_angle);
    EXPECT_DOUBLE_EQ(hinge.contact.stiffness, made.contact.stiffness);
    EXPECT_DOUBLE_EQ(hinge.contact.damping, made.contact.damping);
  }
  // The ratio of the joints is in the file, and is in the springs once: 1 - r/2 and 1 + r/2 in turn.
  EXPECT_DOUBLE_EQ(read.hinges()[1].stiffness, 11.1e-3 * 1.02);
}

TEST(LumpedModelJson, ReadsBackAsTheSameTorques) {
  const LumpedModel written = model_by_hand();
  const Model read = read_back(written);
  ASSERT_EQ(read.coils(), 2);
  const Model direct(actuator::spec_of(written, actuator::magnetics_of(written)));
  mechanics::JointVector pose(3);
  pose << 0.31, 0.05, 0.72;
  const actuator::CoilCurrents currents = (actuator::CoilCurrents(2) << 1.1, 0.6).finished();
  const mechanics::JointVector torques = read.magnetic_torques(pose, currents);
  const mechanics::JointVector expected = direct.magnetic_torques(pose, currents);
  EXPECT_EQ(torques[1], 0.0);
  EXPECT_GT(torques[0], 0.0);
  for (const int joint : {0, 2}) EXPECT_NEAR(torques[joint], expected[joint], 1e-12);  // roundings of the dimensions
}

TEST(LumpedModelJson, RefusesTwoPairsAtAJointAndAPairWithout) {
  LumpedModel model = model_by_hand();
  model.pairs[1].joint = 0;
  EXPECT_THROW((void)to_json(model, ""), std::invalid_argument);
  model.pairs[1].joint = 3;
  EXPECT_THROW((void)to_json(model, ""), std::invalid_argument);
}

TEST(LumpedModelJson, LeavesOutWhatIsNotThere) {
  LumpedModel model = model_by_hand();
  model.pairs.clear();
  model.effects.clear();
  model.as_built = {};
  const std::string text = to_json(model, "bare").text();
  for (const char* key : {"magnetics", "effects", "as_built", "description"})
    EXPECT_EQ(text.find(key), std::string::npos) << key;
  EXPECT_EQ(std::get<Model>(parse_actuator(text, "x").content).coils(), 0);
}

}  // namespace
}  // namespace coilwright::formats
