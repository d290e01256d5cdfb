#include "measurement/compare/many_valleys.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "measurement/compare/search_effort.hpp"

namespace coilwright::measurement::compare {

fit::Counted<std::optional<FittedHypothesis>> ManyValleys::look_for(std::span<const replay::PreparedRun> runs,
                                                                    const FittedHypothesis& fitted,
                                                                    const std::vector<Estimate>& estimates,
                                                                    double overdispersion) {
  fit::Counted<std::optional<FittedHypothesis>> out;
  if (searches_ == search_effort.valley_searches) return out;
  ++searches_;
  for (std::size_t effect = 0; effect < fitted.hypothesis.effects().size(); ++effect) {
    const auto numbers = fitted.hypothesis.effects()[effect].kind->parameters();
    const fit::Hypothesis::EffectParameters& varied = fitted.hypothesis.parameters_of(effect);
    for (std::size_t k = 0; k < varied.numbers.size(); ++k) {
      const Eigen::Index parameter = varied.first + static_cast<Eigen::Index>(k);
      const double absent = numbers[varied.numbers[k]].absent.value_or(0.0);
      if (!are_along(parameter) && !is_suspiciously_narrow(estimates[static_cast<std::size_t>(parameter)], absent))
        continue;
      Valleys found = valleys_along(runs, fitted, parameter, absent, overdispersion);
      out.simulated_runs += found.simulated_runs;
      if (found.ends) ends_.insert_or_assign(parameter, *found.ends);
      if (!found.better) continue;
      if (!out.value || found.better->fit.objective() < out.value->fit.objective()) out.value = std::move(found.better);
    }
  }
  return out;
}

void ManyValleys::set_intervals(std::vector<Estimate>& estimates) const {
  for (const auto& [parameter, ends] : ends_) {
    Estimate& estimate = estimates[static_cast<std::size_t>(parameter)];
    estimate.lower = std::min(estimate.value, ends.lower);
    estimate.upper = std::max(estimate.value, ends.upper);
    estimate.determined = std::isfinite(estimate.lower) || std::isfinite(estimate.upper);
    estimate.has_many_optima = true;
  }
}

}  // namespace coilwright::measurement::compare
