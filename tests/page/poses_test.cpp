#include "coilwright/page/poses.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "coilwright/actuator/assemble.hpp"

namespace coilwright::page {
namespace {

using actuator::Configuration;
using mechanics::JointVector;

exports::BodyPlan plan_of(Configuration configuration) {
  actuator::Design design;
  design.layout = actuator::layout_of(configuration);
  return exports::body_plan({.origin = {}, .design = design, .assembly = actuator::assemble_or_throw(design)});
}

JointVector angles(std::initializer_list<double> values) {
  JointVector out(static_cast<Eigen::Index>(values.size()));
  Eigen::Index i = 0;
  for (const double value : values) out[i++] = value;
  return out;
}

TEST(Poses, HangStraightDownAtZero) {
  const exports::BodyPlan plan = plan_of(Configuration::B);
  const PosedPoint tip = posed(plan, angles({0.0, 0.0}), 0.0, plan.length, plan.axis_height);
  EXPECT_DOUBLE_EQ(tip.right, plan.axis_height);
  EXPECT_DOUBLE_EQ(tip.down, plan.length);
}

// The tip by the model's own chain, which turns the other way round its axes: a second route to the same place.
TEST(Poses, PutTheTipWhereTheChainHasIt) {
  actuator::Design design;
  design.layout = actuator::layout_of(Configuration::C);
  const actuator::Assembly assembly = actuator::assemble_or_throw(design);
  const exports::BodyPlan plan = exports::body_plan({.origin = {}, .design = design, .assembly = assembly});
  const JointVector pose = angles({0.31, 0.12, 0.55, 0.07});
  // Along the hinge line from the first joint on: the sum of the segments, each turned by all joints before it.
  double down = plan.joints[0];
  double left = 0.0;
  double turn = 0.0;
  for (std::size_t i = 0; i < plan.joints.size(); ++i) {
    turn += pose[static_cast<Eigen::Index>(i)];
    const double length = (i + 1 < plan.joints.size() ? plan.joints[i + 1] : plan.length) - plan.joints[i];
    down += length * std::cos(turn);
    left += length * std::sin(turn);
  }
  const PosedPoint tip = posed(plan, pose, 0.0, plan.length, plan.hinge_height);
  EXPECT_NEAR(tip.down, down, 1e-15);
  EXPECT_NEAR(tip.right, plan.hinge_height - left, 1e-15);
}

// An opening joint turns the tip to the side of the bottom layer, away from the slits: the slits gape.
TEST(Poses, OpenTheSlits) {
  const exports::BodyPlan plan = plan_of(Configuration::A);
  const double joint = plan.joints[0];
  const JointVector open = angles({0.5});
  const PosedPoint before = posed(plan, open, 0.0, joint, plan.height);
  const PosedPoint behind = posed(plan, open, 0.0, joint + 1e-12, plan.height);
  EXPECT_GT(behind.down, before.down);
  EXPECT_NEAR(std::hypot(behind.down - before.down, behind.right - before.right),
              2.0 * (plan.height - plan.hinge_height) * std::sin(0.25), 1e-9);
}

TEST(Poses, TurnTheWholeByTheTiltOfTheBase) {
  const exports::BodyPlan plan = plan_of(Configuration::A);
  const double quarter = 0.5 * std::numbers::pi;
  const PosedPoint tip = posed(plan, angles({0.0}), quarter, plan.length, 0.0);
  EXPECT_NEAR(tip.right, -plan.length, 1e-15);
  EXPECT_NEAR(tip.down, 0.0, 1e-15);
}

TEST(Poses, AreDrawnToOneScale) {
  const exports::BodyPlan plan = plan_of(Configuration::B);
  const std::vector<Figure> figures = pose_figures(plan,
                                                   {{.id = "one", .title = "one", .angles = angles({0.0, 0.0})},
                                                    {.id = "two", .title = "two", .angles = angles({0.7, 0.9})}},
                                                   0.0);
  ASSERT_EQ(figures.size(), 2U);
  const auto box = [](const Figure& figure) {
    const std::string& svg = std::get<Drawing>(figure.content).svg;
    const std::size_t start = svg.find("viewBox=\"");
    return svg.substr(start, svg.find('"', start + 9) - start);
  };
  EXPECT_EQ(box(figures[0]), box(figures[1]));
  EXPECT_THAT(figures[1].description, ::testing::HasSubstr("joint angles 40.1, 51.6 deg, bending angle 91.7 deg"));
}

TEST(Poses, RefuseAnotherNumberOfJoints) {
  EXPECT_THROW(pose_figures(plan_of(Configuration::B), {{.id = "x", .title = "x", .angles = angles({0.0})}}, 0.0),
               std::invalid_argument);
}

}  // namespace
}  // namespace coilwright::page
