#include "measurement/compare/linear_screening.hpp"

#include <tbb/parallel_for.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>

#include "measurement/compare/effect_strength.hpp"
#include "measurement/fit/residual_blocks.hpp"

namespace coilwright::measurement::compare {
namespace {

using actuator::Effect;
using actuator::EffectKind;

// Below this share of the product of their squares two directions are one.
constexpr double least_determinant = 1e-6;

// A start with each of its numbers (but choices) made up to twice as large or small, inside the bounds. By mt19937_64,
// whose numbers are the same everywhere.
std::vector<double> scattered(const EffectKind& kind, std::vector<double> start, std::mt19937_64& random) {
  const auto numbers = kind.parameters();
  for (std::size_t i = 0; i < start.size(); ++i) {
    if (!numbers[i].choices.empty() || !std::isfinite(start[i])) continue;
    const double share = static_cast<double>(random() >> 11) * 0x1p-53;
    start[i] = std::clamp(start[i] * std::exp2(2.0 * share - 1.0), numbers[i].lower, numbers[i].upper);
  }
  return start;
}

// Where the residuals of `base` would go if `request` (the same records, a larger hypothesis at its start) held: their
// difference, with all that the parameters and starts of `base` can absorb taken out. Rows as `base.stacked`.
std::optional<Eigen::VectorXd> direction(const fit::FitRequest& request, const fit::Fit& base) {
  const fit::ResidualBlocks blocks(request);
  const auto there = blocks.evaluate(request.start, fit::Slopes::none);
  if (!there) return std::nullopt;
  Eigen::VectorXd out(base.stacked.size());
  Eigen::Index row = 0;
  for (std::size_t b = 0; b < blocks.blocks().size(); ++b) {
    const Eigen::Index rows = blocks.blocks()[b].rows;
    Eigen::VectorXd moved = there->blocks[b].residuals - base.stacked.segment(row, rows);
    const Eigen::MatrixXd& basis = base.start_bases[b];
    moved -= basis * (basis.transpose() * moved);
    out.segment(row, rows) = moved;
    row += rows;
  }
  if (base.slopes.cols() == 0) return out;
  const Eigen::VectorXd absorbed = base.normal.completeOrthogonalDecomposition().solve(base.slopes.transpose() * out);
  return Eigen::VectorXd(out - base.slopes * absorbed);
}

// Makes a start as strong as the line says: `share` of what it was, its sign included.
void scale_start(Effect& effect, double share) {
  constexpr double weakest = 0.3;  // weaker ones leave a shape without a slope
  constexpr double strongest = 3.0;
  weaken(effect, std::copysign(std::clamp(std::abs(share), weakest, strongest), share));
}

struct Pair {
  const Addition* first{};
  const Addition* second{};
  double gain{};
};

// Two additions at the strengths at which their directions together explain most. No gain where they are one direction,
// or where one of them would have to act against its sign.
Pair together(const Scored& base, const Addition& a, const Addition& b) {
  Pair out{.first = &a, .second = &b};
  const double aa = a.direction.squaredNorm();
  const double bb = b.direction.squaredNorm();
  const double ab = a.direction.dot(b.direction);
  const double determinant = aa * bb - ab * ab;
  if (determinant <= least_determinant * aa * bb) return out;
  const double ra = -a.direction.dot(base.fit.stacked);
  const double rb = -b.direction.dot(base.fit.stacked);
  const double share_a = (bb * ra - ab * rb) / determinant;
  const double share_b = (aa * rb - ab * ra) / determinant;
  if (share_a < 0.0 && !may_be_negative(*a.effect.kind)) return out;
  if (share_b < 0.0 && !may_be_negative(*b.effect.kind)) return out;
  out.gain = share_a * ra + share_b * rb;
  return out;
}

std::vector<const Addition*> best_first(std::span<const Addition> offered) {
  std::vector<const Addition*> out;
  for (const Addition& addition : offered) out.push_back(&addition);
  std::ranges::stable_sort(out, [](const Addition* a, const Addition* b) { return a->gain > b->gain; });
  return out;
}

}  // namespace

std::vector<Addition> additions(std::span<const replay::Record> records, const Scored& base,
                                std::span<const EffectKind* const> kinds, const actuator::RigScale& scale,
                                std::uint64_t seed) {
  std::vector<Addition> out;
  std::mt19937_64 random(seed);
  const std::vector<const EffectKind*> there = base.kinds();
  for (const EffectKind* kind : kinds) {
    if (std::ranges::find(there, kind) != there.end()) continue;
    for (std::vector<double>& start : kind->starts(scale)) {
      // Where a fit is not convex the effect has more than one number (a shape besides a size).
      if (start.size() > 1) out.push_back({.effect = {.kind = kind, .values = scattered(*kind, start, random)}});
      out.push_back({.effect = {.kind = kind, .values = std::move(start)}});
    }
  }
  tbb::parallel_for(std::size_t{0}, out.size(), [&](std::size_t i) {
    const Trial trial = with(base, std::span(&out[i].effect, 1));
    auto moved = direction(asking(records, trial), base.fit);
    if (!moved) return;
    const double along = -moved->dot(base.fit.stacked);
    const double square = moved->squaredNorm();
    if (square <= 0.0 || (along < 0.0 && !may_be_negative(*out[i].effect.kind))) return;
    out[i].gain = along * along / square;
    scale_start(out[i].effect, along / square);
    out[i].direction = std::move(*moved);
  });
  return out;
}

std::vector<Effect> worth_a_glance(const EffectKind* kind, std::span<const Addition> offered) {
  std::vector<const Addition*> of_kind = best_first(offered);
  std::erase_if(of_kind, [&](const Addition* addition) { return addition->effect.kind != kind; });
  std::vector<Effect> out;
  std::vector<std::vector<double>> met;
  for (std::size_t i = 0; i < of_kind.size(); ++i) {
    const Addition& addition = *of_kind[i];
    std::vector<double> choices = choices_of(addition.effect);
    const bool fresh = std::ranges::find(met, choices) == met.end();
    if (i > 0 && addition.gain <= (fresh ? 0.1 : 0.7) * of_kind[0]->gain) continue;
    if (i > 1 && !fresh) continue;
    out.push_back(addition.effect);
    met.push_back(std::move(choices));
  }
  return out;
}

std::vector<const EffectKind*> most_promising(std::span<const Addition> offered, std::size_t most) {
  std::vector<const EffectKind*> out;
  for (const Addition* addition : best_first(offered)) {
    if (out.size() == most || addition->gain <= 0.0) break;
    if (std::ranges::find(out, addition->effect.kind) == out.end()) out.push_back(addition->effect.kind);
  }
  return out;
}

std::vector<std::pair<Effect, Effect>> most_promising_pairs(const Scored& base, std::span<const Addition> offered,
                                                            std::size_t most) {
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < offered.size(); ++i) {
    for (std::size_t j = i + 1; j < offered.size(); ++j) {
      const Addition& a = offered[i];
      const Addition& b = offered[j];
      if (a.effect.kind == b.effect.kind || a.direction.size() == 0 || b.direction.size() == 0) continue;
      if (const Pair pair = together(base, a, b); pair.gain > 0.0) pairs.push_back(pair);
    }
  }
  std::ranges::stable_sort(pairs, [](const Pair& a, const Pair& b) { return a.gain > b.gain; });
  std::vector<std::pair<Effect, Effect>> out;
  std::vector<std::pair<const EffectKind*, const EffectKind*>> taken;
  for (const Pair& pair : pairs) {
    if (out.size() == most) break;
    const std::pair kinds{pair.first->effect.kind, pair.second->effect.kind};
    if (std::ranges::find(taken, kinds) != taken.end()) continue;
    taken.push_back(kinds);
    out.emplace_back(pair.first->effect, pair.second->effect);
  }
  return out;
}

}  // namespace coilwright::measurement::compare
