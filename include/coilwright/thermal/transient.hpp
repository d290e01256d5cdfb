#pragma once

#include <cstddef>
#include <optional>

#include "coilwright/thermal/network.hpp"

namespace coilwright::thermal {

/// Temperatures over time under a constant load, exact for the lumped network (modal sum, no time steps). Also valid in
/// a runaway, where modes grow exponentially. Immutable.
class Transient {
 public:
  /// Inputs of a Transient.
  struct Spec {
    NodeVector mean_square_currents;  ///< A^2, >= 0, a value a node; 0 in other nodes
    NodeVector initial;               ///< temperatures at time 0, degC, a value a node; finite
  };
  /// Prepares the modes. Throws std::invalid_argument naming the field, the rule and the value received.
  Transient(const Network& network, const Spec& spec);

  /// Temperatures at `time` (s, finite, >= 0), degC. Throws std::invalid_argument for another time.
  [[nodiscard]] NodeVector temperatures(double time) const;
  /// Decay rates of the modes, 1/s, ascending; a negative one grows (runaway). Time constants are the inverses.
  [[nodiscard]] const NodeVector& rates() const noexcept { return rates_; }

 private:
  double ambient_;
  NodeVector rates_;
  NodeVector initial_modes_;  // of T - ambient, scaled by sqrt(heat capacity)
  NodeVector drive_modes_;
  NodeMatrix shapes_;
};

/// A short overload on top of a steady load; the same current in every coil.
struct Overload {
  double holding_current{};   ///< until time 0, long enough to be in steady state, A; >= 0
  double overload_current{};  ///< from time 0 on, A; finite, magnitude above the holding current's
};

/// The time at which the first node reaches its temperature limit, and that node.
struct TimeToLimit {
  double time{};  ///< s; 0 when the holding current alone exceeds a limit
  std::size_t node{};
};

/// Time from the start of an overload until the first hot spot (of a coil or magnet) reaches its limit, to 1e-9
/// relative; absent if none does. Temperatures only rise in an overload, so there is one crossing. Throws
/// std::invalid_argument for currents outside their rule, or a holding current that has no steady state.
[[nodiscard]] std::optional<TimeToLimit> time_to_limit(const Network& network, const Overload& overload);

}  // namespace coilwright::thermal
