#pragma once

#include <algorithm>
#include <cstddef>

#include "coilwright/thermal/network.hpp"

namespace coilwright::thermal {

enum class Outcome {
  settles,  ///< temperatures reach a finite steady state
  runaway   ///< heat grows faster with temperature than its removal: there is no steady state
};

/// The final temperatures under a constant load.
struct SteadyState {
  Outcome outcome{};
  NodeVector temperatures;  ///< mean of each node, degC; empty after a runaway
  NodeVector hot_spots;     ///< of the hottest place in each node, degC; empty after a runaway
  NodeVector heat;          ///< made in each node at those temperatures, W; empty after a runaway
};

/// Steady state under mean square currents (A^2, >= 0, one per node; entries of nodes other than coils must be 0).
///
/// Heat is affine in temperature, so this is one linear system (G - alpha diag(x R)) (T - Ta) = x R (1 + alpha (Ta -
/// 20)). It has a stable steady state exactly if its matrix is positive definite, which the Cholesky factor shows.
/// Throws std::invalid_argument naming the field, the rule and the value received.
[[nodiscard]] SteadyState steady_state(const Network& network, const NodeVector& mean_square_currents);

/// The smallest steady current without a steady state, A, with the same current in every coil: the root of the largest
/// x for which G - alpha diag(x R) is positive semidefinite (a generalised eigenvalue). Throws std::invalid_argument
/// for a network without coils.
[[nodiscard]] double runaway_current(const Network& network);

/// The nodes whose temperature limits count.
enum class LimitedParts { coils, magnets, everything };

/// The largest steady current, and the part that limits it.
struct ContinuousCurrent {
  /// The current, A: 0 if ambient itself is at a limit, and the runaway current if no limited node reaches its limit
  /// below that.
  double current{};
  /// Index of the node at its limit; the number of nodes if the runaway limits the current.
  std::size_t limiting_node{};
};

/// The largest steady current (the same in every coil) at which the hot spot of every limited node stays at or under
/// its temperature_limit. Temperatures rise with current, so there is exactly one: the root of their modal sum below
/// the runaway current, to 1e-12 relative. Throws std::invalid_argument for a network without coils, or
/// LimitedParts::magnets without magnets.
[[nodiscard]] ContinuousCurrent continuous_current(const Network& network, LimitedParts parts);

/// The current limits of a network, A.
struct CurrentLimits {
  double coils{};    ///< continuous_current for coils
  double magnets{};  ///< continuous_current for magnets; the runaway current without magnets
  double runaway{};  ///< runaway_current

  /// The largest current that coils and magnets bear for good.
  [[nodiscard]] double for_good() const noexcept { return std::min(coils, magnets); }
};

/// Computes all three limits at the cost of one. Throws std::invalid_argument for a network without coils.
[[nodiscard]] CurrentLimits current_limits(const Network& network);

}  // namespace coilwright::thermal
