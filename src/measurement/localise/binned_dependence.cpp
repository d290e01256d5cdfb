#include "measurement/localise/binned_dependence.hpp"

#include <algorithm>
#include <utility>

namespace coilwright::measurement::localise {
namespace {

constexpr std::size_t most_bins = 20;

// Upper edges of all bins but the last.
std::vector<double> bin_edges(std::span<const double> variable) {
  std::vector<double> sorted(variable.begin(), variable.end());
  std::sort(sorted.begin(), sorted.end());
  std::vector<double> distinct;
  for (const double value : sorted)
    if (distinct.empty() || value > distinct.back()) {
      distinct.push_back(value);
      if (distinct.size() > most_bins) break;
    }
  std::vector<double> edges;
  if (distinct.size() <= most_bins) {
    for (std::size_t i = 1; i < distinct.size(); ++i) edges.push_back(0.5 * (distinct[i - 1] + distinct[i]));
    return edges;
  }
  for (std::size_t b = 1; b < most_bins; ++b) {
    const double edge = sorted[b * sorted.size() / most_bins];
    if (edge > sorted.front() && (edges.empty() || edge > edges.back())) edges.push_back(edge);
  }
  return edges;
}

std::size_t bin_of(const std::vector<double>& edges, double value) {
  return static_cast<std::size_t>(std::upper_bound(edges.begin(), edges.end(), value) - edges.begin());
}

struct Mean {
  double sum{};
  double count{};
  void add(double value) {
    sum += value;
    count += 1.0;
  }
  [[nodiscard]] double value() const { return count > 0.0 ? sum / count : 0.0; }
};

// Mean of each bin. A bin without samples takes the linear interpolation between the nearest bins that have samples, or
// the value of the nearest one at either end.
std::vector<double> curve_of(const std::vector<Mean>& bins) {
  std::vector<double> curve(bins.size(), 0.0);
  std::size_t last = bins.size();  // the last bin with samples; none yet
  for (std::size_t b = 0; b < bins.size(); ++b) {
    if (bins[b].count == 0.0) continue;
    curve[b] = bins[b].value();
    const bool is_first = last == bins.size();
    for (std::size_t gap = is_first ? 0 : last + 1; gap < b; ++gap) {
      const double share = is_first ? 1.0 : static_cast<double>(gap - last) / static_cast<double>(b - last);
      curve[gap] = (is_first ? 0.0 : (1.0 - share) * curve[last]) + share * curve[b];
    }
    last = b;
  }
  for (std::size_t b = last; last < bins.size() && b < bins.size(); ++b) curve[b] = curve[last];
  return curve;
}

}  // namespace

Dependence binned_dependence(std::string name, std::span<const double> variable, std::span<const double> torque,
                             const SampleBlocks& blocks) {
  Dependence result{.variable = std::move(name)};
  const std::vector<double> edges = bin_edges(variable);
  if (edges.empty()) return result;
  const std::size_t bins = edges.size() + 1;

  std::vector<Mean> half[2]{std::vector<Mean>(bins), std::vector<Mean>(bins)};
  std::vector<Mean> place(bins);
  Mean whole[2];
  std::vector<std::size_t> bin(variable.size());
  for (std::size_t i = 0; i < variable.size(); ++i) {
    bin[i] = bin_of(edges, variable[i]);
    const std::size_t parity = blocks.number[i] % 2;
    half[parity][bin[i]].add(torque[i]);
    whole[parity].add(torque[i]);
    place[bin[i]].add(variable[i]);
  }
  const std::vector<double> curve[2]{curve_of(half[0]), curve_of(half[1])};
  double left = 0.0;
  double all = 0.0;
  for (std::size_t i = 0; i < variable.size(); ++i) {
    const std::size_t other = 1 - blocks.number[i] % 2;
    const double mean = whole[other].value();
    const double missed = torque[i] - curve[other][bin[i]];
    left += missed * missed;
    all += (torque[i] - mean) * (torque[i] - mean);
  }
  if (whole[0].count > 0.0 && whole[1].count > 0.0 && all > 0.0) result.explained = std::max(1.0 - left / all, 0.0);
  for (std::size_t b = 0; b < bins; ++b) {
    if (place[b].count == 0.0) continue;
    result.at.push_back(place[b].value());
    result.residual.push_back((half[0][b].sum + half[1][b].sum) / place[b].count);
  }
  return result;
}

}  // namespace coilwright::measurement::localise
