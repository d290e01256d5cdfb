#include "measurement/identification/linear_screening.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "coilwright/algebra/minimum_norm.hpp"
#include "measurement/fit/parallel.hpp"
#include "measurement/fit/residual_blocks.hpp"
#include "measurement/identification/effect_strength.hpp"
#include "measurement/identification/search_effort.hpp"

namespace coilwright::measurement::identification {
namespace {

using actuator::Effect;
using actuator::EffectKind;

// A change of residuals, with all projected out that the parameters and local numbers can absorb.
struct Direction {
  Eigen::VectorXd residuals{};
  Eigen::VectorXd absorbed{};  // by the parameters
};

// The change of the residuals of `base` to those of `request` (the same runs, a larger hypothesis at its start). Rows
// as base.stacked_residuals.
std::optional<Direction> residual_direction(const fit::FitRequest& request, const fit::Fit& base) {
  fit::ResidualBlocks blocks(request);
  const auto there = blocks.evaluate(request.start, fit::Derivatives::none);
  if (!there) return std::nullopt;
  // The rows of the prior at the end do not change: the effect is added at the declared numbers of the base.
  Eigen::VectorXd out = Eigen::VectorXd::Zero(base.stacked_residuals.size());
  Eigen::Index row = 0;
  for (std::size_t b = 0; b < blocks.blocks().size(); ++b) {
    const Eigen::Index rows = blocks.blocks()[b].rows;
    Eigen::VectorXd change = there->blocks[b].residuals - base.stacked_residuals.segment(row, rows);
    const Eigen::MatrixXd& basis = base.local_bases[b];
    change -= basis * (basis.transpose() * change);
    out.segment(row, rows) = change;
    row += rows;
  }
  Eigen::VectorXd absorbed = algebra::minimum_norm(base.normal_matrix, base.jacobian.transpose() * out);
  out -= base.jacobian * absorbed;
  return Direction{.residuals = std::move(out), .absorbed = std::move(absorbed)};
}

// Of the prior of a magnitude over its guesses, two standard deviations (prior_of_numbers.cpp).
constexpr double strongest = 100.0;

// See untested_kinds(), the square of a length over the noise.
double next_to_nothing(const fit::Fit& base) {
  constexpr double of_an_optimum = 0.1;
  constexpr double of_a_simulation = 1e-3;
  return of_an_optimum + of_a_simulation * of_a_simulation * static_cast<double>(base.samples());
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
  const std::vector<const EffectKind*> present = base.kinds();
  for (const EffectKind* kind : request.kinds) {
    if (std::ranges::any_of(present, [&](const EffectKind* each) { return each->id() == kind->id(); })) continue;
    for (std::vector<double>& guess : kind->starts(request.scale)) {
      const Effect effect{.kind = kind, .values = std::move(guess)};
      out.push_back({.guess = effect, .effect = effect});
    }
  }
  return out;
}

}  // namespace

Effect at_predicted_strength(Effect guess, double share) {
  const double size = std::clamp(std::abs(share), search_effort.weakest_start, search_effort.strongest_start);
  return scaled_from_absent(std::move(guess), std::copysign(size, share));
}

std::vector<ScreenedEffect> screen_effects(std::span<const replay::PreparedRun> runs, const FittedHypothesis& base,
                                           const ScreeningRequest& request) {
  std::vector<ScreenedEffect> out = guesses_of(base, request);
  fit::in_parallel(out.size(), [&](std::size_t i) {
    const PlannedFit plan = with_added_effects(base, std::span(&out[i].guess, 1));
    auto direction = residual_direction(fit_request_of(runs, plan), base.fit);
    if (!direction) return;
    out[i].residual_direction = std::move(direction->residuals);
    out[i].absorbed = std::move(direction->absorbed);
    const double along = -out[i].residual_direction.dot(base.fit.stacked_residuals);
    const double square = out[i].residual_direction.squaredNorm();
    if (square <= 0.0 || (along < 0.0 && !may_be_negative(*out[i].guess.kind))) return;
    out[i].predicted_chi_square_fall = along * along / square;
    out[i].predicted_share = along / square;
    out[i].effect = at_predicted_strength(out[i].guess, along / square);
  });
  return out;
}

std::vector<const EffectKind*> untested_kinds(std::span<const replay::PreparedRun> runs, const FittedHypothesis& base,
                                              std::span<const ScreenedEffect> screened,
                                              const ScreeningRequest& request) {
  const double most = next_to_nothing(base.fit);
  // What cannot be simulated changes something.
  const auto shows = [&](const EffectKind* kind) {
    return std::ranges::any_of(screened, [&](const ScreenedEffect& each) {
      const Eigen::VectorXd& direction = each.residual_direction;
      return each.guess.kind == kind && (direction.size() == 0 || direction.squaredNorm() > most);
    });
  };
  std::vector<const EffectKind*> out;
  std::ranges::copy_if(request.kinds, std::back_inserter(out), [&](const EffectKind* kind) { return !shows(kind); });
  std::vector<char> tested(out.size(), 0);
  fit::in_parallel(out.size(), [&](std::size_t i) {
    for (const std::vector<double>& guess : out[i]->starts(request.scale))
      for (const double share : {1.0, strongest}) {
        const Effect effect = at_share_of_strength({.kind = out[i], .values = guess}, share);
        const PlannedFit plan = with_added_effects(base, std::span(&effect, 1));
        const auto direction = residual_direction(fit_request_of(runs, plan), base.fit);
        if (!direction || !(direction->residuals.squaredNorm() <= most)) tested[i] = 1;
      }
  });
  std::size_t place = 0;
  std::erase_if(out, [&](const EffectKind* /*kind*/) { return tested[place++] != 0; });
  return out;
}

std::vector<Effect> starts_for_short_fit(const EffectKind* kind, std::span<const ScreenedEffect> screened) {
  std::vector<const ScreenedEffect*> of_kind = best_first(screened);
  std::erase_if(of_kind, [&](const ScreenedEffect* each) { return each->effect.kind != kind; });
  // Of each set of discrete choices the fall that its best promises, and how many of it are taken.
  struct Choice {
    std::vector<double> values{};
    double most{};
    int taken = 0;
  };
  std::vector<Choice> choices;
  std::vector<Effect> out;
  for (const ScreenedEffect* each : of_kind) {
    std::vector<double> values = choices_of(each->effect);
    auto known = std::ranges::find(choices, values, &Choice::values);
    if (known == choices.end())
      known = choices.insert(known, {.values = std::move(values), .most = each->predicted_chi_square_fall});
    if (known->taken > 0 && each->predicted_chi_square_fall <= search_effort.runner_up * known->most) continue;
    if (known->taken == 2) continue;
    out.push_back(each->effect);
    ++known->taken;
  }
  return out;
}

std::vector<Effect> own_starts(const EffectKind* kind, std::span<const ScreenedEffect> screened, std::size_t most) {
  std::vector<Effect> out;
  for (const ScreenedEffect* each : best_first(screened)) {
    if (each->guess.kind != kind) continue;
    if (out.size() == most) break;
    out.push_back(each->guess);
  }
  return out;
}

double largest_predicted_fall(const EffectKind* kind, std::span<const ScreenedEffect> screened) {
  double out = 0.0;
  for (const ScreenedEffect& each : screened)
    if (each.guess.kind == kind) out = std::max(out, each.predicted_chi_square_fall);
  return out;
}

}  // namespace coilwright::measurement::identification
