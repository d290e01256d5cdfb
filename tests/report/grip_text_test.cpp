#include "coilwright/report/systems/grip_text.hpp"

#include <gmock/gmock.h>

#include "degree.hpp"

namespace coilwright::report {
namespace {

using systems::gripper::GripAnswer;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

// A ball of 40 g between fingers that carry twice its weight.
GripAnswer held_ball(int fingers) {
  GripAnswer out;
  out.mounting = {.angle = 0.5, .spacing = 0.07, .fingers = fingers};
  out.object.mass = 0.04;
  out.current = 0.9;
  out.grasp.holds = out.grasp.both_touched = true;
  out.grasp.closing_time = 0.0178;
  out.grasp.load = 0.3924;
  out.grasp.capacity = 0.7848;
  out.grasp.magnet_force = 0.0191;
  out.grasp.left = mechanics::JointVector::Constant(2, 24.0 * degree);
  out.grasp.right = mechanics::JointVector::Constant(2, 23.5 * degree);
  out.grasp.contacts = {
      {.finger = 0, .link = 1, .along = 0.01942, .position = {-0.02852, -0.02524}, .normal = 0.3259, .friction = 0.1},
      {.finger = 1, .link = 0, .along = 0.00311, .position = {0.0285, -0.0252}, .normal = 0.3, .friction = -0.05}};
  out.tolerance = {.height = {.below = 2e-3, .above = 5e-3},
                   .width = {.below = 0.0, .above = 0.75e-3},
                   .spacing = {.below = 1.5e-3, .above = 1e-3},
                   .mounting_angle = {.below = 15.0 * degree, .above = 0.5 * degree}};
  out.cost = 44.2;
  out.burns_from = 1.9;
  return out;
}

TEST(GripText, SaysWhatHoldsTheObjectAndHowFarThatMayBeOff) {
  EXPECT_EQ(to_text(held_ball(2)),
            "Held: 40 g at 0.9 A. The load is 0.3924 N; it slips at 0.7848 N, 2 times that.\n"
            "Both fingers touch it after 17.8 ms.\n"
            "\n"
            "Fingers while they hold it\n"
            "  finger   link    along mm     x mm     y mm  normal N friction N\n"
            "  left        1       19.42   -28.52   -25.24    0.3259     0.1000\n"
            "  right       0        3.11    28.50   -25.20    0.3000    -0.0500\n"
            "  bending 48 deg left, 47 deg right; their magnets repel each other with up to 0.0191 N\n"
            "\n"
            "How far off one of these may be, the others as given, and it is still held\n"
            "  height of the object  2 mm lower to 5 mm or more higher\n"
            "  width of the object   less than 0.1 mm narrower to 0.75 mm wider\n"
            "  spacing of the palm   1.5 mm narrower to 1 mm wider\n"
            "  mounting angle        15 deg or more further in to 0.5 deg further out\n"
            "MIND: less than a millimetre loses it, and hands and printed palms are off by that.\n"
            "\n"
            "Two such fingers with driver and supply cost 44 USD; the pneumatic gripper of the paper's Table III 607 "
            "USD.\n"
            "\n"
            "It rests on: friction and place of the object as given, rigid segments, coils and magnets at 20 degC, an "
            "object that\n"
            "moves in the plane of the fingers only.\n");
}

TEST(GripText, LetsOneFingerStandForMoreThanTwo) {
  const std::string text = to_text(held_ball(3));
  EXPECT_THAT(text, HasSubstr("\nAll 3 fingers touch it after 17.8 ms.\n"));
  EXPECT_THAT(text,
              HasSubstr("friction N\n"
                        "  each        1       19.42   -28.52   -25.24    0.3259     0.1000\n"
                        "  bending 48 deg each; magnets that face each other repel, two of them with up to 0.0191 "
                        "N\n"));
}

// Rounded up: 0.812 A would not hold it.
TEST(GripText, GivesALeastCurrentThatHolds) {
  GripAnswer answer = held_ball(2);
  answer.least_current = {.most = 1.4, .found = 0.81234};
  answer.least_friction = {.most = 2.0};
  EXPECT_THAT(to_text(answer), HasSubstr("\nThe least current that holds it: 0.813 A.\n"
                                         "\nThe least friction: none up to 2 holds it.\n"));
}

TEST(GripText, SaysFirstWhatTheFingersDoNotSurvive) {
  GripAnswer answer = held_ball(2);
  answer.current = 1.9;
  EXPECT_THAT(to_text(answer), StartsWith("Held for moments, until it burns (see below): 40 g at 1.9 A. "));
  answer.magnets_cold = {.margin = -0.25};
  EXPECT_THAT(to_text(answer), StartsWith("Not for long: the magnets are lost (see below). Until then held: 40 g "));
  EXPECT_THAT(to_text(answer), HasSubstr("The coils' field at 1.9 A demagnetises the magnets for good, even at 20 degC "
                                         "(margin -0.25, at least 0): these forces are there once at most.\n"));
}

TEST(GripText, SaysWhatHeatTakesFromMagnetsThatTheFieldLeavesAlone) {
  GripAnswer answer = held_ball(2);
  answer.burns_from = 2.0;
  answer.heat = {.magnet_temperature = 91.26};
  answer.magnets_cold = {.margin = 0.3};
  answer.magnets_held = {.margin = 0.1, .irreversible_loss = 0.0123};
  EXPECT_THAT(to_text(answer), StartsWith("Held, but the magnets weaken (see below): 40 g "));
  EXPECT_THAT(to_text(answer), HasSubstr("If it goes on without end, the worst magnet loses 1.23 % of its moment for "
                                         "good; the hottest is at 91.26 degC.\n"));
  answer.magnets_held->irreversible_loss = 1e-5;
  EXPECT_THAT(to_text(answer), StartsWith("Held: 40 g "));
  EXPECT_THAT(to_text(answer), HasSubstr("loses less than 0.1 % of its moment for good"));
}

TEST(GripText, SaysThatAHoldWithoutASteadyTemperatureCostsTheMagnetsWhatNobodyKnows) {
  GripAnswer answer = held_ball(2);
  answer.heat = {.time_to_limit = 55.6};
  answer.magnets_cold = {.margin = 0.3};
  EXPECT_THAT(to_text(answer), HasSubstr("from cold.\nWhat a hold costs the magnets is not known: there is no steady "
                                         "temperature at 0.9 A.\n"));
  answer.magnets_cold.reset();
  EXPECT_THAT(to_text(answer), Not(HasSubstr("not known")));
}

TEST(GripText, SaysHowFarAFingerStaysAway) {
  GripAnswer answer = held_ball(2);
  answer.grasp.holds = answer.grasp.both_touched = false;
  answer.grasp.missing = 0.0123;
  EXPECT_THAT(to_text(answer),
              StartsWith("Not held: 40 g at 0.9 A. A finger does not reach the object: it stays 12.3 mm "
                         "away.\n\nFingers where they end\n"));
}

}  // namespace
}  // namespace coilwright::report
