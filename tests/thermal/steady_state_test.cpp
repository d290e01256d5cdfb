#include "coilwright/thermal/steady_state.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "error_text.hpp"
#include "thermal/sample_networks.hpp"

namespace coilwright::thermal {
namespace {

TEST(SteadyState, BalancesHeatInEveryNode) {
  const Network network = five_nodes();
  const NodeVector load = uneven_load();
  const SteadyState state = steady_state(network, load);
  ASSERT_EQ(state.outcome, Outcome::settles);
  const NodeVector net = net_heat(network, five_links, load, state.temperatures);
  for (Eigen::Index i = 0; i < 5; ++i) EXPECT_NEAR(net(i), 0.0, 1e-13);  // rounding of about 5 W
  double to_ambient = 0.0;
  for (Eigen::Index i = 0; i < 5; ++i) {
    to_ambient += network.nodes()[static_cast<std::size_t>(i)].ambient_conductance * (state.temperatures(i) - 27.0);
  }
  EXPECT_NEAR(state.heat.sum() / to_ambient, 1.0, 1e-13);
}

TEST(SteadyState, OfOneCoilIsTheClosedForm) {
  // T = Ta + x R (1 + alpha (Ta - 20)) / (G - alpha x R)
  const double x = 0.72;
  const SteadyState state = steady_state(one_coil(), same_in_every_coil(one_coil(), x));
  const double expected = 31.0 + x * 3.6 * (1.0 + alpha * 11.0) / (0.037 - alpha * x * 3.6);
  EXPECT_NEAR(state.temperatures(0), expected, 1e-11);
}

TEST(SteadyState, SuperposesWhenResistanceDoesNotGrow) {
  // Without growth the chain is linear, so loads add; with copper's growth they must give more than the sum.
  NodeVector first = NodeVector::Zero(5), second = NodeVector::Zero(5);
  first(0) = 0.61;
  second(4) = 0.94;
  const auto excess = [&](const Network& network) {
    const auto rise = [&](const NodeVector& load) {
      return (steady_state(network, load).temperatures.array() - network.ambient()).eval();
    };
    return ((rise(first + second) - rise(first) - rise(second)) / rise(first + second)).maxCoeff();
  };
  // What is left at alpha = 1e-9 is alpha times the rise of about 100 K.
  EXPECT_NEAR(excess(five_nodes(1e-9)), 0.0, 2e-7);
  EXPECT_GT(excess(five_nodes()), 1e-3);  // four orders above that
}

TEST(SteadyState, RunsAwayAboveTheRunawayCurrentAndOnlyThere) {
  for (const Network& network : {one_coil(), five_nodes()}) {
    const double runaway = runaway_current(network);
    const auto outcome = [&](double current) {
      return steady_state(network, same_in_every_coil(network, current * current)).outcome;
    };
    EXPECT_EQ(outcome(runaway * (1.0 - 1e-9)), Outcome::settles);
    EXPECT_EQ(outcome(runaway * (1.0 + 1e-9)), Outcome::runaway);
    const SteadyState lost = steady_state(network, same_in_every_coil(network, 4.0 * runaway * runaway));
    EXPECT_EQ(lost.outcome, Outcome::runaway);
    EXPECT_EQ(lost.temperatures.size(), 0);
    EXPECT_EQ(lost.heat.size(), 0);
  }
}

TEST(SteadyState, RunawayCurrentOfOneCoilIsTheClosedForm) {
  EXPECT_NEAR(runaway_current(one_coil()), std::sqrt(0.037 / (alpha * 3.6)), 1e-13);
}

TEST(ContinuousCurrent, OfOneCoilIsTheClosedForm) {
  // G (Tl - Ta) = x R (1 + alpha (Tl - 20))
  const double expected = std::sqrt(0.037 * (148.0 - 31.0) / (3.6 * (1.0 + alpha * 128.0)));
  const ContinuousCurrent found = continuous_current(one_coil(), LimitedParts::coils);
  EXPECT_NEAR(found.current / expected, 1.0, 1e-12);  // as documented
  EXPECT_EQ(found.limiting_node, 0U);
}

TEST(ContinuousCurrent, PutsTheWorstWatchedNodeAtItsLimitAndNoneAbove) {
  const Network network = five_nodes();
  for (const LimitedParts watch : {LimitedParts::coils, LimitedParts::magnets, LimitedParts::everything}) {
    const ContinuousCurrent found = continuous_current(network, watch);
    // Second route: the linear solve at that current.
    const SteadyState state = steady_state(network, same_in_every_coil(network, found.current * found.current));
    ASSERT_EQ(state.outcome, Outcome::settles);
    for (std::size_t i = 0; i < 5; ++i) {
      const Node& node = network.nodes()[i];
      if (watch == LimitedParts::coils && node.kind != NodeKind::coil) continue;
      if (watch == LimitedParts::magnets && node.kind != NodeKind::magnet) continue;
      // 1e-12 of the current moves a rise of 100 K by less than 1e-9 K.
      EXPECT_LE(state.temperatures(static_cast<Eigen::Index>(i)), node.temperature_limit + 1e-9);
    }
    const double limit = network.nodes()[found.limiting_node].temperature_limit;
    EXPECT_NEAR(state.temperatures(static_cast<Eigen::Index>(found.limiting_node)), limit, 1e-9);
  }
  EXPECT_NEAR(continuous_current(network, LimitedParts::everything).current,
              std::min(continuous_current(network, LimitedParts::coils).current,
                       continuous_current(network, LimitedParts::magnets).current),
              1e-12);  // each root to 2^-42
}

// The limit is the hot spot's: at the continuous current steady_state has it there, and the mean below.
TEST(ContinuousCurrent, HoldsTheHotSpotAtItsLimit) {
  Network::Spec spec{
      .nodes = five_nodes().nodes(), .links = in_a_row(five_links), .ambient = 27.0, .temperature_coefficient = alpha};
  for (Node& node : spec.nodes)
    if (node.kind == NodeKind::coil) node.hot_spot_resistance = 3.0;
  const Network network(spec);
  const ContinuousCurrent found = continuous_current(network, LimitedParts::coils);
  const SteadyState state = steady_state(network, same_in_every_coil(network, found.current * found.current));
  const auto node = static_cast<Eigen::Index>(found.limiting_node);
  EXPECT_NEAR(state.hot_spots(node), network.nodes()[found.limiting_node].temperature_limit, 1e-9);
  EXPECT_NEAR(state.hot_spots(node), state.temperatures(node) + 3.0 * state.heat(node), 1e-9);
  EXPECT_LT(found.current, continuous_current(five_nodes(), LimitedParts::coils).current);
}

TEST(ContinuousCurrent, IsNothingWhenAmbientIsAtALimit) {
  Network::Spec spec{.nodes = {five_nodes().nodes()[0], five_nodes().nodes()[1]},
                     .links = in_a_row({0.02}),
                     .ambient = 83.0,  // above the magnet's 80
                     .temperature_coefficient = alpha};
  const ContinuousCurrent found = continuous_current(Network(spec), LimitedParts::everything);
  EXPECT_EQ(found.current, 0.0);
  EXPECT_EQ(found.limiting_node, 1U);
}

TEST(ContinuousCurrent, EndsAtTheRunawayWhenNoWatchedNodeHeatsUp) {
  const Network network({.nodes = {five_nodes().nodes()[0], five_nodes().nodes()[1]},
                         .links = in_a_row({0.0}),
                         .ambient = 22.0,
                         .temperature_coefficient = alpha});
  const ContinuousCurrent found = continuous_current(network, LimitedParts::magnets);
  EXPECT_NEAR(found.current, std::sqrt(0.041 / (alpha * 3.3)), 1e-12);
  EXPECT_EQ(found.limiting_node, 2U);  // none of the two
}

TEST(SteadyState, RejectsLoadsThatDoNotBelongToTheNetwork) {
  const Network network = five_nodes();
  EXPECT_EQ(error_text([&] { (void)steady_state(network, NodeVector::Zero(4)); }),
            "mean_square_currents: must be 5 in number; got 4");
  NodeVector load = uneven_load();
  load(3) = 0.2;
  EXPECT_EQ(error_text([&] { (void)steady_state(network, load); }),
            "mean_square_currents[3]: must be 0 for a node that is no coil; got 0.2");
  load(3) = 0.0;
  load(2) = -1.0;
  EXPECT_EQ(error_text([&] { (void)steady_state(network, load); }),
            "mean_square_currents[2]: must be finite and >= 0; got -1");
}

TEST(ContinuousCurrent, RejectsNetworksWithoutWhatIsWatched) {
  const Network magnet_only(
      {.nodes = {five_nodes().nodes()[1]}, .links = {}, .ambient = 22.0, .temperature_coefficient = alpha});
  EXPECT_EQ(error_text([&] { (void)runaway_current(magnet_only); }), "nodes: must include a coil; got none");
  EXPECT_EQ(error_text([&] { (void)continuous_current(magnet_only, LimitedParts::magnets); }),
            "nodes: must include a coil; got none");
  EXPECT_EQ(error_text([] { (void)continuous_current(one_coil(), LimitedParts::magnets); }),
            "nodes: must include a magnet; got none");
}

}  // namespace
}  // namespace coilwright::thermal
