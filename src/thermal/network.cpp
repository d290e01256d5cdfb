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
    require(node.resistance == 0.0, field("resistance"), "0 for a magnet", node.resistance);
  }
  require(std::isfinite(node.temperature_limit), field("temperature_limit"), "finite", node.temperature_limit);
}

void check(const Network::Spec& spec) {
  const std::size_t count = spec.nodes.size();
  require_count({"nodes"}, count, 1, most_nodes);
  for (std::size_t i = 0; i < count; ++i) check_node(spec.nodes[i], i);
  require_count({"links"}, spec.links.size(), count - 1, count - 1);
  for (std::size_t i = 0; i < spec.links.size(); ++i) require_not_negative({"links", i}, spec.links[i]);
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
  for (Eigen::Index i = 0; i < count; ++i) {
    matrix(i, i) += spec.nodes[static_cast<std::size_t>(i)].ambient_conductance;
    if (i + 1 == count) break;
    const double link = spec.links[static_cast<std::size_t>(i)];
    matrix(i, i) += link;
    matrix(i + 1, i + 1) += link;
    matrix(i, i + 1) -= link;
    matrix(i + 1, i) -= link;
  }
  return matrix;
}

// Every stretch of nodes joined by links must touch ambient somewhere.
void check_paths(const Network::Spec& spec) {
  std::size_t first = 0;
  double to_ambient = 0.0;
  for (std::size_t i = 0; i < spec.nodes.size(); ++i) {
    to_ambient += spec.nodes[i].ambient_conductance;
    const bool ends = i + 1 == spec.nodes.size() || spec.links[i] == 0.0;
    if (!ends) continue;
    if (!(to_ambient > 0.0)) {
      reject({fmt::format("nodes[{}..{}].ambient_conductance", first, i)}, "> 0 in at least one of these linked nodes",
             to_ambient);
    }
    first = i + 1;
    to_ambient = 0.0;
  }
}

}  // namespace

Network::Network(Spec spec) : spec_{std::move(spec)} {
  check(spec_);
  check_paths(spec_);
  conductance_ = conductance_matrix(spec_);
}

NodeVector Network::ambient_resistance() const {
  NodeVector resistance(size());
  for (Eigen::Index i = 0; i < size(); ++i) resistance(i) = spec_.nodes[static_cast<std::size_t>(i)].resistance;
  return resistance * (1.0 + spec_.temperature_coefficient * (spec_.ambient - 20.0));
}

NodeVector Network::resistance_slope() const {
  NodeVector slope(size());
  for (Eigen::Index i = 0; i < size(); ++i) slope(i) = spec_.nodes[static_cast<std::size_t>(i)].resistance;
  return slope * spec_.temperature_coefficient;
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
    require(allowed, {"mean_square_currents", i}, "0 for a magnet", load);
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
