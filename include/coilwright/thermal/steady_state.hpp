#pragma once

#include <algorithm>
#include <cstddef>

#include "coilwright/thermal/network.hpp"

namespace coilwright::thermal {

enum class Outcome {
  settles,  ///< temperatures reach a finite steady state
  runaway   ///< heat grows faster with temperature than its removal: there is no steady state
};

/// Where temperatures end under a constant load.
struct SteadyState {
  Outcome outcome{};
  NodeVector temperatures;  ///< mean of each node, degC; empty after a runaway
  NodeVector hot_spots;     ///< of the hottest place in each node, degC; empty after a runaway
  NodeVector heat;          ///< made in each node at those temperatures, W; empty after a runaway
};

/// Steady state under mean square currents (A^2, >= 0, a value a node; entries of other nodes than coils must be 0).
///
/// Heat is affine in temperature, so this is one linear system (G - alpha diag(x R)) (T - Ta) = x R (1 + alpha (Ta -
/// 20)). It has a stable steady state exactly when its matrix is positive definite, which the Cholesky factor tells.
/// Throws std::invalid_argument naming the field, the rule and the value received.
[[nodiscard]] SteadyState steady_state(const Network& network, const NodeVector& mean_square_currents);

/// The steady current at which a chain stops having a steady state, A, with the same current in every coil: the root of
/// the largest x for which G - alpha diag(x R) is positive semidefinite (a generalised eigenvalue). Throws
/// std::invalid_argument for a network without coils.
[[nodiscard]] double runaway_current(const Network& network);

/// The nodes whose temperature limits count.
enum class LimitedParts { coils, magnets, everything };

/// The largest steady current and what sets it.
struct ContinuousCurrent {
  /// A. 0 when ambient itself is at a limit; the runaway current when no limited node reaches its limit below that.
  double current{};
  /// Index of the node at its limit; the number of nodes when it is the runaway that limits.
  std::size_t limiting_node{};
};

/// The largest steady current (the same in every coil) at which the hot spot of every limited node stays at or under
/// its temperature_limit. Temperatures rise with current, so there is exactly one: the root of their modal sum below
/// the runaway current, to 1e-12 relative. Throws std::invalid_argument for a network without coils, or
/// LimitedParts::magnets without magnets.
[[nodiscard]] ContinuousCurrent continuous_current(const Network& network, LimitedParts parts);

/// What limits the current of a network, A.
struct CurrentLimits {
  double coils{};    ///< continuous_current for coils
  double magnets{};  ///< likewise for magnets; the runaway current where there are none
  double runaway{};  ///< runaway_current

  /// What neither coils nor magnets forbid for good.
  [[nodiscard]] double for_good() const noexcept { return std::min(coils, magnets); }
};

/// All three for the work of one. Throws std::invalid_argument for a network without coils.
[[nodiscard]] CurrentLimits current_limits(const Network& network);

}  // namespace coilwright::thermal
