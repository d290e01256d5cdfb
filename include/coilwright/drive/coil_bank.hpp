#pragma once

#include <Eigen/Core>
#include <array>
#include <string_view>

namespace coilwright::drive {

/// Connection of the coils of a bank to one pair of wires.
enum class BankWiring { parallel, series };
/// Their words, and those of actuator::Wiring, which has the same values.
inline constexpr std::array<std::string_view, 2> bank_wiring_words{"parallel", "series"};

/// The coils that one driver feeds. Sizes agree.
struct CoilBank {
  Eigen::VectorXd resistances{};  ///< of each coil at its temperature, (n), ohm; finite, > 0
  /// Inductances, (n, n), H: self-inductances on the diagonal, beside it mutual inductances with the sign of their
  /// senses. Symmetric and positive definite.
  Eigen::MatrixXd inductances{};
  BankWiring wiring = BankWiring::parallel;
};

/// A resistance in series with an inductance, as a driver sees it.
struct Circuit {
  double resistance{};  ///< ohm; finite, > 0
  double inductance{};  ///< H; finite, > 0

  /// Time constant L/R, s.
  [[nodiscard]] double time_constant() const noexcept { return inductance / resistance; }
};

/// A bank as one circuit.
struct ReducedBank {
  Circuit circuit{};
  Eigen::VectorXd shares{};  ///< of each coil in the driver's current, (n); 1 in series, 1/n for like coils in parallel
  /// Relative difference, >= 0, by which a sudden change sees a smaller inductance than circuit.inductance. In
  /// parallel, slow currents divide by resistance and sudden ones by inductance. It is 0 for like coils and for coils
  /// in series.
  double inductance_spread{};
};

/// Reduces a bank to one circuit. In series resistances add up, and so do all self and mutual inductances. In parallel
/// the coils share the current i by their conductances, i_k = s_k i, and the inductance is that of the field energy of
/// these currents, s.L s. For a sudden change it is 1 / (1.L^-1 1), which by Thomson's theorem is the least that any
/// division has. Source: circuit theory, u_k = R_k i_k + sum_j L_kj di_j/dt. Throws std::invalid_argument naming the
/// field, the rule and the value received.
[[nodiscard]] ReducedBank reduce(const CoilBank& bank);

}  // namespace coilwright::drive
