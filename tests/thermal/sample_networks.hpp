#pragma once

#include <vector>

#include "coilwright/thermal/chain.hpp"
#include "coilwright/thermal/limits.hpp"
#include "coilwright/thermal/network.hpp"

namespace coilwright::thermal {

/// Copper, 1/K.
inline constexpr double alpha = 3.93e-3;

/// Conductances between each node and the next, W/K.
inline std::vector<Link> in_a_row(const std::vector<double>& conductances) {
  std::vector<Link> links;
  for (std::size_t i = 0; i < conductances.size(); ++i)
    links.push_back({.first = i, .second = i + 1, .conductance = conductances[i]});
  return links;
}

/// Coil, magnet, coil, magnet, coil: every number different.
inline Network five_nodes(double temperature_coefficient = alpha) {
  const auto coil = [](double conductance, double capacity, double resistance, double limit) {
    return Node{.kind = NodeKind::coil,
                .ambient_conductance = conductance,
                .heat_capacity = capacity,
                .resistance = resistance,
                .temperature_limit = limit};
  };
  const auto magnet = [](double conductance, double capacity, double limit) {
    return Node{.kind = NodeKind::magnet,
                .ambient_conductance = conductance,
                .heat_capacity = capacity,
                .resistance = 0.0,
                .temperature_limit = limit};
  };
  return Network({.nodes = {coil(0.041, 8.1, 3.3, 155.0), magnet(0.013, 6.7, 80.0), coil(0.023, 9.4, 4.2, 140.0),
                            magnet(0.017, 5.2, 95.0), coil(0.052, 7.7, 2.6, 155.0)},
                  .links = in_a_row({0.031, 0.012, 0.044, 0.019}),
                  .ambient = 27.0,
                  .temperature_coefficient = temperature_coefficient});
}

/// Mean square currents, A^2: different in each of its coils.
inline NodeVector uneven_load() {
  NodeVector load(5);
  load << 0.61, 0.0, 0.37, 0.0, 0.94;
  return load;
}

/// One coil on its own.
inline Network one_coil() {
  return Network({.nodes = {{.kind = NodeKind::coil,
                             .ambient_conductance = 0.037,
                             .heat_capacity = 11.3,
                             .resistance = 3.6,
                             .temperature_limit = 148.0}},
                  .links = {},
                  .ambient = 31.0,
                  .temperature_coefficient = alpha});
}

/// Heat that node i takes up at these temperatures, W: what the network's equations say, written out node by node.
inline NodeVector net_heat(const Network& network, const std::vector<double>& links, const NodeVector& mean_square,
                           const NodeVector& temperatures) {
  NodeVector net(network.size());
  for (Eigen::Index i = 0; i < network.size(); ++i) {
    const Node& node = network.nodes()[static_cast<std::size_t>(i)];
    net(i) = mean_square(i) * node.resistance * (1.0 + network.temperature_coefficient() * (temperatures(i) - 20.0)) -
             node.ambient_conductance * (temperatures(i) - network.ambient());
    if (i > 0) net(i) += links[static_cast<std::size_t>(i - 1)] * (temperatures(i - 1) - temperatures(i));
    if (i + 1 < network.size()) net(i) += links[static_cast<std::size_t>(i)] * (temperatures(i + 1) - temperatures(i));
  }
  return net;
}

/// Links of five_nodes, for net_heat.
inline const std::vector<double> five_links{0.031, 0.012, 0.044, 0.019};

/// The prototype finger of the paper (Tables I and II): coil, magnet, coil in silicone of 22 mm by 24 mm.
inline HeatChain prototype_finger() {
  constexpr double silicone = 1130.0 * 1300.0;
  const HeatSegment rear{.kind = NodeKind::coil,
                         .core_length = 12e-3,
                         .core_radius = 9.5e-3,
                         .bore_radius = 3e-3,
                         .core_conductivity = 0.55,
                         .core_heat_capacity = 7.8,
                         .wall = 0.3e-3,
                         .solid_end = 20e-3,
                         .resistance = 3.76,
                         .temperature_limit = class_f_enamel_limit};
  HeatSegment tip = rear;
  tip.solid_end = 8.6e-3;
  const HeatSegment magnet{.kind = NodeKind::magnet,
                           .core_length = 6e-3,
                           .core_radius = 10e-3,
                           .bore_radius = 0.0,
                           .core_conductivity = 9.0,
                           .core_heat_capacity = 6.5,
                           .wall = 0.6e-3,
                           .solid_end = 0.0,
                           .resistance = 0.0,
                           .temperature_limit = n_grade_magnet_limit};
  return {.width = 22e-3,
          .height = 24e-3,
          .hinge_layer = 2.5e-3,
          .axis_offset = 11.5e-3,
          .heat_transfer = 50.0,
          .silicone_conductivity = 0.2,
          .silicone_heat_capacity = silicone,
          .ambient = 25.0,
          .temperature_coefficient = alpha,
          .segments = {rear, magnet, tip},
          .joint_angles = {0.0, 0.0}};
}

}  // namespace coilwright::thermal
