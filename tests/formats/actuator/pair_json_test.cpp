#include "coilwright/formats/actuator/pair_file.hpp"

#include <gtest/gtest.h>

#include <array>
#include <variant>

namespace coilwright::formats {
namespace {

TEST(PairJson, ReadsBackAsTheSamePair) {
  const magnetics::DrivenCoil coil{
      .coil = magnetics::ThickCoil({.inner_radius = 3.3e-3,
                                    .outer_radius = 9.7e-3,
                                    .length = 12.1e-3,
                                    .turns_radial = 15,
                                    .turns_axial = 31,
                                    .winding = magnetics::CurrentDistribution::paper_shells}),
      .current = -1.4};
  const magnetics::CylinderMagnet magnet(
      {.radius = 10.1e-3, .length = 6.2e-3, .remanence = 1.44, .recoil_permeability = 1.05});
  const std::array poses{magnetics::Pose{.position = {0.5e-3, -0.1e-3, 9.9e-3}, .axis = {0.0, 0.1, 2.0}},
                         magnetics::Pose{.position = {0.0, 0.0, 20e-3}}};
  const PairFile read = parse_pair(to_json(coil, magnet, poses).text(), "x");
  const auto& driven = std::get<magnetics::DrivenCoil>(read.bodies[0].part);
  EXPECT_EQ(driven.coil.inner_radius(), 3.3e-3);
  EXPECT_EQ(driven.coil.outer_radius(), 9.7e-3);
  EXPECT_EQ(driven.coil.length(), 12.1e-3);
  EXPECT_EQ(driven.coil.turns_radial(), 15);
  EXPECT_EQ(driven.coil.turns_axial(), 31);
  EXPECT_EQ(driven.coil.winding(), magnetics::CurrentDistribution::paper_shells);
  EXPECT_EQ(driven.current, -1.4);
  const auto& posed = std::get<magnetics::Magnet>(read.bodies[1].part);
  EXPECT_EQ(std::get<magnetics::Ring>(posed.shape).outer_radius, 10.1e-3);
  EXPECT_EQ(std::get<magnetics::Ring>(posed.shape).length, 6.2e-3);
  EXPECT_EQ(posed.remanence.z(), 1.44);
  EXPECT_EQ(posed.recoil_permeability, 1.05);
  ASSERT_EQ(read.poses.size(), 2U);
  EXPECT_EQ(read.poses[0].position, poses[0].position);
  EXPECT_EQ(read.poses[0].axis, poses[0].axis);
  EXPECT_EQ(read.poses[1].position, poses[1].position);
}

}  // namespace
}  // namespace coilwright::formats
