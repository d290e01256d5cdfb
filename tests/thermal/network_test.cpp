#include "coilwright/thermal/network.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "error_text.hpp"
#include "thermal/sample_networks.hpp"

namespace coilwright::thermal {
namespace {

Network::Spec two_nodes() {
  return {.nodes = {{.kind = NodeKind::coil,
                     .ambient_conductance = 0.03,
                     .heat_capacity = 9.0,
                     .resistance = 3.1,
                     .temperature_limit = 150.0},
                    {.kind = NodeKind::magnet,
                     .ambient_conductance = 0.02,
                     .heat_capacity = 7.0,
                     .resistance = 0.0,
                     .temperature_limit = 80.0}},
          .links = in_a_row({0.05}),
          .ambient = 24.0,
          .temperature_coefficient = alpha};
}

TEST(Network, HeatLeavingIsWhatItsLinksAndSurfacesCarry) {
  const Network network = five_nodes();
  NodeVector temperatures(5);
  temperatures << 81.0, 44.0, 97.0, 36.0, 62.0;
  const NodeVector rise = (temperatures.array() - network.ambient()).matrix();
  const NodeVector leaving = network.conductance() * rise;
  const NodeVector expected = -net_heat(network, five_links, NodeVector::Zero(5), temperatures);
  for (Eigen::Index i = 0; i < 5; ++i) EXPECT_NEAR(leaving(i), expected(i), 1e-14);  // rounding of about 5 W
}

TEST(Network, HotSpotsStandAboveTheMeanByTheHeatThatLeaves) {
  Network::Spec spec = two_nodes();
  spec.nodes[0].hot_spot_resistance = 4.0;
  NodeVector temperatures(2);
  temperatures << 84.0, 54.0;
  // 0.03 60 + 0.05 30 = 3.3 W leave the coil.
  EXPECT_NEAR(Network(spec).hot_spots(temperatures)(0), 84.0 + 4.0 * 3.3, 1e-12);
  EXPECT_EQ(Network(spec).hot_spots(temperatures)(1), 54.0);
}

TEST(Network, ResistancesAreThoseOfTheCoilsAtAmbient) {
  const Network network = five_nodes();
  EXPECT_NEAR(network.ambient_resistance()(2), 4.2 * (1.0 + alpha * 7.0), 1e-14);
  EXPECT_NEAR(network.resistance_slope()(4), 2.6 * alpha, 1e-16);
  EXPECT_EQ(network.ambient_resistance()(1), 0.0);
}

TEST(Network, DutyScalesTheMeanSquareOnce) {
  EXPECT_DOUBLE_EQ(mean_square({.current = 1.4, .duty = 0.35}), 1.4 * 1.4 * 0.35);
  EXPECT_DOUBLE_EQ(mean_square({.current = -1.4, .duty = 0.35}), mean_square({.current = 1.4, .duty = 0.35}));
  EXPECT_EQ(error_text([] { (void)mean_square({.current = 1.4, .duty = 1.2}); }), "duty: must be from 0 to 1; got 1.2");
  EXPECT_EQ(error_text([] { (void)mean_square({.current = NAN, .duty = 0.5}); }), "current: must be finite; got nan");
}

TEST(Network, LoadsEveryCoilAndNoMagnet) {
  const NodeVector load = same_in_every_coil(five_nodes(), 0.83);
  NodeVector expected(5);
  expected << 0.83, 0.0, 0.83, 0.0, 0.83;
  EXPECT_EQ(load, expected);
  EXPECT_EQ(error_text([] { (void)same_in_every_coil(five_nodes(), -0.1); }),
            "mean_square_current: must be finite and >= 0; got -0.1");
}

TEST(Network, RejectsNodesOutsideTheirRules) {
  const auto text = [](auto change) {
    Network::Spec spec = two_nodes();
    change(spec);
    return error_text([&] { Network{spec}; });
  };
  EXPECT_EQ(text([](auto& s) { s.nodes[1].ambient_conductance = -0.1; }),
            "nodes[1].ambient_conductance: must be finite and >= 0; got -0.1");
  EXPECT_EQ(text([](auto& s) { s.nodes[0].heat_capacity = 0.0; }),
            "nodes[0].heat_capacity: must be finite and > 0; got 0");
  EXPECT_EQ(text([](auto& s) { s.nodes[0].resistance = 0.0; }), "nodes[0].resistance: must be finite and > 0; got 0");
  EXPECT_EQ(text([](auto& s) { s.nodes[1].resistance = 2.0; }),
            "nodes[1].resistance: must be 0 for a node that is no coil; got 2");
  EXPECT_EQ(text([](auto& s) { s.nodes[1].temperature_limit = INFINITY; }),
            "nodes[1].temperature_limit: must be finite; got inf");
}

TEST(Network, RejectsChainsOutsideTheirRules) {
  const auto text = [](auto change) {
    Network::Spec spec = two_nodes();
    change(spec);
    return error_text([&] { Network{spec}; });
  };
  EXPECT_EQ(text([](auto& s) { s.nodes.clear(); }), "nodes: must be 1 to 40 in number; got 0");
  EXPECT_EQ(text([](auto& s) { s.nodes.resize(41, s.nodes[0]); }), "nodes: must be 1 to 40 in number; got 41");
  EXPECT_EQ(text([](auto& s) { s.nodes[0].hot_spot_resistance = -1.0; }),
            "nodes[0].hot_spot_resistance: must be finite and >= 0; got -1");
  EXPECT_EQ(text([](auto& s) { s.links[0].second = 2; }), "links[0].second: must be below the number of nodes; got 2");
  EXPECT_EQ(text([](auto& s) { s.links[0].second = 0; }),
            "links[0].second: must be another node than the first; got 0");
  EXPECT_EQ(text([](auto& s) { s.links[0].conductance = -1.0; }),
            "links[0].conductance: must be finite and >= 0; got -1");
  EXPECT_EQ(text([](auto& s) { s.temperature_coefficient = 0.0; }),
            "temperature_coefficient: must be finite and > 0; got 0");
  EXPECT_EQ(text([](auto& s) { s.ambient = -240.0; }),
            "ambient: must be finite and above -234.453 degC, where the resistance law ends; got -240");
}

TEST(Network, RejectsNodesWithoutAPathToAmbient) {
  Network::Spec spec = two_nodes();
  spec.nodes[0].ambient_conductance = 0.0;
  EXPECT_NO_THROW(Network{spec});  // through its neighbour
  spec.links[0].conductance = 0.0;
  EXPECT_EQ(error_text([&] { Network{spec}; }),
            "nodes[0].ambient_conductance: must be > 0 in this node or in one that it is linked to; got 0");
}

}  // namespace
}  // namespace coilwright::thermal
