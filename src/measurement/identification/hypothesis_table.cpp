#include "measurement/identification/hypothesis_table.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <utility>

#include "measurement/fit/parallel.hpp"
#include "measurement/identification/fit_in_turns.hpp"
#include "measurement/identification/model_error.hpp"
#include "measurement/identification/search_effort.hpp"

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

double share_of_evidence(const WeighedFit& heaviest) {
  if (heaviest.probability_of_noise >= 0.5) return 1.0;
  return std::min(1.0, values_that_count / heaviest.values_of_discrepancy);
}

}  // namespace

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

double TableEntry::negligible_fall() const {
  constexpr double near_noise = 0.1;
  constexpr double far_from_noise = 1e-3;
  return is_far_from_noise(fitted) ? far_from_noise * fitted.fit.objective() : near_noise;
}

bool TableEntry::is_at_optimum() const {
  return promised <= negligible_fall();
}

void HypothesisTable::add(std::vector<FittedHypothesis> fits, bool have_ended) {
  const std::size_t first = entries_.size();
  for (FittedHypothesis& each : fits) entries_.push_back({.fitted = std::move(each), .has_ended = have_ended});
  fit::in_parallel(entries_.size() - first, [&](std::size_t i) {
    TableEntry& entry = entries_[first + i];
    entry.weighed = weighed(with_.runs, entry.fitted, with_.scale);
    entry.promised = promised_fall(entry.fitted.fit);
  });
  share_ = 1.0;
  share_ = share_of_evidence(hypotheses().front()->weighed);
}

double HypothesisTable::log_weight(const TableEntry& entry) const {
  return share_ * entry.weighed.log_evidence + log_prior(entry.fitted.kinds(), with_.kinds, with_.beliefs);
}

double HypothesisTable::promise(const TableEntry& entry) const {
  if (entry.has_ended || entry.is_at_optimum()) return log_weight(entry);
  double lowest = std::numeric_limits<double>::infinity(), of_fewer = lowest;
  const std::vector<const EffectKind*> kinds = entry.fitted.kinds();
  for (const TableEntry& each : entries_) {
    const double objective = each.fitted.fit.objective();
    lowest = std::min(lowest, objective);
    const std::vector<const EffectKind*> fewer = each.fitted.kinds();
    if (fewer.size() < kinds.size() && are_among(fewer, kinds)) of_fewer = std::min(of_fewer, objective);
  }
  const double objective = entry.fitted.fit.objective();
  const double gained = kinds.empty() ? 0.0 : of_fewer - objective;
  const double most =
      std::min(std::max(gained, search_effort.other_optima_gain), objective - lowest + search_effort.other_optima_gain);
  return log_weight(entry) + 0.5 * share_ * std::min(entry.promised, most);
}

double HypothesisTable::promise(const TableEntry& entry, const std::vector<const EffectKind*>& effects,
                                double further_evidence) const {
  return share_ * (entry.weighed.log_evidence + further_evidence) + log_prior(effects, with_.kinds, with_.beliefs);
}

double HypothesisTable::worth_a_fit() const {
  return log_weight(*hypotheses().front()) + std::log(search_effort.least_weight);
}

bool HypothesisTable::leaves_noise() const {
  return hypotheses().front()->weighed.probability_of_noise >= 0.5;
}

bool HypothesisTable::is_better(const TableEntry& one, const TableEntry& other) const {
  const bool lower = one.fitted.fit.objective() < other.fitted.fit.objective();
  if (!(lower ? other : one).is_at_optimum()) return lower;
  return log_weight(one) > log_weight(other);
}

std::vector<const TableEntry*> HypothesisTable::hypotheses() const {
  std::vector<std::pair<std::vector<std::string_view>, const TableEntry*>> best;
  for (const TableEntry& each : entries_) {
    auto ids = each.ids();
    const auto known = std::ranges::find(best, ids, &decltype(best)::value_type::first);
    if (known == best.end())
      best.emplace_back(std::move(ids), &each);
    else if (is_better(each, *known->second))
      known->second = &each;
  }
  std::vector<const TableEntry*> out;
  for (const auto& each : best) out.push_back(each.second);
  std::ranges::stable_sort(out, std::ranges::greater{}, [&](const TableEntry* each) { return log_weight(*each); });
  return out;
}

const TableEntry* HypothesisTable::best_of(const std::vector<std::string_view>& ids) const {
  const TableEntry* best = nullptr;
  for (const TableEntry& each : entries_)
    if (each.ids() == ids && (best == nullptr || is_better(each, *best))) best = &each;
  return best;
}

WeighedHypotheses HypothesisTable::posterior() const {
  const std::vector<const TableEntry*> best = hypotheses();
  const double without = best_of({})->weighed.log_evidence;
  WeighedHypotheses out;
  double sum = 0.0;
  for (const TableEntry* each : best) {
    const double weight = std::exp(log_weight(*each) - log_weight(*best.front()));
    sum += weight;
    out.posterior.hypotheses.push_back({.effects = each->fitted.kinds(),
                                        .chi_square = each->fitted.fit.chi_square,
                                        .log_evidence = each->weighed.log_evidence - without,
                                        .probability = weight,
                                        .lacks = each->weighed.discrepancy.deviation,
                                        .lacks_over = each->weighed.discrepancy.length,
                                        .probability_of_noise = each->weighed.probability_of_noise,
                                        .probability_of_declared = probability_of_declared_numbers(each->fitted),
                                        .at_optimum = each->is_at_optimum()});
    out.weighed.push_back(each->weighed);
    out.fits.push_back(&each->fitted);
  }
  for (WeighedHypothesis& each : out.posterior.hypotheses) each.probability /= sum;
  return out;
}

}  // namespace coilwright::measurement::identification
