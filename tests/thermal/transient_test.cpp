#include "coilwright/thermal/transient.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "coilwright/thermal/steady_state.hpp"
#include "error_text.hpp"
#include "thermal/sample_networks.hpp"

namespace coilwright::thermal {
namespace {

NodeVector uneven_start() {
  NodeVector start(5);
  start << 31.0, 64.0, 22.0, 18.0, 45.0;
  return start;
}

// Classical Runge-Kutta with a fixed step on the equations written out node by node.
NodeVector integrate(const Network& network, const NodeVector& load, NodeVector temperatures, double time, int steps) {
  NodeVector capacity(network.size());
  for (Eigen::Index i = 0; i < network.size(); ++i) {
    capacity(i) = network.nodes()[static_cast<std::size_t>(i)].heat_capacity;
  }
  const auto rate = [&](const NodeVector& at) -> NodeVector {
    return net_heat(network, five_links, load, at).cwiseQuotient(capacity);
  };
  const double h = time / steps;
  for (int i = 0; i < steps; ++i) {
    const NodeVector k1 = rate(temperatures), k2 = rate(temperatures + 0.5 * h * k1);
    const NodeVector k3 = rate(temperatures + 0.5 * h * k2), k4 = rate(temperatures + h * k3);
    temperatures += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
  }
  return temperatures;
}

TEST(Transient, AgreesWithAFixedStepIntegration) {
  const Network network = five_nodes();
  for (const double scale : {1.0, 6.0}) {  // settling, and a runaway
    const NodeVector load = scale * uneven_load();
    const Transient transient(network, {.mean_square_currents = load, .initial = uneven_start()});
    EXPECT_EQ(transient.rates()(0) < 0.0, scale > 2.0);
    const NodeVector exact = transient.temperatures(90.0);
    const NodeVector stepped = integrate(network, load, uneven_start(), 90.0, 900);
    // Steps of 0.1 s against a fastest mode of 0.02 1/s: error (0.002)^4, far under rounding over 900 steps.
    for (Eigen::Index i = 0; i < 5; ++i) EXPECT_NEAR(exact(i) / stepped(i), 1.0, 1e-11);
  }
}

TEST(Transient, StartsAtItsStartAndEndsInTheSteadyState) {
  const Network network = five_nodes();
  const Transient transient(network, {.mean_square_currents = uneven_load(), .initial = uneven_start()});
  const NodeVector end = steady_state(network, uneven_load()).temperatures;
  const double slowest = 1.0 / transient.rates()(0);
  for (Eigen::Index i = 0; i < 5; ++i) {
    EXPECT_NEAR(transient.temperatures(0.0)(i), uneven_start()(i), 1e-12);
    EXPECT_NEAR(transient.temperatures(40.0 * slowest)(i), end(i), 1e-10);  // exp(-40) = 4e-18 of 100 K, and rounding
  }
}

TEST(Transient, OfOneCoilIsAnExponential) {
  const Network network = one_coil();
  const double x = 0.66, time = 57.0;
  const double rate = (0.037 - alpha * x * 3.6) / 11.3;
  const double end = 31.0 + x * 3.6 * (1.0 + alpha * 11.0) / (0.037 - alpha * x * 3.6);
  const Transient transient(network,
                            {.mean_square_currents = same_in_every_coil(network, x), .initial = NodeVector{{44.0}}});
  EXPECT_NEAR(transient.rates()(0), rate, 1e-15);
  EXPECT_NEAR(transient.temperatures(time)(0), end + (44.0 - end) * std::exp(-rate * time), 1e-11);
}

TEST(TimeToLimit, OfOneColdCoilIsTheClosedForm) {
  for (const double current : {1.3, 1.9}) {  // the second is beyond the runaway at 1.62 A
    const double x = current * current;
    const double rate = (0.037 - alpha * x * 3.6) / 11.3;
    const double end = 31.0 + x * 3.6 * (1.0 + alpha * 11.0) / (0.037 - alpha * x * 3.6);
    const double expected = std::log((31.0 - end) / (148.0 - end)) / rate;
    const auto found = time_to_limit(one_coil(), {.holding_current = 0.0, .overload_current = current});
    ASSERT_TRUE(found.has_value());
    EXPECT_NEAR(found->time / expected, 1.0, 1e-9);  // as documented
    EXPECT_EQ(found->node, 0U);
  }
}

TEST(TimeToLimit, IsWhenTheFirstNodeOfAChainArrives) {
  const Network network = five_nodes();
  const double holding = 0.35, overload = 1.3;
  const auto found = time_to_limit(network, {.holding_current = holding, .overload_current = overload});
  ASSERT_TRUE(found.has_value());
  const NodeVector start = steady_state(network, same_in_every_coil(network, holding * holding)).temperatures;
  const NodeVector then =
      integrate(network, same_in_every_coil(network, overload * overload), start, found->time, 2000);
  const auto limit = [&](std::size_t i) { return network.nodes()[i].temperature_limit; };
  for (std::size_t i = 0; i < 5; ++i) EXPECT_LE(then(static_cast<Eigen::Index>(i)), limit(i) + 1e-6);
  EXPECT_NEAR(then(static_cast<Eigen::Index>(found->node)), limit(found->node), 1e-6);  // 1e-9 of the time, 2 K/s
}

TEST(TimeToLimit, KnowsNeverAndAlready) {
  const Network network = five_nodes();
  const double most = continuous_current(network, LimitedParts::everything).current;
  EXPECT_FALSE(time_to_limit(network, {.holding_current = 0.1, .overload_current = 0.999 * most}).has_value());
  EXPECT_TRUE(time_to_limit(network, {.holding_current = 0.1, .overload_current = 1.001 * most}).has_value());
  const auto already = time_to_limit(network, {.holding_current = 1.01 * most, .overload_current = 1.2 * most});
  ASSERT_TRUE(already.has_value());
  EXPECT_EQ(already->time, 0.0);
}

TEST(Transient, RejectsInputsOutsideTheirRules) {
  const Network network = five_nodes();
  EXPECT_EQ(
      error_text([&] { Transient(network, {.mean_square_currents = uneven_load(), .initial = NodeVector::Zero(2)}); }),
      "initial: must be 5 in number; got 2");
  NodeVector start = uneven_start();
  start(1) = NAN;
  EXPECT_EQ(error_text([&] { Transient(network, {.mean_square_currents = uneven_load(), .initial = start}); }),
            "initial[1]: must be finite; got nan");
  const Transient transient(network, {.mean_square_currents = uneven_load(), .initial = uneven_start()});
  EXPECT_EQ(error_text([&] { (void)transient.temperatures(-1.0); }), "time: must be finite and >= 0; got -1");
}

TEST(TimeToLimit, RejectsOverloadsThatAreNone) {
  const auto text = [](const Overload& overload) {
    return error_text([&] { (void)time_to_limit(one_coil(), overload); });
  };
  EXPECT_EQ(text({.holding_current = -0.2, .overload_current = 1.0}),
            "holding_current: must be finite and >= 0; got -0.2");
  EXPECT_EQ(text({.holding_current = 0.8, .overload_current = 0.7}),
            "overload_current: must be finite and above the holding current, 0.8 A; got 0.7");
  EXPECT_EQ(text({.holding_current = 1.8, .overload_current = 2.0}),
            "holding_current: must be below the runaway current; got 1.8");
}

}  // namespace
}  // namespace coilwright::thermal
