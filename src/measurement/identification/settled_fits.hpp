#pragma once

#include <Eigen/Core>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "coilwright/measurement/identification/posterior.hpp"
#include "measurement/identification/fitted_hypothesis.hpp"

namespace coilwright::measurement::identification {

/// Where a fit of a hypothesis ended in a comparison that was begun anew.
struct KnownPlace {
  std::vector<actuator::Effect> effects{};
  Eigen::VectorXd values{};  ///< of the parameters of the hypothesis
};

/// What fits are settled with.
struct Settling {
  std::span<const replay::PreparedRun> runs{};
  std::span<const actuator::EffectKind* const> tested{};  ///< that show in these records
  const std::vector<const actuator::EffectKind*>& kinds;  ///< that were compared, see log_prior()
  std::span<const Belief> beliefs{};
  const actuator::RigScale& scale;
  std::span<const KnownPlace> known{};                 ///< further places from which to start
  std::function<void(const std::string&)> progress{};  ///< may be empty
};

/// The fits of a comparison, at the best optima to which any of them leads: a hypothesis weighs what its own optimum is
/// worth only if it has been looked for from where the others are. `fits` begins with the model without effects; so
/// does what comes back, with better and with further fits. Each hypothesis that may hold SearchEffort::least_weight,
/// and the model without effects, starts from the numbers of each other one; without one of its effects it starts from
/// its own; with one effect exchanged for another whose first number has the same unit it takes that number over (one
/// lag for another, one friction for another). A start is left out where the objective is as the fit's derivatives
/// predict: it leads back. Ends where no start leads to anything better.
[[nodiscard]] std::vector<FittedHypothesis> settled(const Settling& with, std::vector<FittedHypothesis> fits);

}  // namespace coilwright::measurement::identification
