#include "coilwright/simulation/step_motion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "coilwright/actuator/heat.hpp"
#include "coilwright/simulation/heating.hpp"
#include "coilwright/thermal/steady_state.hpp"
#include "simulation/reference.hpp"

namespace coilwright::simulation {
namespace {

EvaluatedDesign warm_finger() {
  actuator::Design design = actuator::paper_finger();
  actuator::make_of_grade(design.magnet, "N52");
  return evaluate(design, {.current = 1.1, .duty = 0.8});
}

// The figures of Performance come from another integration, which looks at every step; here are samples of one of 1e-7.
TEST(StepMotion, HasThePeaksThatPerformanceStates) {
  for (const EvaluatedDesign& design : {warm_finger(), evaluate(actuator::paper_finger(), {.current = 1.4})}) {
    const FreeMotion& told = *design.performance.free.motion;
    const StepMotion motion = step_motion(design, 0.4, 4001).value();
    double fastest = 0.0;
    for (const State& state : motion.states) fastest = std::max(fastest, std::abs(state.rates.sum()));
    // Between samples 0.1 ms apart a peak of 30 ms width is missed by 1e-5 of it; step_response() is good to 1e-5.
    EXPECT_NEAR(fastest, told.peak_bending_speed, 5e-5 * told.peak_bending_speed);
    const State& peak = motion.states[peak_of(motion)];
    EXPECT_NEAR(peak.angles.sum(), told.peak_angle, 5e-5 * told.peak_angle);
    EXPECT_EQ(motion.states.front().angles, told.rest_angles);
  }
}

TEST(StepMotion, EndsWherePerformanceSaysThatItSettles) {
  const EvaluatedDesign design = warm_finger();
  const FreeMotion& told = *design.performance.free.motion;
  const StepMotion motion = step_motion(design, 6.0, 3).value();
  EXPECT_LT((motion.states.back().angles - told.steady_angles).lpNorm<Eigen::Infinity>(), 1e-4);
}

// Rounding must not put the last sample behind the end of the input: of these durations 0.8889541585700292 did.
TEST(StepMotion, EndsAtItsDurationToTheBit) {
  const EvaluatedDesign design = warm_finger();
  for (const double duration : {0.8889541585700292, 0.1, 0.7, 1.0 / 3.0})
    for (const std::size_t samples : {2u, 7u, 240u, 241u})
      EXPECT_EQ(step_motion(design, duration, samples).value().times.back(), duration);
}

TEST(StepMotion, RefusesWhatIsNoTime) {
  const EvaluatedDesign design = warm_finger();
  EXPECT_THROW(static_cast<void>(step_motion(design, 0.0, 10)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(step_motion(design, 1.0, 1)), std::invalid_argument);
}

// The steady state is one linear system, the transient a sum of modes. In the norm of the heat capacities every mode
// decays at least as fast as the slowest one, so after five of its time constants no part is further away than this.
thermal::NodeVector farthest_after_five(const EvaluatedDesign& design) {
  const thermal::Network network =
      actuator::heat_network(design.design, design.assembly, design.performance.free.motion->steady_angles);
  const double load = thermal::mean_square({.current = design.point.current, .duty = design.point.duty});
  const thermal::SteadyState end = thermal::steady_state(network, thermal::same_in_every_coil(network, load));
  double energy = 0.0;
  for (Eigen::Index i = 0; i < network.size(); ++i) {
    const double rise = end.temperatures[i] - network.ambient();
    energy += network.nodes()[static_cast<std::size_t>(i)].heat_capacity * rise * rise;
  }
  thermal::NodeVector bound(network.size());
  for (Eigen::Index i = 0; i < network.size(); ++i)
    bound[i] = std::exp(-5.0) * std::sqrt(energy / network.nodes()[static_cast<std::size_t>(i)].heat_capacity);
  return bound;
}

TEST(Heating, EndsNearTheSteadyTemperaturesOfPerformance) {
  const EvaluatedDesign design = warm_finger();
  const Heating warm = heating(design, 50);
  const thermal::NodeVector& steady = design.performance.free.heat.temperatures;
  const thermal::NodeVector bound = farthest_after_five(design);
  EXPECT_FALSE(warm.runaway);
  EXPECT_EQ(warm.times.front(), 0.0);
  for (Eigen::Index i = 0; i < steady.size(); ++i) {
    EXPECT_NEAR(warm.means.front()[i], design.design.surroundings.ambient, 1e-9);
    EXPECT_NEAR(warm.means.back()[i], steady[i], bound[i]);
    EXPECT_LT(warm.means.back()[i], steady[i]);
  }
}

TEST(Heating, StopsARunawayWhereItIsHotEnough) {
  actuator::Design finger = actuator::paper_finger();
  const EvaluatedDesign cold = evaluate(finger, {.current = 1.0});
  const EvaluatedDesign design = evaluate(finger, {.current = 1.2 * cold.performance.free.heat.runaway_current});
  const Heating hot = heating(design, 200);
  EXPECT_TRUE(hot.runaway);
  EXPECT_GT(hot.hot_spots.back().maxCoeff(), design.design.surroundings.coil_limit);
  EXPECT_TRUE(std::ranges::is_sorted(hot.times));
}

}  // namespace
}  // namespace coilwright::simulation
