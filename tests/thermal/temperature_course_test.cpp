#include "coilwright/thermal/temperature_course.hpp"

#include <gtest/gtest.h>

#include "error_text.hpp"
#include "thermal/sample_networks.hpp"

namespace coilwright::thermal {
namespace {

// Of a current that stays, whose answer Transient has in closed form.
HeatAt heat_of_a_held_current(const Network& network, double mean_square_current) {
  const NodeVector squares = same_in_every_coil(network, mean_square_current);
  return [&network, squares](const NodeVector& temperatures) -> NodeVector {
    return squares.cwiseProduct(
        network.ambient_resistance() +
        network.resistance_slope().cwiseProduct((temperatures.array() - network.ambient()).matrix()));
  };
}

TEST(TemperatureCourse, IsTheClosedFormsUnderAHeldCurrent) {
  const Network network = five_nodes();
  for (const double square : {0.3, 2.0}) {  // settling, and a runaway
    const TemperatureCourse course =
        temperature_course(network, heat_of_a_held_current(network, square), {.duration = 900.0, .interval = 100.0});
    const Transient exact(network, {.mean_square_currents = same_in_every_coil(network, square),
                                    .initial = NodeVector::Constant(network.size(), network.ambient())});
    ASSERT_EQ(course.times.size(), 10U);
    for (std::size_t i = 0; i < course.times.size(); ++i) {
      const NodeVector expected = exact.temperatures(course.times[i]);
      EXPECT_LT(((course.temperatures[i] - expected).array() / expected.array()).abs().maxCoeff(), 1e-5)
          << square << " A^2, " << course.times[i] << " s";
    }
  }
}

TEST(TemperatureCourse, FindsTheTimeToTheFirstLimit) {
  const Network network = five_nodes();
  const double current = 1.5;
  const auto expected = time_to_limit(network, {.holding_current = 0.0, .overload_current = current});
  ASSERT_TRUE(expected);
  const TemperatureCourse course = temperature_course(network, heat_of_a_held_current(network, current * current),
                                                      {.duration = 5000.0, .interval = 5000.0, .highest = 1e4});
  ASSERT_TRUE(course.limit);
  EXPECT_EQ(course.limit->node, expected->node);
  EXPECT_NEAR(course.limit->time, expected->time, 1e-4 * expected->time);
}

TEST(TemperatureCourse, EndsWhereANodeReachesTheHighest) {
  const Network network = five_nodes();
  const TemperatureCourse course = temperature_course(network, heat_of_a_held_current(network, 4.0),
                                                      {.duration = 5000.0, .interval = 1.0, .highest = 500.0});
  ASSERT_TRUE(course.highest_reached);
  EXPECT_LE(course.times.back(), *course.highest_reached);
  EXPECT_GT(course.times.back(), *course.highest_reached - 1.0);
  EXPECT_LE(course.temperatures.back().maxCoeff(), 500.0);
}

TEST(TemperatureCourse, RejectsTimesThatAreNone) {
  const Network network = five_nodes();
  const HeatAt none = [](const NodeVector& at) -> NodeVector { return NodeVector::Zero(at.size()); };
  EXPECT_EQ(
      error_text([&] { static_cast<void>(temperature_course(network, none, {.duration = 0.0, .interval = 1.0})); }),
      "duration: must be finite and > 0; got 0");
  EXPECT_EQ(
      error_text([&] { static_cast<void>(temperature_course(network, none, {.duration = 1.0, .interval = 2.0})); }),
      "interval: must be at most the duration; got 2");
}

}  // namespace
}  // namespace coilwright::thermal
