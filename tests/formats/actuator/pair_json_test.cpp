#include "coilwright/formats/actuator/pair_json.hpp"

#include <gtest/gtest.h>

#include <array>
#include <variant>

namespace coilwright::formats {
namespace {

TEST(PairJson, ReadsBackAsTheSamePair) {
  const CoilAndMagnet pair{.coil = magnetics::ThickCoil({.inner_radius = 3.3e-3,
                                                         .outer_radius = 9.7e-3,
                                                         .length = 12.1e-3,
                                                         .turns_radial = 15,
                                                         .turns_axial = 31,
                                                         .winding = magnetics::CurrentDistribution::paper_shells}),
                           .current = -1.4,
                           .magnet = magnetics::CylinderMagnet(
                               {.radius = 10.1e-3, .length = 6.2e-3, .remanence = 1.44, .recoil_permeability = 1.05})};
  const std::array poses{magnetics::Pose{.position = {0.5e-3, -0.1e-3, 9.9e-3}, .axis = {0.0, 0.1, 2.0}},
                         magnetics::Pose{.position = {0.0, 0.0, 20e-3}}};
  const PairFile read = parse_pair(to_json(pair, poses).text(), "x");
  const auto& bodies = std::get<CoilAndMagnet>(read.bodies);
  EXPECT_EQ(bodies.coil.inner_radius(), 3.3e-3);
  EXPECT_EQ(bodies.coil.outer_radius(), 9.7e-3);
  EXPECT_EQ(bodies.coil.length(), 12.1e-3);
  EXPECT_EQ(bodies.coil.turns_radial(), 15);
  EXPECT_EQ(bodies.coil.turns_axial(), 31);
  EXPECT_EQ(bodies.coil.winding(), magnetics::CurrentDistribution::paper_shells);
  EXPECT_EQ(bodies.current, -1.4);
  EXPECT_EQ(bodies.magnet.radius(), 10.1e-3);
  EXPECT_EQ(bodies.magnet.length(), 6.2e-3);
  EXPECT_EQ(bodies.magnet.remanence(), 1.44);
  EXPECT_EQ(bodies.magnet.recoil_permeability(), 1.05);
  ASSERT_EQ(read.poses.size(), 2U);
  EXPECT_EQ(read.poses[0].position, poses[0].position);
  EXPECT_EQ(read.poses[0].axis, poses[0].axis);
  EXPECT_EQ(read.poses[1].position, poses[1].position);
}

}  // namespace
}  // namespace coilwright::formats
