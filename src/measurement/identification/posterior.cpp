#include "measurement/identification/posterior.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <string_view>
#include <utility>

#include "measurement/fit/parallel.hpp"
#include "measurement/identification/weighed_fit.hpp"

namespace coilwright::measurement::identification {
namespace {

using actuator::EffectKind;

double log_binomial(std::size_t of, std::size_t taken) {
  const auto n = static_cast<double>(of);
  const auto k = static_cast<double>(taken);
  return std::lgamma(n + 1.0) - std::lgamma(k + 1.0) - std::lgamma(n - k + 1.0);
}

// Of a discrepancy all records together tell as much as so many values of it that are independent of one another.
constexpr double values_that_count = 30.0;

// What are weights becomes probabilities.
void add_up_to_one(Posterior& posterior) {
  double sum = 0.0;
  for (const WeighedHypothesis& each : posterior.hypotheses) sum += each.probability;
  for (WeighedHypothesis& each : posterior.hypotheses) each.probability /= sum;
}

}  // namespace

bool are_among(const std::vector<const EffectKind*>& some, const std::vector<const EffectKind*>& of) {
  return std::ranges::all_of(some, [&](const EffectKind* each) {
    return std::ranges::any_of(of, [&](const EffectKind* one) { return one->id() == each->id(); });
  });
}

// A discrepancy is no process that time makes anew: what a model
// lacks comes back with every motion like the last one, and so does what a wrong effect can make of it.
double share_of_evidence(const WeighedFit& heaviest) {
  if (heaviest.probability_of_noise >= 0.5) return 1.0;
  return std::min(1.0, values_that_count / heaviest.values_of_discrepancy);
}

std::vector<std::string_view> ids_of(const std::vector<const EffectKind*>& effects) {
  std::vector<std::string_view> out;
  for (const EffectKind* kind : effects) out.push_back(kind->id());
  std::ranges::sort(out);
  return out;
}

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

std::vector<const EffectKind*> Posterior::not_tested() const {
  std::vector<const EffectKind*> out;
  for (const RuledOut& each : ruled_out)
    if (each.remark == not_tested_remark) out.insert(out.end(), each.effects.begin(), each.effects.end());
  return out;
}

double Posterior::probability_of(const std::vector<const EffectKind*>& effects) const {
  double sum = 0.0;
  for (const WeighedHypothesis& each : hypotheses)
    if (ids_of(each.effects) == ids_of(effects)) sum += each.probability;
  return sum;
}

double Posterior::probability_of_any(const std::vector<const EffectKind*>& effects) const {
  double sum = 0.0;
  for (const WeighedHypothesis& each : hypotheses)
    if (std::ranges::any_of(effects, [&](const EffectKind* one) { return are_among({one}, each.effects); }))
      sum += each.probability;
  return sum;
}

double Posterior::probability_among(const std::vector<const EffectKind*>& effects) const {
  double sum = 0.0;
  for (const WeighedHypothesis& each : hypotheses)
    if (are_among(each.effects, effects)) sum += each.probability;
  return sum;
}

double log_prior(const std::vector<const EffectKind*>& effects, const std::vector<const EffectKind*>& kinds,
                 std::span<const Belief> beliefs) {
  double out =
      -std::numbers::ln2 * static_cast<double>(effects.size() + 1) - log_binomial(kinds.size(), effects.size());
  const double log_odds_of_any = -std::log(std::max(1.0, static_cast<double>(kinds.size()) - 1.0));
  for (const EffectKind* kind : effects) {
    if (kind->with_further_numbers() != nullptr || std::ranges::find(kinds, kind) == kinds.end())
      out -= std::numbers::ln2;
    const auto believed = std::ranges::find(beliefs, kind->id(), &Belief::effect);
    if (believed != beliefs.end())
      out += std::log(believed->probability / (1.0 - believed->probability)) - log_odds_of_any;
  }
  return out;
}

WeighedHypotheses posterior_of(std::span<const replay::PreparedRun> runs, const FittedHypothesis& declared,
                               const std::vector<FittedHypothesis>& fitted, const std::vector<const EffectKind*>& kinds,
                               const actuator::RigScale& scale, std::span<const Belief> beliefs) {
  std::vector<WeighedFit> all(1 + fitted.size());
  const auto fit_of = [&](std::size_t i) -> const FittedHypothesis& { return i == 0 ? declared : fitted[i - 1]; };
  fit::in_parallel(all.size(), [&](std::size_t i) { all[i] = weighed(runs, fit_of(i), scale); });
  std::vector<std::size_t> best;  // fit of each hypothesis
  double share = 1.0;
  const auto log_weight = [&](std::size_t i) {
    return share * all[i].log_evidence + log_prior(fit_of(i).kinds(), kinds, beliefs);
  };
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto known = std::ranges::find_if(
        best, [&](std::size_t k) { return std::ranges::is_permutation(fit_of(i).kinds(), fit_of(k).kinds()); });
    if (known == best.end())
      best.push_back(i);
    else if (log_weight(i) > log_weight(*known))
      *known = i;
  }
  share = share_of_evidence(all[*std::ranges::max_element(best, {}, log_weight)]);
  std::ranges::stable_sort(best, std::ranges::greater{}, log_weight);
  WeighedHypotheses out{.posterior = {}, .weighed = {}, .fits = best};
  for (const std::size_t i : best) {
    out.posterior.hypotheses.push_back({.effects = fit_of(i).kinds(),
                                        .chi_square = fit_of(i).fit.chi_square,
                                        .log_evidence = all[i].log_evidence - all.front().log_evidence,
                                        .probability = std::exp(log_weight(i) - log_weight(best.front())),
                                        .lacks = all[i].discrepancy.deviation,
                                        .lacks_over = all[i].discrepancy.length,
                                        .probability_of_noise = all[i].probability_of_noise,
                                        .probability_of_declared = probability_of_declared_numbers(fit_of(i))});
    out.weighed.push_back(std::move(all[i]));
  }
  add_up_to_one(out.posterior);
  return out;
}

Posterior first_impressions(const FittedHypothesis& declared, const std::vector<FirstImpression>& fits,
                            const std::vector<const EffectKind*>& kinds, std::span<const Belief> beliefs,
                            double overdispersion) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  const double without = quasi_bic(declared, overdispersion);
  Posterior out;
  const auto add = [&](const std::vector<const EffectKind*>& effects, double chi_square, double criterion) {
    out.hypotheses.push_back({.effects = effects,
                              .chi_square = chi_square,
                              .log_evidence = 0.5 * (without - criterion),
                              .lacks = unknown,
                              .lacks_over = unknown,
                              .probability_of_noise = unknown});
  };
  add({}, declared.fit.chi_square, without);
  for (const FirstImpression& each : fits) add(each.effects, each.chi_square, each.criterion);
  const auto log_weight = [&](const WeighedHypothesis& each) {
    return each.log_evidence + log_prior(each.effects, kinds, beliefs);
  };
  std::ranges::stable_sort(out.hypotheses, std::ranges::greater{}, log_weight);
  const double most = log_weight(out.hypotheses.front());
  for (WeighedHypothesis& each : out.hypotheses) each.probability = std::exp(log_weight(each) - most);
  add_up_to_one(out);
  if (fits.empty()) out.hypotheses.front().probability = unknown;
  return out;
}

}  // namespace coilwright::measurement::identification
