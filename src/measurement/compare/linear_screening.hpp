#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "coilwright/actuator/model/effect.hpp"
#include "measurement/compare/staged_fit.hpp"

namespace coilwright::measurement::compare {

/// A candidate effect at one initial guess, with the fall of chi-square predicted by linearising the residual in its
/// strength (a score test).
struct ScreenedEffect {
  actuator::Effect effect{};             ///< at the strength that the linearisation predicts
  Eigen::VectorXd residual_direction{};  ///< change of the stacked residuals, projected on what parameters and initial
                                         ///< states cannot absorb; empty if the guess cannot be simulated
  double predicted_chi_square_fall{};
};

/// Which guesses are screened.
struct ScreeningRequest {
  std::span<const actuator::EffectKind* const> kinds{};
  actuator::RigScale scale{};  ///< from which effects derive their initial guesses
  std::uint64_t seed = 1;      ///< random seed for the scattered guesses
};

/// Screens every initial guess of every kind that `base` does not have yet. Guesses of effects with several numbers are
/// screened a second time, scattered at random. Simulates all runs once per guess, in parallel.
[[nodiscard]] fit::Counted<std::vector<ScreenedEffect>> screen_effects(std::span<const replay::PreparedRun> runs,
                                                                       const FittedHypothesis& base,
                                                                       const ScreeningRequest& request);

/// Initial guesses of one kind to try in a short fit: the best; the best of each other discrete choice if it predicts
/// at least 10 % as much; the runner-up if at least 70 % (SearchEffort).
[[nodiscard]] std::vector<actuator::Effect> starts_for_short_fit(const actuator::EffectKind* kind,
                                                                 std::span<const ScreenedEffect> screened);

/// The kinds with the largest predicted fall of chi-square, best first, at most `count`.
[[nodiscard]] std::vector<const actuator::EffectKind*> kinds_by_predicted_fall(std::span<const ScreenedEffect> screened,
                                                                               std::size_t count);

/// The pairs of different kinds with the largest fall of chi-square predicted for both together, best first, at most
/// `count`. Neither effect of a pair need explain anything by itself.
[[nodiscard]] std::vector<std::pair<actuator::Effect, actuator::Effect>> pairs_by_predicted_fall(
    const FittedHypothesis& base, std::span<const ScreenedEffect> screened, std::size_t count);

}  // namespace coilwright::measurement::compare
