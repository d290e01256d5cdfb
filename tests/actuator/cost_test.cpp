#include "coilwright/actuator/cost.hpp"

#include <gtest/gtest.h>

#include "actuator/paper_finger.hpp"
#include "coilwright/actuator/assemble.hpp"

namespace coilwright::actuator {
namespace {

// Table III: 5 silicone and moulds, 4 coils, 6 magnets, 1 wires, 8 driver board, 20 power supply.
TEST(Cost, OfAGripperOfTwoPrototypesIsThePapers44Dollars) {
  const Design design = paper_finger();
  const Cost finger = cost_of(design, assemble_or_throw(design));
  EXPECT_DOUBLE_EQ(2.0 * finger.silicone_and_moulds, 5.0);
  EXPECT_DOUBLE_EQ(2.0 * finger.coils, 4.0);
  EXPECT_DOUBLE_EQ(2.0 * finger.magnets, 6.0);
  EXPECT_DOUBLE_EQ(2.0 * finger.wires, 1.0);
  EXPECT_DOUBLE_EQ(2.0 * finger.total() + driver_and_supply_cost, 44.0);
}

TEST(Cost, GrowsWithCopperAndMagnetVolume) {
  Design design = paper_finger();
  design.layout = layout_of(Configuration::C);
  design.magnet.length *= 1.5;
  const Assembly a = assemble_or_throw(design);
  const Cost cost = cost_of(design, a);
  EXPECT_DOUBLE_EQ(cost.coils, 3.0);
  EXPECT_DOUBLE_EQ(cost.magnets, 2.0 * 3.0 * 1.5);
}

// N42 is four steps below N52: 3 / 1.075^4.
TEST(Cost, FollowsThePriceOfTheGrade) {
  Design design = paper_finger();
  design.magnet.grade = magnetics::find_magnet_grade("N52");
  EXPECT_DOUBLE_EQ(cost_of(design, assemble_or_throw(design)).magnets, 3.0);
  design.magnet.grade = magnetics::find_magnet_grade("N42");
  EXPECT_NEAR(cost_of(design, assemble_or_throw(design)).magnets, 2.2464, 5e-5);
}

}  // namespace
}  // namespace coilwright::actuator
