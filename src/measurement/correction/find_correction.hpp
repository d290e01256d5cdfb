#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "coilwright/measurement/correction/nameless_correction.hpp"
#include "coilwright/measurement/localise/residual_torque.hpp"
#include "measurement/correction/correction_kind.hpp"
#include "measurement/identification/attribution.hpp"

namespace coilwright::measurement::correction {

/// What a search for a nameless correction found.
struct FoundCorrection {
  CorrectionOutcome outcome{};
  std::shared_ptr<const CorrectionKind> kind{};              ///< to which `fitted` refers
  std::optional<identification::FittedHypothesis> fitted{};  ///< the last step with the correction, everything refitted
};

/// Looks for a smooth torque over one or two of angle, rate and current that lets `attribution`'s last step predict
/// runs that were left out in turn clearly better, better than the recalibrated declared model too, and that comes to
/// rest when it is let go. `residual` is the residual torque of the last step; nothing: no run is a motion.
[[nodiscard]] FoundCorrection find_correction(std::span<const replay::PreparedRun> runs,
                                              const identification::Attribution& attribution,
                                              const std::optional<localise::ResidualTorque>& residual,
                                              const std::function<void(const std::string&)>& progress = {});

}  // namespace coilwright::measurement::correction
