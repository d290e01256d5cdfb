#include "coilwright/sizing/study/sweep_summary.hpp"

#include <algorithm>

#include "coilwright/sizing/problem/archive.hpp"

namespace coilwright::sizing {

std::string_view name_of(Keep keep) {
  return std::ranges::find(keep_words, keep, &std::pair<std::string_view, Keep>::second)->first;
}

void QuantityTotal::add(double value) {
  QuantityTotal one{.designs = 1, .least = value, .greatest = value};
  one.sum.add(value);
  add(one);
}

void QuantityTotal::add(const QuantityTotal& other) {
  if (other.designs == 0) return;
  least = designs == 0 ? other.least : std::min(least, other.least);
  greatest = designs == 0 ? other.greatest : std::max(greatest, other.greatest);
  designs += other.designs;
  sum.add(other.sum);
}

SweepSummary::SweepSummary(const DesignProblem& problem, Keep keep)
    : problem_(problem), searched_(problem.problem()), keep_(keep), leaders_(problem) {
  if (keep != Keep::all) totals_.quantities.resize(problem.study().quantities.size());
}

void SweepSummary::consider(const SweptDesign& design) {
  ++totals_.designs;
  if (is_feasible(design.evaluation)) ++totals_.ok;
  for (std::size_t i = 0; i < totals_.quantities.size() && i < design.evaluation.quantities.size(); ++i)
    if (const std::optional<double>& value = design.evaluation.quantities[i]) totals_.quantities[i].add(*value);
  keep(design);
}

// Of what a part did not keep, nothing leads in the part, and so nothing in the whole.
void SweepSummary::consider(const SweepTotals& totals, std::span<const SweptDesign> kept) {
  totals_.designs += totals.designs;
  totals_.ok += totals.ok;
  for (std::size_t i = 0; i < totals_.quantities.size() && i < totals.quantities.size(); ++i)
    totals_.quantities[i].add(totals.quantities[i]);
  for (const SweptDesign& design : kept) keep(design);
}

void SweepSummary::keep(const SweptDesign& design) {
  leaders_.consider(design);
  if (keep_ != Keep::front || !is_feasible(design.evaluation)) return;
  const Objectives its = minimised(searched_, design.evaluation);
  const auto beats = [&](const Objectives& one, const Objectives& other) {
    return one == other || dominates(one, other);
  };
  if (std::ranges::any_of(front_,
                          [&](const SweptDesign& each) { return beats(minimised(searched_, each.evaluation), its); }))
    return;
  std::erase_if(front_, [&](const SweptDesign& each) { return dominates(its, minimised(searched_, each.evaluation)); });
  front_.push_back(design);
}

bool SweepSummary::is_row(const SweptDesign& design) const {
  return keep_ == Keep::all || (keep_ == Keep::feasible && is_feasible(design.evaluation));
}

std::vector<SweptDesign> SweepSummary::kept() const {
  std::vector<SweptDesign> out = front_;
  for (const Leader& leader : leaders_.all()) out.push_back(leader.design);
  std::ranges::sort(out, {}, &SweptDesign::index);
  // Not of std::ranges: Clang 14 does not take it from this standard library.
  const auto is_same = [](const SweptDesign& a, const SweptDesign& b) { return a.index == b.index; };
  out.erase(std::unique(out.begin(), out.end(), is_same), out.end());
  return out;
}

}  // namespace coilwright::sizing
