#include "coilwright/thermal/steady_state.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <boost/math/tools/toms748_solve.hpp>

#include "check.hpp"

namespace coilwright::thermal {
namespace {

// The chain under the same mean square current x in every coil, in modes: with A v = lambda G v and v^T G v = 1,
// (G - x A)^-1 = sum v v^T / (1 - x lambda), so temperatures cost O(n) per x and the runaway is x = 1 / lambda_max.
struct Modes {
  NodeVector growths;  // lambda, 1/A^2, ascending
  NodeMatrix rises;    // column j: v_j (v_j . R(Ta)), K/A^2
  double runaway{};    // x, A^2
};

Modes modes_of(const Network& network) {
  require_any(network, NodeKind::coil);
  const NodeMatrix growth = network.resistance_slope().asDiagonal();
  const Eigen::GeneralizedSelfAdjointEigenSolver<NodeMatrix> solver(growth, network.conductance());
  const NodeVector drive = solver.eigenvectors().transpose() * network.ambient_resistance();
  return {.growths = solver.eigenvalues(),
          .rises = solver.eigenvectors() * drive.asDiagonal(),
          .runaway = 1.0 / solver.eigenvalues()(network.size() - 1)};
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
  return true;
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
  if (factor.info() != Eigen::Success) return {.outcome = Outcome::runaway, .temperatures = {}, .heat = {}};
  const NodeVector rise = factor.solve(heat);
  return {.outcome = Outcome::settles,
          .temperatures = (rise.array() + network.ambient()).matrix(),
          .heat = heat + growth.cwiseProduct(rise)};
}

double runaway_current(const Network& network) {
  return std::sqrt(modes_of(network).runaway);
}

ContinuousCurrent continuous_current(const Network& network, LimitedParts parts) {
  const Modes modes = modes_of(network);
  if (parts == LimitedParts::magnets) require_any(network, NodeKind::magnet);
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

}  // namespace coilwright::thermal
