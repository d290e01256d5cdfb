#pragma once

#include <optional>
#include <string>
#include <vector>

#include "coilwright/actuator/effect.hpp"

namespace coilwright::measurement::compare {

/// How much an effect explains, on the fit runs.
struct Evidence {
  double chi_square_before{};  ///< sum of squared residuals over the noise variance, without it
  double chi_square_after{};   ///< with it, everything fitted anew
  double criterion_gain{};     ///< fall of the criterion (chi^2 over correlation time, plus the charge for parameters)
  double cross_validated_gain{};  ///< share of the held-out squared residual above the noise that it removes; NaN if
                                  ///< the set has a single fit run
  double correlation_time{};      ///< samples of the residual that count as one
};

/// One of the hypotheses that were compared, best first.
struct Candidate {
  std::vector<const actuator::EffectKind*> effects{};
  std::optional<Evidence> evidence{};  ///< nothing where it was ruled out without a fit
  std::string
      remark{};  ///< why it is out: "interval includes absent", "does not fit this rig: ..."; empty if it is not
};

}  // namespace coilwright::measurement::compare
