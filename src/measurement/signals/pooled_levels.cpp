#include "measurement/signals/pooled_levels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/special_functions/digamma.hpp>
#include <boost/math/special_functions/trigamma.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace coilwright::measurement::signals {
namespace {

constexpr std::size_t fewest_levels = 3;
constexpr double chance = 0.01;  // that one of all levels lies outside, in both tails together
constexpr int most_rounds = 20;

double variance(const NoiseLevel& level) {
  return level.sigma * level.sigma;
}

// Half of the freedom lies on runs with a smaller variance.
double weighted_median_variance(std::vector<NoiseLevel*> levels) {
  std::ranges::sort(levels, {}, [](const NoiseLevel* level) { return level->sigma; });
  double half = 0.0;
  for (const NoiseLevel* level : levels) half += 0.5 * level->freedom;
  for (const NoiseLevel* level : levels) {
    half -= level->freedom;
    if (half <= 0.0) return variance(*level);
  }
  return variance(*levels.back());
}

// `probability`: that chance alone has it further off.
bool agrees(const NoiseLevel& level, double common, double probability) {
  const boost::math::chi_squared distribution(level.freedom);
  const double energy = level.freedom * variance(level) / common;
  return energy >= boost::math::quantile(distribution, 0.5 * probability) &&
         energy <= boost::math::quantile(boost::math::complement(distribution, 0.5 * probability));
}

double mean_variance(const std::vector<NoiseLevel*>& levels) {
  double energy = 0.0;
  double freedom = 0.0;
  for (const NoiseLevel* level : levels) {
    energy += level->freedom * variance(*level);
    freedom += level->freedom;
  }
  return energy / freedom;
}

// Those that agree with the mean of those that agree.
std::vector<NoiseLevel*> agreeing(const std::vector<NoiseLevel*>& all) {
  const double probability = chance / static_cast<double>(all.size());
  double common = weighted_median_variance(all);
  std::vector<NoiseLevel*> found;
  for (int round = 0; round < most_rounds; ++round) {
    std::vector<NoiseLevel*> next;
    for (NoiseLevel* level : all)
      if (agrees(*level, common, probability)) next.push_back(level);
    if (next.size() < fewest_levels) return {};
    if (next == found) break;
    found = std::move(next);
    common = mean_variance(found);
  }
  return found;
}

// Freedom of the distribution from which the runs' variances come, by the scatter of their logarithms beyond that of
// chi-square; infinite where there is none.
double freedom_of_scatter(const std::vector<NoiseLevel*>& levels) {
  std::vector<double> logarithms;
  double mean = 0.0;
  double by_chance = 0.0;
  for (const NoiseLevel* level : levels) {
    const double half = 0.5 * level->freedom;
    logarithms.push_back(std::log(variance(*level)) - boost::math::digamma(half) + std::log(half));
    mean += logarithms.back() / static_cast<double>(levels.size());
    by_chance += boost::math::trigamma(half) / static_cast<double>(levels.size());
  }
  double scatter = 0.0;
  for (const double each : logarithms)
    scatter += (each - mean) * (each - mean) / static_cast<double>(levels.size() - 1);
  const double beyond = scatter - by_chance;
  constexpr double least_freedom = 0.1;
  constexpr double most_freedom = 1e6;
  const auto excess = [&](double freedom) { return boost::math::trigamma(0.5 * freedom) - beyond; };
  if (excess(most_freedom) >= 0.0) return std::numeric_limits<double>::infinity();
  if (excess(least_freedom) <= 0.0) return least_freedom;
  std::uintmax_t steps = 100;
  const auto [below, above] = boost::math::tools::toms748_solve(excess, least_freedom, most_freedom,
                                                                boost::math::tools::eps_tolerance<double>(40), steps);
  return 0.5 * (below + above);
}

}  // namespace

void pool_levels(std::span<NoiseLevel* const> levels) {
  std::vector<NoiseLevel*> all(levels.begin(), levels.end());
  if (all.size() < fewest_levels) return;
  const std::vector<NoiseLevel*> found = agreeing(all);
  if (found.empty()) return;
  const double common = mean_variance(found);
  const double scatter = freedom_of_scatter(found);
  double together = 0.0;
  for (const NoiseLevel* level : found) together += level->freedom;
  for (NoiseLevel* level : found) {
    const double own = level->freedom;
    const double others = std::min(scatter, together - own);
    const double share = std::isinf(scatter) ? 1.0 : scatter / (scatter + own);
    level->sigma = std::max(std::sqrt(share * common + (1.0 - share) * variance(*level)), level->of_rounding());
    level->freedom = own + others;
    level->pooled = others > own;
    level->source = fmt::format("{}, drawn to that of {} runs that agree", level->source, found.size());
  }
}

}  // namespace coilwright::measurement::signals
