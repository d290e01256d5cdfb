#include "measurement/compare/linear_screening.hpp"

#include <tbb/parallel_for.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

#include "measurement/compare/effect_strength.hpp"
#include "measurement/compare/search_effort.hpp"
#include "measurement/fit/residual_blocks.hpp"

namespace coilwright::measurement::compare {
namespace {

using actuator::Effect;
using actuator::EffectKind;

// An initial guess with each number, discrete choices excepted, multiplied by a random factor, inside the bounds. Drawn
// by mt19937_64, whose numbers are the same on every platform.
std::vector<double> scattered(const EffectKind& kind, std::vector<double> guess, std::mt19937_64& random) {
  const double octaves = std::log2(search_effort.scatter);
  const auto numbers = kind.parameters();
  for (std::size_t i = 0; i < guess.size(); ++i) {
    if (!numbers[i].choices.empty() || !std::isfinite(guess[i])) continue;
    const double share = static_cast<double>(random() >> 11) * 0x1p-53;
    guess[i] = std::clamp(guess[i] * std::exp2(octaves * (2.0 * share - 1.0)), numbers[i].lower, numbers[i].upper);
  }
  return guess;
}

// The change of the residuals of `base` to those of `request` (the same runs, a larger hypothesis at its start), with
// all that the parameters and local numbers of `base` can absorb projected out. Rows as base.stacked_residuals.
fit::Counted<std::optional<Eigen::VectorXd>> residual_direction(const fit::FitRequest& request, const fit::Fit& base) {
  const fit::ResidualBlocks blocks(request);
  const auto there = blocks.evaluate(request.start, fit::Derivatives::none);
  if (!there.value) return {.value = std::nullopt, .simulated_runs = there.simulated_runs};
  // The rows of the prior at the end do not change: the effect is added at the declared numbers of the base.
  Eigen::VectorXd out = Eigen::VectorXd::Zero(base.stacked_residuals.size());
  Eigen::Index row = 0;
  for (std::size_t b = 0; b < blocks.blocks().size(); ++b) {
    const Eigen::Index rows = blocks.blocks()[b].rows;
    Eigen::VectorXd change = there.value->blocks[b].residuals - base.stacked_residuals.segment(row, rows);
    const Eigen::MatrixXd& basis = base.local_bases[b];
    change -= basis * (basis.transpose() * change);
    out.segment(row, rows) = change;
    row += rows;
  }
  if (base.jacobian.cols() == 0) return {.value = std::move(out), .simulated_runs = there.simulated_runs};
  const Eigen::VectorXd absorbed =
      base.normal_matrix.completeOrthogonalDecomposition().solve(base.jacobian.transpose() * out);
  return {.value = Eigen::VectorXd(out - base.jacobian * absorbed), .simulated_runs = there.simulated_runs};
}

// The effect at the strength that the linearisation predicts: `share` of the guess, its sign included.
Effect at_predicted_strength(Effect effect, double share) {
  const double size = std::clamp(std::abs(share), search_effort.weakest_start, search_effort.strongest_start);
  return scaled_from_absent(std::move(effect), std::copysign(size, share));
}

struct ScreenedPair {
  const ScreenedEffect* first{};
  const ScreenedEffect* second{};
  double predicted_chi_square_fall{};
};

// Two effects at the strengths at which their directions together explain most. The fall is 0 if the directions are
// one, or if one of the effects would have to act against its sign.
ScreenedPair joint_prediction(const FittedHypothesis& base, const ScreenedEffect& a, const ScreenedEffect& b) {
  ScreenedPair out{.first = &a, .second = &b};
  const double aa = a.residual_direction.squaredNorm();
  const double bb = b.residual_direction.squaredNorm();
  const double ab = a.residual_direction.dot(b.residual_direction);
  const double determinant = aa * bb - ab * ab;
  if (determinant <= search_effort.smallest_determinant * aa * bb) return out;
  const double ra = -a.residual_direction.dot(base.fit.stacked_residuals);
  const double rb = -b.residual_direction.dot(base.fit.stacked_residuals);
  const double share_a = (bb * ra - ab * rb) / determinant;
  const double share_b = (aa * rb - ab * ra) / determinant;
  if (share_a < 0.0 && !may_be_negative(*a.effect.kind)) return out;
  if (share_b < 0.0 && !may_be_negative(*b.effect.kind)) return out;
  out.predicted_chi_square_fall = share_a * ra + share_b * rb;
  return out;
}

std::vector<const ScreenedEffect*> best_first(std::span<const ScreenedEffect> screened) {
  std::vector<const ScreenedEffect*> out;
  for (const ScreenedEffect& each : screened) out.push_back(&each);
  std::ranges::stable_sort(out, [](const ScreenedEffect* a, const ScreenedEffect* b) {
    return a->predicted_chi_square_fall > b->predicted_chi_square_fall;
  });
  return out;
}

std::vector<ScreenedEffect> guesses_of(const FittedHypothesis& base, const ScreeningRequest& request) {
  std::vector<ScreenedEffect> out;
  std::mt19937_64 random(request.seed);
  const std::vector<const EffectKind*> present = base.kinds();
  for (const EffectKind* kind : request.kinds) {
    if (std::ranges::find(present, kind) != present.end()) continue;
    for (std::vector<double>& guess : kind->starts(request.scale)) {
      // Cost functions that are not convex occur for effects with several numbers (a shape besides a size).
      if (guess.size() > 1) out.push_back({.effect = {.kind = kind, .values = scattered(*kind, guess, random)}});
      out.push_back({.effect = {.kind = kind, .values = std::move(guess)}});
    }
  }
  return out;
}

}  // namespace

fit::Counted<std::vector<ScreenedEffect>> screen_effects(std::span<const replay::PreparedRun> runs,
                                                         const FittedHypothesis& base,
                                                         const ScreeningRequest& request) {
  std::vector<ScreenedEffect> out = guesses_of(base, request);
  std::vector<long> simulated_runs(out.size(), 0);
  tbb::parallel_for(std::size_t{0}, out.size(), [&](std::size_t i) {
    const PlannedFit plan = with_added_effects(base, std::span(&out[i].effect, 1));
    auto direction = residual_direction(fit_request_of(runs, plan), base.fit);
    simulated_runs[i] = direction.simulated_runs;
    if (!direction.value) return;
    const double along = -direction.value->dot(base.fit.stacked_residuals);
    const double square = direction.value->squaredNorm();
    if (square <= 0.0 || (along < 0.0 && !may_be_negative(*out[i].effect.kind))) return;
    out[i].predicted_chi_square_fall = along * along / square;
    out[i].effect = at_predicted_strength(std::move(out[i].effect), along / square);
    out[i].residual_direction = std::move(*direction.value);
  });
  long total = 0;
  for (const long each : simulated_runs) total += each;
  return {.value = std::move(out), .simulated_runs = total};
}

std::vector<Effect> starts_for_short_fit(const EffectKind* kind, std::span<const ScreenedEffect> screened) {
  std::vector<const ScreenedEffect*> of_kind = best_first(screened);
  std::erase_if(of_kind, [&](const ScreenedEffect* each) { return each->effect.kind != kind; });
  std::vector<Effect> out;
  std::vector<std::vector<double>> taken_choices;
  for (std::size_t i = 0; i < of_kind.size(); ++i) {
    const ScreenedEffect& each = *of_kind[i];
    std::vector<double> choices = choices_of(each.effect);
    const bool is_new = std::ranges::find(taken_choices, choices) == taken_choices.end();
    const double least = is_new ? search_effort.other_choice : search_effort.runner_up;
    if (i > 0 && each.predicted_chi_square_fall <= least * of_kind[0]->predicted_chi_square_fall) continue;
    if (i > 1 && !is_new) continue;
    out.push_back(each.effect);
    taken_choices.push_back(std::move(choices));
  }
  return out;
}

std::vector<const EffectKind*> kinds_by_predicted_fall(std::span<const ScreenedEffect> screened, std::size_t count) {
  std::vector<const EffectKind*> out;
  for (const ScreenedEffect* each : best_first(screened)) {
    if (out.size() == count || each->predicted_chi_square_fall <= 0.0) break;
    if (std::ranges::find(out, each->effect.kind) == out.end()) out.push_back(each->effect.kind);
  }
  return out;
}

std::vector<std::pair<Effect, Effect>> pairs_by_predicted_fall(const FittedHypothesis& base,
                                                               std::span<const ScreenedEffect> screened,
                                                               std::size_t count) {
  std::vector<ScreenedPair> pairs;
  for (std::size_t i = 0; i < screened.size(); ++i) {
    for (std::size_t j = i + 1; j < screened.size(); ++j) {
      const ScreenedEffect& a = screened[i];
      const ScreenedEffect& b = screened[j];
      if (a.effect.kind == b.effect.kind || a.residual_direction.size() == 0 || b.residual_direction.size() == 0)
        continue;
      if (const ScreenedPair pair = joint_prediction(base, a, b); pair.predicted_chi_square_fall > 0.0)
        pairs.push_back(pair);
    }
  }
  std::ranges::stable_sort(pairs, [](const ScreenedPair& a, const ScreenedPair& b) {
    return a.predicted_chi_square_fall > b.predicted_chi_square_fall;
  });
  std::vector<std::pair<Effect, Effect>> out;
  std::vector<std::pair<const EffectKind*, const EffectKind*>> taken;
  for (const ScreenedPair& pair : pairs) {
    if (out.size() == count) break;
    const std::pair kinds{pair.first->effect.kind, pair.second->effect.kind};
    if (std::ranges::find(taken, kinds) != taken.end()) continue;
    taken.push_back(kinds);
    out.emplace_back(pair.first->effect, pair.second->effect);
  }
  return out;
}

}  // namespace coilwright::measurement::compare
