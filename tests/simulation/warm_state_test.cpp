#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "coilwright/actuator/demagnetisation.hpp"
#include "coilwright/simulation/evaluate.hpp"
#include "coilwright/simulation/part_limits.hpp"
#include "coilwright/simulation/performance.hpp"
#include "coilwright/simulation/quantity.hpp"
#include "simulation/performance_at.hpp"
#include "simulation/reference.hpp"

namespace coilwright::simulation {
namespace {

using actuator::Design;

Design graded(actuator::Configuration configuration = actuator::Configuration::B) {
  Design design = actuator::paper_finger();
  design.layout = actuator::layout_of(configuration);
  actuator::make_of_grade(design.magnet, "N52");
  return design;
}

// The motion of a model whose magnets were weakened by hand to what the reported temperatures leave of them.
MotionSummary by_hand(const Design& design, const thermal::NodeVector& temperatures, double current) {
  const std::vector<double> strengths = actuator::magnet_strengths(
      design, std::span<const double>(temperatures.data(), static_cast<std::size_t>(temperatures.size())));
  const actuator::Assembly assembly = actuator::assemble_or_throw(design);
  return std::get<MotionSummary>(motion_of(assembly.model.with_magnet_strengths(strengths), current));
}

// Pose and temperatures belong together: the loop ends where weakening the magnets once more changes nothing.
TEST(WarmState, IsWhereHeatAndPoseAgree) {
  for (const auto configuration : {actuator::Configuration::B, actuator::Configuration::C}) {
    const Design design = graded(configuration);
    const Performance warm = performance_at(design, {.current = 0.8});
    const MotionSummary free = by_hand(design, warm.free.heat.temperatures, 0.8);
    ASSERT_TRUE(warm.free.motion && warm.gripping.grasp);
    EXPECT_LT((warm.free.motion->steady_angles - free.steady_angles).norm(), 1e-8);
    EXPECT_NEAR(warm.free.motion->peak_bending_speed / free.peak_bending_speed, 1.0, 1e-7);
    const MotionSummary gripping = by_hand(design, warm.gripping.heat.temperatures, 0.8);
    EXPECT_NEAR(warm.gripping.grasp->grasp_force / gripping.grasp_force, 1.0, 1e-7);
    EXPECT_LT(warm.free.motion->peak_bending_speed, warm.cold.peak_bending_speed);
    EXPECT_LT(warm.gripping.grasp->grasp_force, warm.cold.grasp_force);
  }
}

TEST(WarmState, IsTheColdOneWhereMagnetsHaveNoGrade) {
  const Performance found = performance_at(actuator::paper_finger(), {.current = 1.1});
  EXPECT_EQ(found.free.motion.value().peak_bending_speed, found.cold.peak_bending_speed);
  EXPECT_EQ(found.gripping.grasp.value().grasp_force, found.cold.grasp_force);
  EXPECT_FALSE(found.demagnetisation.has_value());
}

TEST(WarmState, IsTheColdOneAtTwentyDegrees) {
  Design design = graded();
  design.surroundings.ambient = 20.0;
  const Performance found = performance_at(design, {.current = 1.4, .duty = 0.0});
  // Temperatures come from a solver: 20 degC to its rounding, and equilibria from another start.
  EXPECT_NEAR(found.free.motion.value().peak_bending_speed / found.cold.peak_bending_speed, 1.0, 1e-9);
  EXPECT_NEAR(found.gripping.grasp.value().grasp_force / found.cold.grasp_force, 1.0, 1e-9);
}

TEST(WarmState, DoesNotExistInARunawayThatMagnetsFeel) {
  const Performance hot = performance_at(graded(), {.current = 4.0});
  EXPECT_FALSE(hot.free.motion.has_value());
  EXPECT_FALSE(hot.gripping.grasp.has_value());
  EXPECT_FALSE(hot.demagnetisation.has_value());
  EXPECT_GT(hot.cold.peak_bending_speed, 0.0);
  const Performance unfeeling = performance_at(actuator::paper_finger(), {.current = 4.0});
  EXPECT_FALSE(unfeeling.free.heat.coil_temperature.has_value());
  EXPECT_TRUE(unfeeling.free.motion.has_value());
}

TEST(WarmState, TakesTheWorseCaseForTheMargin) {
  const Design design = graded();
  const Performance found = performance_at(design, {.current = 0.9});
  const actuator::InnerFields fields(design, actuator::assemble_or_throw(design));
  const auto margin = [&](const Heat& heat) {
    return fields.demagnetisation(std::span<const double>(heat.temperatures.data(), 3), 0.9).margin;
  };
  EXPECT_EQ(found.demagnetisation.value().margin, std::min(margin(found.free.heat), margin(found.gripping.heat)));
}

// At 1.4 A the prototype's magnet comes to 73 degC, where its inner field exceeds its coercivity.
TEST(WarmState, MarksADemagnetisedMagnetAsABrokenLimit) {
  const auto broken = [](const Design& design, double current) {
    const EvaluatedDesign found = evaluate(design, {.current = current});
    const std::vector<PartLimit> limits = part_limits(found.view());
    const auto loss = std::ranges::find(limits, "irreversible_loss_pct", &PartLimit::quantity);
    return loss == limits.end() ? std::nullopt : std::optional(loss->is_broken());
  };
  EXPECT_EQ(broken(graded(), 1.4), true);
  EXPECT_EQ(broken(graded(), 0.3), false);
  EXPECT_EQ(broken(actuator::paper_finger(), 1.4), std::nullopt);
}

TEST(WarmState, SaysWhyAQuantityHasNoValue) {
  const auto absence = [](const char* name) { return standard_quantities().at(name).absence; };
  EXPECT_EQ(absence("peak_bending_speed_deg_s"), "the current is at or beyond that of a thermal runaway");
  EXPECT_EQ(
      absence("demagnetisation_margin"),
      "the magnets have no grade and state no coercivity with its coefficient, or the current is at or beyond that "
      "of a thermal runaway");
}

}  // namespace
}  // namespace coilwright::simulation
