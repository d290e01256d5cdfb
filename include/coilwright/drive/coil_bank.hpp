#pragma once

#include <Eigen/Core>

namespace coilwright::drive {

/// How the coils of a bank hang on one pair of wires.
enum class BankWiring { series, parallel };

/// The coils that one driver feeds. Sizes agree.
struct CoilBank {
  Eigen::VectorXd resistances{};  ///< of each coil at its temperature, (n), ohm; finite, > 0
  /// Self-inductances and, beside the diagonal, mutual ones with the sign of their senses, (n, n), H; symmetric and
  /// positive definite.
  Eigen::MatrixXd inductances{};
  BankWiring wiring = BankWiring::parallel;
};

/// A resistance in series with an inductance: what a driver sees.
struct Circuit {
  double resistance{};  ///< ohm; finite, > 0
  double inductance{};  ///< H; finite, > 0

  /// L/R, s.
  [[nodiscard]] double time_constant() const noexcept { return inductance / resistance; }
};

/// A bank as one circuit.
struct ReducedBank {
  Circuit circuit{};
  Eigen::VectorXd shares{};  ///< of each coil in the driver's current, (n); 1 in series, 1/n for like coils in parallel
  /// By how much the inductance that a sudden change sees is smaller than circuit.inductance, relative, >= 0. In
  /// parallel currents divide by resistance when they change slowly and by inductance when they change at once; the two
  /// agree for like coils, and in series always.
  double inductance_spread{};
};

/// In series resistances add up, and so do all self and mutual inductances. In parallel the coils share the current i
/// by their conductances, i_k = s_k i, and the inductance is that of the field energy of these currents, s.L s; at once
/// it is 1 / (1.L^-1 1), which by Thomson's theorem is the least that any division has. Source: circuit theory, u_k =
/// R_k i_k + sum_j L_kj di_j/dt. Throws std::invalid_argument naming the field, the rule and the value received.
[[nodiscard]] ReducedBank reduce(const CoilBank& bank);

}  // namespace coilwright::drive
