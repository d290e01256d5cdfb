#include "measurement/compare/posterior.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "coilwright/algebra/spectral.hpp"

namespace coilwright::measurement::compare {
namespace {

using actuator::Effect;
using actuator::EffectKind;
using actuator::EffectParameter;

// What a magnitude is known to before the records are seen: a factor of ten either way.
constexpr double log_deviation = std::numbers::ln10;
// A number that the data leave open has a volume of so many of its typical changes.
constexpr double precision_of_nothing = 1e-6;
// A magnitude counts as no smaller than this fraction of a typical one: a fit that ends where its effect is absent.
constexpr double least_magnitude = 1e-3;

double normal_log_density(double u) {
  return -0.5 * (u * u + std::log(2.0 * std::numbers::pi));
}

// The value at which the effect is absent, of a magnitude; nothing of a shape, or where it is at infinity.
std::optional<double> origin_of(const EffectParameter& number) {
  return number.absent && std::isfinite(*number.absent) ? number.absent : std::nullopt;
}

// Geometric mean of the catalogue's starts, from the origin.
double typical(const EffectKind& kind, std::size_t number, const actuator::RigScale& scale) {
  const double origin = origin_of(kind.parameters()[number]).value_or(0.0);
  double sum = 0.0;
  int count = 0;
  for (const std::vector<double>& start : kind.starts(scale)) {
    const double away = std::abs(start[number] - origin);
    if (!(away > 0.0)) continue;
    sum += std::log(away);
    ++count;
  }
  return count == 0 ? 1.0 : std::exp(sum / count);
}

void add_log_normal(double magnitude, double about, PriorOfNumbers& out) {
  const double held = std::max(magnitude, least_magnitude * about);
  out.log_density += normal_log_density(std::log(held / about) / log_deviation);
  out.slopes.push_back(held * log_deviation);
  out.precisions.push_back(1.0);
}

void add_number(const Effect& effect, std::size_t index, const actuator::RigScale& scale, PriorOfNumbers& out) {
  const EffectParameter& number = effect.kind->parameters()[index];
  const double value = effect.values[index];
  if (number.deviation) {
    out.log_density += normal_log_density((value - number.absent.value_or(0.0)) / *number.deviation);
    out.slopes.push_back(*number.deviation);
    out.precisions.push_back(1.0);
  } else if (const std::optional<double> origin = origin_of(number)) {
    if (number.lower < *origin && *origin < number.upper) out.log_density -= std::numbers::ln2;
    add_log_normal(std::abs(value - *origin), typical(*effect.kind, index, scale), out);
  } else if (std::isfinite(number.lower) && std::isfinite(number.upper)) {
    // What Laplace's approximation makes of a uniform prior is right where the data know more.
    const double width = number.upper - number.lower;
    out.slopes.push_back(width);
    out.precisions.push_back(12.0);
  } else {
    add_log_normal(std::abs(value), typical(*effect.kind, index, scale), out);
  }
}

// Effects by id, since an effect with further numbers is another kind.
std::vector<std::string_view> ids_of(const std::vector<const EffectKind*>& effects) {
  std::vector<std::string_view> out;
  for (const EffectKind* kind : effects) out.push_back(kind->id());
  std::ranges::sort(out);
  return out;
}

bool is_same_hypothesis(const WeighedHypothesis& one, const WeighedHypothesis& other) {
  return std::ranges::is_permutation(one.effects, other.effects);
}

double log_binomial(std::size_t of, std::size_t taken) {
  const auto n = static_cast<double>(of);
  const auto k = static_cast<double>(taken);
  return std::lgamma(n + 1.0) - std::lgamma(k + 1.0) - std::lgamma(n - k + 1.0);
}

}  // namespace

std::vector<Posterior::Inclusion> Posterior::effects() const {
  std::vector<Inclusion> out;
  for (const WeighedHypothesis& each : hypotheses)
    for (const std::string_view id : ids_of(each.effects)) {
      auto known = std::ranges::find(out, id, &Inclusion::effect);
      if (known == out.end()) known = out.insert(out.end(), {.effect = id});
      known->probability += each.probability;
    }
  std::ranges::stable_sort(out, std::ranges::greater{}, &Inclusion::probability);
  return out;
}

double Posterior::probability_of(std::string_view effect) const {
  const std::vector<Inclusion> all = effects();
  const auto found = std::ranges::find(all, effect, &Inclusion::effect);
  return found == all.end() ? 0.0 : found->probability;
}

double Posterior::probability_of(const std::vector<const EffectKind*>& effects) const {
  double sum = 0.0;
  for (const WeighedHypothesis& each : hypotheses)
    if (ids_of(each.effects) == ids_of(effects)) sum += each.probability;
  return sum;
}

PriorOfNumbers prior_of_numbers(const Effect& effect, const actuator::RigScale& scale) {
  PriorOfNumbers out;
  const std::span<const EffectParameter> numbers = effect.kind->parameters();
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (numbers[i].choices.empty())
      add_number(effect, i, scale, out);
    else
      out.log_density -= std::log(static_cast<double>(numbers[i].choices.size()));
  }
  return out;
}

double log_evidence(const FittedHypothesis& fitted, const actuator::RigScale& scale, double overdispersion) {
  const Eigen::Index size = fitted.hypothesis.size();
  const auto declared = static_cast<Eigen::Index>(fitted.hypothesis.declared().calibration.size());
  Eigen::VectorXd slopes(size);
  Eigen::VectorXd precisions = Eigen::VectorXd::Zero(size);
  double out = -0.5 * fitted.fit.objective() / overdispersion;
  for (Eigen::Index i = 0; i < declared; ++i)
    slopes[i] = fitted.hypothesis.parameters()[static_cast<std::size_t>(i)].scale;
  Eigen::Index at = declared;
  for (const Effect& effect : fitted.hypothesis.effects_at(fitted.fit.values)) {
    const PriorOfNumbers prior = prior_of_numbers(effect, scale);
    out += prior.log_density;
    for (std::size_t k = 0; k < prior.slopes.size(); ++k, ++at) {
      slopes[at] = prior.slopes[k];
      precisions[at] = prior.precisions[k];
    }
  }
  if (size == 0) return out;
  Eigen::MatrixXd precision = slopes.asDiagonal() * fitted.fit.normal_matrix * slopes.asDiagonal() / overdispersion;
  precision.diagonal() += precisions;
  for (const double mode : algebra::symmetric_modes(precision).values)
    out += 0.5 * (std::log(2.0 * std::numbers::pi) - std::log(std::max(mode, precision_of_nothing)));
  return out;
}

double log_prior(const std::vector<const EffectKind*>& effects, const std::vector<const EffectKind*>& kinds) {
  double out =
      -std::numbers::ln2 * static_cast<double>(effects.size() + 1) - log_binomial(kinds.size(), effects.size());
  for (const EffectKind* kind : effects)
    if (kind->with_further_numbers() != nullptr || std::ranges::find(kinds, kind) == kinds.end())
      out -= std::numbers::ln2;
  return out;
}

Posterior posterior_of(const FittedHypothesis& declared, const std::vector<FittedHypothesis>& fitted,
                       const std::vector<const EffectKind*>& kinds, const actuator::RigScale& scale,
                       double overdispersion) {
  Posterior out;
  const double without = log_evidence(declared, scale, overdispersion);
  const auto weigh = [&](const FittedHypothesis& each) {
    // For now the logarithm of its weight; it becomes a probability once all are known.
    WeighedHypothesis weighed{.effects = each.kinds(),
                              .log_evidence = log_evidence(each, scale, overdispersion) - without};
    weighed.probability = weighed.log_evidence + log_prior(weighed.effects, kinds);
    const auto known = std::ranges::find_if(
        out.hypotheses, [&](const WeighedHypothesis& other) { return is_same_hypothesis(weighed, other); });
    if (known == out.hypotheses.end())
      out.hypotheses.push_back(std::move(weighed));
    else if (weighed.probability > known->probability)
      *known = std::move(weighed);
  };
  weigh(declared);
  for (const FittedHypothesis& each : fitted) weigh(each);
  std::ranges::stable_sort(out.hypotheses, std::ranges::greater{}, &WeighedHypothesis::probability);
  const double most = out.hypotheses.front().probability;
  double sum = 0.0;
  for (WeighedHypothesis& each : out.hypotheses) sum += each.probability = std::exp(each.probability - most);
  for (WeighedHypothesis& each : out.hypotheses) each.probability /= sum;
  return out;
}

}  // namespace coilwright::measurement::compare
