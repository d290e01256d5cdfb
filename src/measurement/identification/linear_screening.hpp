#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "coilwright/actuator/model/effect.hpp"
#include "measurement/identification/staged_fit.hpp"

namespace coilwright::measurement::identification {

/// A candidate effect at one initial guess, with the fall of chi-square predicted by linearising the residual in its
/// strength (a score test).
struct ScreenedEffect {
  actuator::Effect guess{};              ///< at the strength at which it was simulated
  actuator::Effect effect{};             ///< at the strength that the linearisation predicts; the guess where it
                                         ///< predicts the wrong sign
  Eigen::VectorXd residual_direction{};  ///< change of the stacked residuals by the guess, projected on what parameters
                                         ///< and initial states cannot absorb; empty if the guess cannot be simulated
  double predicted_chi_square_fall{};    ///< 0 where the effect would have to act against its sign
  double predicted_share{};              ///< of the guess, at which the linearisation predicts that fall
  Eigen::VectorXd absorbed{};            ///< what the guess, present, takes away from each parameter of the base
};

/// Which guesses are screened.
struct ScreeningRequest {
  std::span<const actuator::EffectKind* const> kinds{};
  actuator::RigScale scale{};  ///< from which effects derive their initial guesses
};

/// Screens every initial guess of every kind that `base` does not have yet. Simulates all runs once per guess, in
/// parallel.
[[nodiscard]] std::vector<ScreenedEffect> screen_effects(std::span<const replay::PreparedRun> runs,
                                                         const FittedHypothesis& base, const ScreeningRequest& request);

/// The kinds that `runs` do not test. Beside `base` every guess of such a kind, and the same a hundred times as strong
/// or at its bound, which is as strong as the prior of a magnitude has it (two deviations), would move chi-square by
/// next to nothing once parameters and initial states have taken up what they can: by less than a tenth, to which an
/// optimum is known, and a thousandth of the noise in each sample, to which a motion is simulated. Whether it is there
/// leaves these records as probable as they are. `screened`: of some windows of `runs` at least.
[[nodiscard]] std::vector<const actuator::EffectKind*> untested_kinds(std::span<const replay::PreparedRun> runs,
                                                                      const FittedHypothesis& base,
                                                                      std::span<const ScreenedEffect> screened,
                                                                      const ScreeningRequest& request);

/// Initial guesses of one kind to try in a short fit: the best of each discrete choice, and beside it the runner-up of
/// the same choice if it predicts more than 70 % as much (SearchEffort). The best of all first.
[[nodiscard]] std::vector<actuator::Effect> starts_for_short_fit(const actuator::EffectKind* kind,
                                                                 std::span<const ScreenedEffect> screened);

/// Initial guesses of one kind at the strength of the guess itself, those of the largest predicted fall first; at most
/// `most`.
[[nodiscard]] std::vector<actuator::Effect> own_starts(const actuator::EffectKind* kind,
                                                       std::span<const ScreenedEffect> screened, std::size_t most);

/// The largest fall of chi-square that any guess of a kind predicts.
[[nodiscard]] double largest_predicted_fall(const actuator::EffectKind* kind, std::span<const ScreenedEffect> screened);

/// The effect at `share` of its guess, the share limited by SearchEffort: from where a fit may start.
[[nodiscard]] actuator::Effect at_predicted_strength(actuator::Effect guess, double share);

}  // namespace coilwright::measurement::identification
