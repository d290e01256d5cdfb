#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/actuator/model/effect.hpp"

namespace coilwright::measurement::compare {

/// How much an effect explains of the fit runs.
struct Evidence {
  double chi_square_before{};     ///< sum of squared residuals over the noise variance, without the effect
  double chi_square_after{};      ///< the same with the effect, all parameters refitted
  double criterion_gain{};        ///< fall of the quasi-BIC (chi-square over the overdispersion, plus the penalty for
                                  ///< the number of parameters)
  double cross_validated_gain{};  ///< fraction of the squared residual above the noise that it removes on runs that
                                  ///< are left out in turn; below zero where it makes them worse; where next to nothing
                                  ///< is above the noise, a fraction of the noise's own standard deviation; NaN if no
                                  ///< run could be counted, as of a single one
  /// Names of the runs that it does not count: the others leave the effect's numbers too open to predict them.
  std::vector<std::string> untold_runs{};
  double correlation_time{};  ///< integrated autocorrelation time of the residual with the effect, samples
};

/// The remark of a hypothesis whose last effect does not hold on runs that are left out in turn.
inline constexpr std::string_view worse_on_runs_left_out = "makes runs that are left out in turn worse";

/// One of the hypotheses that were compared.
struct ComparedHypothesis {
  std::vector<const actuator::EffectKind*> effects{};
  std::optional<Evidence> evidence{};  ///< nothing if the hypothesis was ruled out without a fit
  std::string remark{};                ///< why it is ruled out: "fits best where it is absent", "does not fit this rig:
                                       ///< ..."; empty if it is not
};

}  // namespace coilwright::measurement::compare
