#include "coilwright/systems/gripper/quantities.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <string>

#include "coilwright/simulation/evaluate.hpp"
#include "coilwright/systems/gripper/grasp.hpp"
#include "coilwright/systems/gripper/heat_of_hold.hpp"
#include "coilwright/systems/validation/paper_finger.hpp"

namespace coilwright::systems::gripper {
namespace {

GripperTask ball_of_width(double width = 0.06) {
  return {.object = {.width = width, .mass = 0.04, .friction = 0.8, .centre = {0.0, -0.016}}};
}

simulation::EvaluatedDesign finger_at(double current = 1.4) {
  return simulation::evaluate(validation::paper_finger(), {.current = current});
}

// Counts how often a task is asked for: once for each try of the gripper.
struct Counted {
  explicit Counted(const GripperTask& task)
      : table(gripper_quantities([task, calls = calls](const simulation::Settings&) {
          ++*calls;
          return task;
        })) {
    *calls = 0;  // asked once for the number of fingers
  }
  std::shared_ptr<std::atomic<int>> calls = std::make_shared<std::atomic<int>>(0);
  simulation::QuantityTable table;
};

double value(const simulation::QuantityTable& table, const char* name, const simulation::EvaluatedDesign& design) {
  return table.at(name).value(design.view()).value();
}

TEST(GripperQuantities, AreThoseOfTheGrasp) {
  const Counted counted(ball_of_width());
  const auto design = finger_at();
  const GripperTask task = ball_of_width();
  const Gripper gripper(validation::paper_finger(), task.mounting);
  const Grasp found = grasp(gripper, task.object, {.current = 1.4});
  EXPECT_EQ(value(counted.table, "grip_margin", design), found.capacity / found.load - 1.0);
  EXPECT_EQ(value(counted.table, "grip_capacity_N", design), found.capacity);
  EXPECT_EQ(value(counted.table, "grip_closing_time_ms", design), found.closing_time * 1e3);
  EXPECT_EQ(value(counted.table, "grip_magnet_force_N", design), found.magnet_force);
  EXPECT_EQ(value(counted.table, "grip_load_N", design), 0.04 * 9.81);
  const auto heat = heat_of_hold(validation::paper_finger(), gripper, found, {.current = 1.4});
  EXPECT_EQ(value(counted.table, "grip_continuous_current_A", design), heat->current_for_good());
  EXPECT_EQ(value(counted.table, "grip_thermal_load", design), 1.4 / heat->current_for_good());
  const auto least = least_current(gripper, task.object, {}, design.performance.current_limit);
  EXPECT_EQ(value(counted.table, "grip_least_current_A", design), least.value());
}

// A grasp for a study that asks for a mass would cost it 30 times its evaluation.
TEST(GripperQuantities, TryTheGripperOnceAndOnlyWhereTheyNeedIt) {
  const Counted counted(ball_of_width());
  const auto design = finger_at();
  EXPECT_EQ(value(counted.table, "gripper_mass_g", design), 2e3 * design.performance.mass);
  EXPECT_EQ(*counted.calls, 0);  // what is assumed needs the task, and no try
  for (const char* name : {"grip_margin", "grip_closing_time_ms", "grip_thermal_load", "grip_normal_force_N"})
    (void)value(counted.table, name, design);
  EXPECT_EQ(*counted.calls, 1);
}

// The same bits without a place to keep results.
TEST(GripperQuantities, ArePureFunctionsOfTheDesign) {
  const Counted counted(ball_of_width());
  const auto design = finger_at();
  simulation::DesignView alone = design.view();
  alone.shared = nullptr;
  EXPECT_EQ(counted.table.at("grip_margin").value(alone), counted.table.at("grip_margin").value(design.view()));
  EXPECT_EQ(*counted.calls, 2);
}

// Table III of the paper: 44 US$ for a gripper.
TEST(GripperQuantities, CostWhatThePaperSays) {
  EXPECT_NEAR(value(Counted(ball_of_width()).table, "gripper_cost_USD", finger_at()), 44.0, 0.05);
}

// A finger is 8 US$ in that table, driver and supply 28.
TEST(GripperQuantities, CountTheFingers) {
  GripperTask task = ball_of_width();
  task.mounting.fingers = 3;
  const auto design = finger_at();
  const Counted three(task);
  EXPECT_DOUBLE_EQ(value(three.table, "gripper_mass_g", design), 3e3 * design.performance.mass);
  EXPECT_NEAR(value(three.table, "gripper_cost_USD", design), 52.0, 0.05);
}

// From a coefficient that does not hold to one that does, the margin grows and changes its sign where holding begins.
TEST(GripperQuantities, HaveAMarginThatASearchCanFollow) {
  double before = -2.0;
  const auto design = finger_at();
  for (const double friction : {0.05, 0.1, 0.15, 0.2, 0.3, 0.5, 0.8}) {
    GripperTask task = ball_of_width();
    task.object.friction = friction;
    const double margin = value(Counted(task).table, "grip_margin", design);
    EXPECT_TRUE(margin > before || (margin == before && margin == -0.01)) << friction;  // the last creeps away
    const Gripper gripper(validation::paper_finger(), task.mounting);
    EXPECT_EQ(margin >= 0.0, grasp(gripper, task.object, {.current = 1.4}).holds) << friction;
    before = margin;
  }
  EXPECT_GT(before, 0.0);
}

TEST(GripperQuantities, SayHowMuchAFingerLacksToReachTheObject) {
  const auto design = finger_at();
  double before = -20.0;
  for (const double width : {0.004, 0.006, 0.008, 0.01}) {
    const double margin = value(Counted(ball_of_width(width)).table, "grip_margin", design);
    EXPECT_LT(margin, -1.0);
    EXPECT_GT(margin, before) << width;
    before = margin;
  }
  const auto table = Counted(ball_of_width(0.004)).table;
  EXPECT_FALSE(table.at("grip_closing_time_ms").value(design.view()));
  EXPECT_EQ(table.at("grip_closing_time_ms").why_absent(design.view()).reason, "a finger does not reach the object");
}

TEST(GripperQuantities, SayHowLittleRoomThereIs) {
  const auto design = finger_at();
  const auto near = Counted(ball_of_width(0.1)).table, far = Counted(ball_of_width(0.11)).table;
  EXPECT_FALSE(near.at("grip_margin").value(design.view()));
  const simulation::NoValue less = near.at("grip_margin").why_absent(design.view());
  const simulation::NoValue more = far.at("grip_margin").why_absent(design.view());
  EXPECT_TRUE(less.reason.starts_with("object must leave the open fingers free; got ")) << less.reason;
  EXPECT_GT(less.infeasibility, 1.0);
  EXPECT_GT(more.infeasibility, less.infeasibility);
}

TEST(GripperQuantities, FollowTheSettingsOfADesign) {
  const simulation::QuantityTable table(gripper_quantities([](const simulation::Settings& settings) {
    GripperTask task = ball_of_width();
    if (const auto found = settings.find("gripper_mass_g"); found != settings.end()) task.object.mass = found->second;
    return task;
  }));
  auto design = finger_at();
  EXPECT_EQ(value(table, "grip_load_N", design), 0.04 * 9.81);
  auto heavy = finger_at();
  heavy.settings = {{"gripper_mass_g", 0.05}};
  EXPECT_EQ(value(table, "grip_load_N", heavy), 0.05 * 9.81);
}

}  // namespace
}  // namespace coilwright::systems::gripper
