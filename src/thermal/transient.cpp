#include "coilwright/thermal/transient.hpp"

#include <cmath>
#include <cstdint>

#include <boost/math/tools/toms748_solve.hpp>

#include "check.hpp"
#include "coilwright/algebra/spectral.hpp"
#include "coilwright/thermal/steady_state.hpp"
#include "hottest_spot.hpp"

namespace coilwright::thermal {
namespace {

NodeVector capacity_roots(const Network& network) {
  NodeVector roots(network.size());
  for (Eigen::Index i = 0; i < network.size(); ++i) {
    roots(i) = std::sqrt(network.nodes()[static_cast<std::size_t>(i)].heat_capacity);
  }
  return roots;
}

// int_0^t exp(-rate s) ds, for rates of either sign and near zero.
double charged(double rate, double time) {
  return rate == 0.0 ? time : -std::expm1(-rate * time) / rate;
}

void check(const Overload& overload) {
  require_not_negative({"holding_current"}, overload.holding_current);
  const double magnitude = std::abs(overload.overload_current);
  if (!(std::isfinite(magnitude) && magnitude > overload.holding_current)) {
    reject({"overload_current"}, fmt::format("finite and above the holding current, {} A", overload.holding_current),
           overload.overload_current);
  }
}

// A time by which the limit is passed; the caller has made sure that it will be.
double time_beyond(const Transient& transient, const Network& network) {
  double time = 1.0 / transient.rates().cwiseAbs().maxCoeff();
  while (hottest_spot(network, transient.temperatures(time)).excess <= 0.0) time *= 2.0;
  return time;
}

}  // namespace

// With q = sqrt(C) (T - Ta) the chain is q' = p - S q, S symmetric: S = C^-1/2 (G - alpha x R) C^-1/2. In its
// eigenvectors each mode is one scalar equation, q_j(t) = q_j(0) exp(-r_j t) + p_j (1 - exp(-r_j t)) / r_j.
Transient::Transient(const Network& network, const Spec& spec) : ambient_{network.ambient()} {
  require_load(network, spec.mean_square_currents);
  require_one_each(network, "initial", spec.initial);
  for (std::size_t i = 0; i < network.nodes().size(); ++i) {
    const double value = spec.initial(static_cast<Eigen::Index>(i));
    require(std::isfinite(value), {"initial", i}, "finite", value);
  }
  const NodeVector roots = capacity_roots(network);
  const NodeVector inverse_roots = roots.cwiseInverse();
  NodeMatrix matrix = network.conductance();
  matrix.diagonal() -= spec.mean_square_currents.cwiseProduct(network.resistance_slope());
  matrix = (inverse_roots.asDiagonal() * matrix * inverse_roots.asDiagonal()).eval();
  const algebra::SymmetricModes modes = algebra::symmetric_modes(matrix);
  rates_ = modes.values;
  const NodeVector rise = (spec.initial.array() - ambient_).matrix();
  const NodeVector heat = spec.mean_square_currents.cwiseProduct(network.ambient_resistance());
  initial_modes_ = modes.vectors.transpose() * roots.cwiseProduct(rise);
  drive_modes_ = modes.vectors.transpose() * inverse_roots.cwiseProduct(heat);
  shapes_ = inverse_roots.asDiagonal() * modes.vectors;
}

NodeVector Transient::temperatures(double time) const {
  require_not_negative({"time"}, time);
  NodeVector modes(rates_.size());
  for (Eigen::Index j = 0; j < rates_.size(); ++j) {
    modes(j) = initial_modes_(j) * std::exp(-rates_(j) * time) + drive_modes_(j) * charged(rates_(j), time);
  }
  const NodeVector rise = shapes_ * modes;
  return (rise.array() + ambient_).matrix();
}

std::optional<TimeToLimit> time_to_limit(const Network& network, const Overload& overload) {
  check(overload);
  require_any(network, NodeKind::coil);
  const auto squared = [](double current) { return current * current; };
  const SteadyState before = steady_state(network, same_in_every_coil(network, squared(overload.holding_current)));
  require(before.outcome == Outcome::settles, {"holding_current"}, "below the runaway current",
          overload.holding_current);
  const HottestSpot held = hottest_spot(network, before.temperatures);
  if (held.excess >= 0.0) return TimeToLimit{.time = 0.0, .node = held.node};

  const NodeVector load = same_in_every_coil(network, squared(overload.overload_current));
  const SteadyState after = steady_state(network, load);
  if (after.outcome == Outcome::settles && hottest_spot(network, after.temperatures).excess <= 0.0) return std::nullopt;

  const Transient transient(network, {.mean_square_currents = load, .initial = before.temperatures});
  const auto excess = [&](double time) { return hottest_spot(network, transient.temperatures(time)).excess; };
  std::uintmax_t steps = 200;
  const boost::math::tools::eps_tolerance<double> close_enough(32);  // 2^-32 = 2e-10
  const auto bracket =
      boost::math::tools::toms748_solve(excess, 0.0, time_beyond(transient, network), close_enough, steps);
  const double time = 0.5 * (bracket.first + bracket.second);
  return TimeToLimit{.time = time, .node = hottest_spot(network, transient.temperatures(time)).node};
}

}  // namespace coilwright::thermal
