#include "coilwright/thermal/steady_state.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <Eigen/Cholesky>

#include <boost/math/tools/toms748_solve.hpp>

#include "check.hpp"
#include "coilwright/algebra/spectral.hpp"

namespace coilwright::thermal {
namespace {

// The network under the same mean square current x in every coil. Only coils make heat, so everything follows from a
// problem as small as their number: with Z the rises of all nodes per heat in each coil (columns of G^-1), B =
// diag(sqrt(alpha R)) over the coils and K = B Z_cc B = V diag(lambda) V^T, heat made at ambient growing as 1 / (1 - x
// lambda) in each mode, rises are x Z B V diag(1 / (1 - x lambda)) V^T B 1 (1 + alpha (Ta - 20)) / alpha. The runaway
// is x = 1 / lambda_max.
struct Modes {
  NodeVector growths;  // lambda, 1/A^2, ascending; one a coil
  NodeMatrix rises;    // (nodes, coils), of the hot spots per x / (1 - x lambda), K/A^2
  double runaway{};    // x, A^2
};

std::vector<Eigen::Index> coils_of(const Network& network) {
  std::vector<Eigen::Index> coils;
  for (Eigen::Index i = 0; i < network.size(); ++i)
    if (network.nodes()[static_cast<std::size_t>(i)].kind == NodeKind::coil) coils.push_back(i);
  return coils;
}

Modes modes_of(const Network& network) {
  require_any(network, NodeKind::coil);
  const std::vector<Eigen::Index> coils = coils_of(network);
  const auto count = static_cast<Eigen::Index>(coils.size());
  const NodeVector slopes = network.resistance_slope();
  NodeMatrix heating = NodeMatrix::Zero(network.size(), count);  // B, over all nodes
  for (Eigen::Index k = 0; k < count; ++k) heating(coils[k], k) = std::sqrt(slopes(coils[k]));
  NodeMatrix rises = Eigen::LLT<NodeMatrix>(network.conductance()).solve(heating);  // Z B
  const NodeMatrix coupling = heating.transpose() * rises;
  const algebra::SymmetricModes modes = algebra::symmetric_modes(coupling);
  for (Eigen::Index k = 0; k < count; ++k)
    rises.row(coils[k]) += network.nodes()[static_cast<std::size_t>(coils[k])].hot_spot_resistance *
                           heating(coils[k], k) * NodeMatrix::Identity(count, count).row(k);
  const double alpha = network.temperature_coefficient();
  const NodeVector drive = modes.vectors.transpose() * heating.colwise().sum().transpose() *
                           ((1.0 + alpha * (network.ambient() - 20.0)) / alpha);
  return {.growths = modes.values,
          .rises = rises * modes.vectors * drive.asDiagonal(),
          .runaway = 1.0 / modes.values(count - 1)};
}

bool is_limited(const Node& node, LimitedParts parts) {
  switch (parts) {
    case LimitedParts::coils:
      return node.kind == NodeKind::coil;
    case LimitedParts::magnets:
      return node.kind == NodeKind::magnet;
    case LimitedParts::everything:
      break;
  }
  return node.kind != NodeKind::silicone;
}

struct Hottest {
  double excess{};  // temperature above the limit, K; the largest over the limited nodes
  std::size_t node{};
};

Hottest hottest(const Network& network, const Modes& modes, LimitedParts parts, double mean_square_current) {
  const NodeVector amplitudes = (mean_square_current / (1.0 - mean_square_current * modes.growths.array())).matrix();
  const NodeVector rises = modes.rises * amplitudes;
  Hottest worst{.excess = -std::numeric_limits<double>::infinity(), .node = network.nodes().size()};
  for (std::size_t i = 0; i < network.nodes().size(); ++i) {
    const Node& node = network.nodes()[i];
    if (!is_limited(node, parts)) continue;
    const double excess = network.ambient() + rises(static_cast<Eigen::Index>(i)) - node.temperature_limit;
    if (excess > worst.excess) worst = {.excess = excess, .node = i};
  }
  return worst;
}

}  // namespace

SteadyState steady_state(const Network& network, const NodeVector& mean_square_currents) {
  require_load(network, mean_square_currents);
  const NodeVector growth = mean_square_currents.cwiseProduct(network.resistance_slope());
  const NodeVector heat = mean_square_currents.cwiseProduct(network.ambient_resistance());
  NodeMatrix matrix = network.conductance();
  matrix.diagonal() -= growth;
  const Eigen::LLT<NodeMatrix> factor(matrix);
  if (factor.info() != Eigen::Success)
    return {.outcome = Outcome::runaway, .temperatures = {}, .hot_spots = {}, .heat = {}};
  const NodeVector rise = factor.solve(heat);
  NodeVector temperatures = (rise.array() + network.ambient()).matrix();
  NodeVector hot_spots = network.hot_spots(temperatures);
  return {.outcome = Outcome::settles,
          .temperatures = std::move(temperatures),
          .hot_spots = std::move(hot_spots),
          .heat = heat + growth.cwiseProduct(rise)};
}

double runaway_current(const Network& network) {
  return std::sqrt(modes_of(network).runaway);
}

namespace {

ContinuousCurrent largest_current(const Network& network, const Modes& modes, LimitedParts parts) {
  const auto excess = [&](double share) { return hottest(network, modes, parts, share * modes.runaway).excess; };
  const Hottest cold = hottest(network, modes, parts, 0.0);
  if (cold.excess >= 0.0) return {.current = 0.0, .limiting_node = cold.node};
  constexpr double nearly_all = 1.0 - 1e-12;  // at the runaway itself temperatures are infinite
  const double last = excess(nearly_all);
  if (last <= 0.0) return {.current = std::sqrt(modes.runaway), .limiting_node = network.nodes().size()};
  std::uintmax_t steps = 200;
  const boost::math::tools::eps_tolerance<double> close_enough(42);  // 2^-42 = 2e-13
  const auto bracket =
      boost::math::tools::toms748_solve(excess, 0.0, nearly_all, cold.excess, last, close_enough, steps);
  const double mean_square_current = 0.5 * (bracket.first + bracket.second) * modes.runaway;
  return {.current = std::sqrt(mean_square_current),
          .limiting_node = hottest(network, modes, parts, mean_square_current).node};
}

}  // namespace

ContinuousCurrent continuous_current(const Network& network, LimitedParts parts) {
  const Modes modes = modes_of(network);
  if (parts == LimitedParts::magnets) require_any(network, NodeKind::magnet);
  return largest_current(network, modes, parts);
}

CurrentLimits current_limits(const Network& network) {
  const Modes modes = modes_of(network);
  return {.coils = largest_current(network, modes, LimitedParts::coils).current,
          .magnets = largest_current(network, modes, LimitedParts::magnets).current,
          .runaway = std::sqrt(modes.runaway)};
}

}  // namespace coilwright::thermal
