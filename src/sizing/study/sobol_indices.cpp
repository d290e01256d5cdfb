#include "coilwright/sizing/study/sobol_indices.hpp"

#include <algorithm>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <cmath>
#include <cstddef>
#include <utility>

namespace coilwright::sizing {
namespace {

double variance_of(const std::vector<double>& values) {
  double mean = 0.0;
  for (const double value : values) mean += value;
  mean /= static_cast<double>(values.size());
  double sum = 0.0;
  for (const double value : values) sum += (value - mean) * (value - mean);
  return sum / static_cast<double>(values.size() - 1);
}

struct Pair {
  double first{};
  double total{};
};

// Jansen's sums over the rows of `chosen`.
Pair jansen(const SaltelliValues& values, const std::vector<double>& mixed, const std::vector<std::size_t>& chosen,
            double variance) {
  double first = 0.0;
  double total = 0.0;
  for (const std::size_t row : chosen) {
    first += (values.b[row] - mixed[row]) * (values.b[row] - mixed[row]);
    total += (values.a[row] - mixed[row]) * (values.a[row] - mixed[row]);
  }
  const double unit = 2.0 * static_cast<double>(chosen.size()) * variance;
  return {.first = 1.0 - first / unit, .total = total / unit};
}

double variance_of(const SaltelliValues& values, const std::vector<std::size_t>& chosen) {
  std::vector<double> all;
  for (const std::size_t row : chosen) {
    all.push_back(values.a[row]);
    all.push_back(values.b[row]);
  }
  return variance_of(all);
}

SobolIndex index_of(double value, std::vector<double> resampled) {
  constexpr double beyond = 0.025;  // of a 95 % interval, each side
  // The estimates of a share may lie beyond what a share can be.
  for (double& each : resampled) each = std::clamp(each, 0.0, 1.0);
  std::ranges::sort(resampled);
  const auto at = [&](double share) {
    return resampled[static_cast<std::size_t>(std::lround(share * static_cast<double>(resampled.size() - 1)))];
  };
  return {.value = std::clamp(value, 0.0, 1.0), .low = at(beyond), .high = at(1.0 - beyond)};
}

}  // namespace

std::optional<SobolIndices> sobol_indices(const SaltelliValues& values, std::uint64_t seed) {
  constexpr int resamples = 400;
  std::vector<std::size_t> all(values.a.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  const double variance = variance_of(values, all);
  double largest = 0.0;
  for (const double value : values.a) largest = std::max(largest, std::abs(value));
  constexpr double rounding = 1e-9;  // relative: what does not vary has no shares
  if (std::sqrt(variance) <= rounding * largest) return std::nullopt;
  std::vector<std::vector<double>> firsts(values.mixed.size());
  std::vector<std::vector<double>> totals(values.mixed.size());
  boost::random::mt19937_64 generator(seed);
  const boost::random::uniform_int_distribution<std::size_t> any(0, all.size() - 1);
  for (int resample = 0; resample < resamples; ++resample) {
    std::vector<std::size_t> rows(all.size());
    for (std::size_t& row : rows) row = any(generator);
    const double spread = variance_of(values, rows);
    for (std::size_t input = 0; input < values.mixed.size(); ++input) {
      const Pair pair = jansen(values, values.mixed[input], rows, spread);
      firsts[input].push_back(pair.first);
      totals[input].push_back(pair.total);
    }
  }
  SobolIndices out;
  for (std::size_t input = 0; input < values.mixed.size(); ++input) {
    const Pair pair = jansen(values, values.mixed[input], all, variance);
    out.first.push_back(index_of(pair.first, std::move(firsts[input])));
    out.total.push_back(index_of(pair.total, std::move(totals[input])));
  }
  return out;
}

}  // namespace coilwright::sizing
