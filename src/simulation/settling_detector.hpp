#pragma once

#include <optional>

#include "linear_system.hpp"

namespace coilwright::simulation {

/// Detects when a motion has come to its end in a model whose effects have no energy that could be counted.
///
/// Where every effect comes back to its settled state, the end is the equilibrium: reached when the bending angle has
/// stayed within half of the settling band about it for the time constant of the slowest small motion. Where something
/// sticks, the end is where the joints stand: reached when none has moved by 1e-4 of the change for three of those time
/// constants, in which what is left has died down to 5 % of that, or, for what oscillates, for one and a half periods.
class SettlingDetector {
 public:
  struct Spec {
    mechanics::JointVector equilibrium;  ///< rad, as if nothing stuck
    double change{};                     ///< of the bending angle to there, rad; > 0
    double band{};                       ///< settling band over the change
    double start{};                      ///< s
  };
  SettlingDetector(const LinearSystem& system, Spec spec);

  /// The end of the motion if it has arrived by the instant `time` (s, rising from call to call) at `angles`.
  [[nodiscard]] std::optional<mechanics::JointVector> observe(double time, const mechanics::JointVector& angles);

 private:
  [[nodiscard]] bool near_equilibrium(const mechanics::JointVector& angles) const;
  [[nodiscard]] bool has_not_moved(const mechanics::JointVector& angles);

  Spec spec_;
  bool sticks_;
  double patience_;  // s
  double since_;     // s
  mechanics::JointVector pose_;
};

}  // namespace coilwright::simulation
