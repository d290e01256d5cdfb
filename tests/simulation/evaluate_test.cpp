#include "coilwright/simulation/evaluate.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "simulation/reference.hpp"

namespace coilwright::simulation {
namespace {

TEST(Evaluate, GivesThePerformanceOfTheAssembledDesign) {
  const actuator::Design design = actuator::paper_finger();
  const OperatingPoint point{.current = 1.3, .duty = 0.3};
  const EvaluatedDesign evaluated = evaluate(design, point);
  const auto parts = performance_of(design, actuator::assemble_or_throw(design), point);
  const auto& expected = std::get<Performance>(parts);
  EXPECT_EQ(evaluated.performance.cold.steady_angles, expected.cold.steady_angles);
  EXPECT_EQ(evaluated.performance.free.heat.coil_temperature, expected.free.heat.coil_temperature);
  EXPECT_EQ(standard_quantities().at("mass_g").value(evaluated.view()), expected.mass * 1e3);
  EXPECT_EQ(evaluated.view().point.duty, 0.3);
}

TEST(Evaluate, RefusesADesignThatCannotBeBuilt) {
  actuator::Design thin = actuator::paper_finger();
  thin.coil.inner_radius = 1e-4;  // narrower than the wire can be bent
  EXPECT_THROW((void)evaluate(thin, {.current = 1.3}), std::invalid_argument);
}

TEST(Evaluate, SaysWhyThereIsNoPerformance) {
  try {
    (void)evaluate(actuator::paper_finger(), {.current = std::numeric_limits<double>::infinity()});
    FAIL() << "no exception";
  } catch (const std::runtime_error& reason) {
    EXPECT_STREQ(reason.what(), "the current is not finite");
  }
}

}  // namespace
}  // namespace coilwright::simulation
