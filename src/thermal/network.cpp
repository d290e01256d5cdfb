#include "coilwright/thermal/network.hpp"

#include <algorithm>
#include <utility>

#include "check.hpp"

namespace coilwright::thermal {
namespace {

void check_node(const Node& node, std::size_t index) {
  const auto field = [index](std::string_view member) { return Field{"nodes", index, member}; };
  require_not_negative(field("ambient_conductance"), node.ambient_conductance);
  require_positive(field("heat_capacity"), node.heat_capacity);
  if (node.kind == NodeKind::coil) {
    require_positive(field("resistance"), node.resistance);
  } else {
    require(node.resistance == 0.0, field("resistance"), "0 for a node that is no coil", node.resistance);
  }
  require_not_negative(field("hot_spot_resistance"), node.hot_spot_resistance);
  require(std::isfinite(node.current_share), field("current_share"), "finite", node.current_share);
  require(std::isfinite(node.temperature_limit), field("temperature_limit"), "finite", node.temperature_limit);
}

void check_link(const Link& link, std::size_t index, std::size_t nodes) {
  const auto field = [index](std::string_view member) { return Field{"links", index, member}; };
  require_not_negative(field("conductance"), link.conductance);
  const std::size_t last = std::max(link.first, link.second);
  require(last < nodes, field("second"), "below the number of nodes", static_cast<double>(last));
  require(link.first != link.second, field("second"), "another node than the first", static_cast<double>(link.second));
}

void check(const Network::Spec& spec) {
  const std::size_t count = spec.nodes.size();
  require_count({"nodes"}, count, 1, most_nodes);
  for (std::size_t i = 0; i < count; ++i) check_node(spec.nodes[i], i);
  for (std::size_t i = 0; i < spec.links.size(); ++i) check_link(spec.links[i], i, count);
  require_positive({"temperature_coefficient"}, spec.temperature_coefficient);
  const double lowest = 20.0 - 1.0 / spec.temperature_coefficient;
  if (!(std::isfinite(spec.ambient) && spec.ambient > lowest)) {
    reject({"ambient"}, fmt::format("finite and above {:.6g} degC, where the resistance law ends", lowest),
           spec.ambient);
  }
}

NodeMatrix conductance_matrix(const Network::Spec& spec) {
  const auto count = static_cast<Eigen::Index>(spec.nodes.size());
  NodeMatrix matrix = NodeMatrix::Zero(count, count);
  for (Eigen::Index i = 0; i < count; ++i) matrix(i, i) = spec.nodes[static_cast<std::size_t>(i)].ambient_conductance;
  for (const Link& link : spec.links) {
    const auto i = static_cast<Eigen::Index>(link.first);
    const auto k = static_cast<Eigen::Index>(link.second);
    matrix(i, i) += link.conductance;
    matrix(k, k) += link.conductance;
    matrix(i, k) -= link.conductance;
    matrix(k, i) -= link.conductance;
  }
  return matrix;
}

// Every node must have a path to ambient: nodes that have one hand it on along their links.
void check_paths(const Network::Spec& spec) {
  std::vector<bool> cooled;
  for (const Node& node : spec.nodes) cooled.push_back(node.ambient_conductance > 0.0);
  bool spreads = true;
  while (spreads) {
    spreads = false;
    for (const Link& link : spec.links) {
      if (link.conductance == 0.0 || cooled[link.first] == cooled[link.second]) continue;
      cooled[link.first] = cooled[link.second] = true;
      spreads = true;
    }
  }
  const auto lost = std::find(cooled.begin(), cooled.end(), false);
  if (lost != cooled.end())
    reject({"nodes", static_cast<std::size_t>(lost - cooled.begin()), "ambient_conductance"},
           "> 0 in this node or in one that it is linked to", 0.0);
}

}  // namespace

Network::Network(Spec spec) : spec_{std::move(spec)} {
  check(spec_);
  check_paths(spec_);
  conductance_ = conductance_matrix(spec_);
}

NodeVector Network::ambient_resistance() const {
  return heating_resistance() * (1.0 + spec_.temperature_coefficient * (spec_.ambient - 20.0));
}

NodeVector Network::heating_resistance() const {
  NodeVector resistance(size());
  for (Eigen::Index i = 0; i < size(); ++i) {
    const Node& node = spec_.nodes[static_cast<std::size_t>(i)];
    resistance(i) = node.current_share * node.current_share * node.resistance;
  }
  return resistance;
}

NodeVector Network::resistance_slope() const {
  return heating_resistance() * spec_.temperature_coefficient;
}

NodeVector Network::hot_spots(const NodeVector& temperatures) const {
  require_one_each(*this, "temperatures", temperatures);
  NodeVector hottest = temperatures;
  for (Eigen::Index i = 0; i < size(); ++i) {
    const double own = spec_.nodes[static_cast<std::size_t>(i)].hot_spot_resistance;
    if (own > 0.0) hottest(i) += own * conductance_.row(i).dot((temperatures.array() - ambient()).matrix());
  }
  return hottest;
}

double mean_square(const DutyCycle& cycle) {
  require(std::isfinite(cycle.current), {"current"}, "finite", cycle.current);
  require(cycle.duty >= 0.0 && cycle.duty <= 1.0, {"duty"}, "from 0 to 1", cycle.duty);
  return cycle.current * cycle.current * cycle.duty;
}

NodeVector same_in_every_coil(const Network& network, double mean_square_current) {
  require_not_negative({"mean_square_current"}, mean_square_current);
  NodeVector load = NodeVector::Zero(network.size());
  for (Eigen::Index i = 0; i < network.size(); ++i) {
    if (network.nodes()[static_cast<std::size_t>(i)].kind == NodeKind::coil) load(i) = mean_square_current;
  }
  return load;
}

void require_load(const Network& network, const NodeVector& mean_square_currents) {
  require_one_each(network, "mean_square_currents", mean_square_currents);
  for (std::size_t i = 0; i < network.nodes().size(); ++i) {
    const double load = mean_square_currents(static_cast<Eigen::Index>(i));
    require_not_negative({"mean_square_currents", i}, load);
    const bool allowed = load == 0.0 || network.nodes()[i].kind == NodeKind::coil;
    require(allowed, {"mean_square_currents", i}, "0 for a node that is no coil", load);
  }
}

void require_one_each(const Network& network, std::string_view field, const NodeVector& values) {
  require_count({field}, static_cast<std::size_t>(values.size()), network.nodes().size(), network.nodes().size());
}

void require_any(const Network& network, NodeKind kind) {
  const bool found = std::any_of(network.nodes().begin(), network.nodes().end(),
                                 [kind](const Node& node) { return node.kind == kind; });
  if (found) return;
  throw std::invalid_argument(
      fmt::format("nodes: must include a {}; got none", kind == NodeKind::coil ? "coil" : "magnet"));
}

}  // namespace coilwright::thermal
