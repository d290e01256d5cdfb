#include "measurement/identification/unseen_effects.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>

#include "measurement/identification/curvature.hpp"
#include "measurement/identification/linear_screening.hpp"
#include "measurement/identification/model_error.hpp"
#include "measurement/identification/profile_likelihood.hpp"
#include "measurement/identification/search_effort.hpp"

namespace coilwright::measurement::identification {
namespace {

constexpr double notably_wider = 1.2;

// Of each kind the guess that promises most.
std::vector<const ScreenedEffect*> best_of_each_kind(const std::vector<ScreenedEffect>& screened) {
  std::vector<const ScreenedEffect*> out;
  for (const ScreenedEffect& each : screened) {
    const auto known = std::ranges::find(out, each.guess.kind, [](const auto* best) { return best->guess.kind; });
    if (known == out.end())
      out.push_back(&each);
    else if (each.predicted_chi_square_fall > (*known)->predicted_chi_square_fall)
      *known = &each;
  }
  return out;
}

// One more effect beside the model that is reported.
struct Addition {
  const actuator::EffectKind* kind{};
  double gain{};              // of the quasi-BIC
  double weight{};            // that of the reported model being 1
  Eigen::VectorXd squares{};  // of how far each number is then from where it is reported, beyond its own variance
};

std::vector<Addition> additions(const FittedHypothesis& fitted, const std::vector<ScreenedEffect>& screened,
                                double overdispersion) {
  const double per_number = penalty_per_number(fitted, overdispersion);
  std::vector<Addition> out;
  for (const ScreenedEffect* each : best_of_each_kind(screened)) {
    const double fall = each->predicted_chi_square_fall / overdispersion;
    if (fall < chi_square_95) continue;
    const auto numbers = static_cast<double>(std::max<std::size_t>(1, each->guess.values.size()));
    const double gain = fall - numbers * per_number;
    const double share = std::min(std::abs(each->predicted_share), search_effort.strongest_start);
    const double variance = overdispersion / each->residual_direction.squaredNorm();
    out.push_back({.kind = each->guess.kind,
                   .gain = gain,
                   .weight = std::exp(0.5 * gain),
                   .squares = (share * share + variance) * each->absorbed.cwiseAbs2()});
  }
  return out;
}

// How many times wider an interval is for variance beyond its own; 1 where it is open.
double widened(const Estimate& estimate, double beyond) {
  const double width = estimate.upper - estimate.lower;
  return std::isfinite(width) && width > 0.0 ? std::hypot(width, 2.0 * normal_95 * std::sqrt(beyond)) / width : 1.0;
}

}  // namespace

std::vector<HintedEffect> widen_by_unseen_effects(std::vector<Estimate>& estimates,
                                                  std::span<const replay::PreparedRun> runs,
                                                  const Attribution& attribution, double overdispersion) {
  std::vector<HintedEffect> out;
  const FittedHypothesis& fitted = attribution.after;
  if (is_far_from_noise(fitted)) return out;
  const auto screened = screen_effects(runs, fitted, {.kinds = attribution.kinds, .scale = attribution.scale});
  const std::vector<Addition> more = additions(fitted, screened, overdispersion);
  double weights = 1.0;
  for (const Addition& each : more) weights += each.weight;
  const Eigen::Index numbers = fitted.hypothesis.size();
  for (const Addition& each : more) {
    HintedEffect hint{.kind = each.kind, .gain = each.gain};
    for (Eigen::Index i = 0; i < numbers; ++i) {
      const Estimate& estimate = estimates[static_cast<std::size_t>(i)];
      const double wider = widened(estimate, each.weight / weights * each.squares[i]);
      if (wider > hint.wider) hint = {each.kind, each.gain, estimate.key, wider};
    }
    if (hint.wider >= notably_wider) out.push_back(std::move(hint));
  }
  std::ranges::stable_sort(out, std::ranges::greater{}, &HintedEffect::wider);
  for (Eigen::Index i = 0; i < numbers; ++i) {
    double beyond = 0.0;
    for (const Addition& each : more) beyond += each.weight / weights * each.squares[i];
    const auto index = static_cast<std::size_t>(i);
    if (beyond > 0.0) widen(estimates[index], fitted.hypothesis.parameters()[index], beyond);
  }
  return out;
}

}  // namespace coilwright::measurement::identification
