#include "measurement/signals/spikes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace coilwright::measurement::signals {
namespace {

constexpr std::size_t neighbours = 4;  // to each side
constexpr std::size_t surroundings = 50;
constexpr std::size_t longest_spike = 3;
constexpr std::size_t fewest_values = 16;
constexpr double deviations = 6.0;
constexpr double normal_median = 0.67449;

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// How far a value lies from a straight line through its neighbours, whose slope is the median of those of all pairs
// (Theil 1950, Sen 1968).
double from_line(std::span<const double> values, std::size_t i, std::size_t from, std::size_t to) {
  std::vector<double> some;
  for (std::size_t k = from; k < to; ++k)
    for (std::size_t l = k + 1; l < to; ++l)
      if (k != i && l != i) some.push_back((values[l] - values[k]) / static_cast<double>(l - k));
  const double slope = median(some);
  some.clear();
  for (std::size_t k = from; k < to; ++k)
    if (k != i) some.push_back(values[k] + slope * (static_cast<double>(i) - static_cast<double>(k)));
  return values[i] - median(some);
}

// Each value beside the median of those around it. At an end these lie to one side, and what drifts is as far from them
// as a spike: it has to be apart from their straight line, too, which alone would be too uncertain.
std::vector<double> from_neighbours(std::span<const double> values) {
  std::vector<double> out(values.size());
  std::vector<double> around;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t from = std::min(i > neighbours ? i - neighbours : 0, values.size() - 2 * neighbours - 1);
    const std::size_t to = from + 2 * neighbours + 1;
    around.clear();
    for (std::size_t k = from; k < to; ++k)
      if (k != i) around.push_back(values[k]);
    out[i] = values[i] - median(around);
    if (from + neighbours == i) continue;
    if (const double apart = from_line(values, i, from, to); std::abs(apart) < std::abs(out[i])) out[i] = apart;
  }
  return out;
}

// What lasts longer is an event, not a spike.
void drop_events(std::vector<char>& found) {
  for (std::size_t i = 0; i < found.size(); ++i) {
    std::size_t end = i;
    while (end < found.size() && found[end] != 0) ++end;
    if (end - i > longest_spike)
      std::fill(found.begin() + static_cast<std::ptrdiff_t>(i), found.begin() + static_cast<std::ptrdiff_t>(end),
                char{0});
    i = std::max(i, end);
  }
}

}  // namespace

std::vector<char> spikes(std::span<const double> values, double least) {
  std::vector<char> out(values.size(), 0);
  if (values.size() < fewest_values) return out;
  const std::vector<double> apart = from_neighbours(values);
  std::vector<double> sizes;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t from = i > surroundings ? i - surroundings : 0;
    const std::size_t to = std::min(i + surroundings + 1, values.size());
    // Cheap to refuse: almost every value.
    if (std::abs(apart[i]) <= deviations * least) continue;
    sizes.clear();
    for (std::size_t k = from; k < to; ++k) sizes.push_back(std::abs(apart[k]));
    const double scale = std::max(median(sizes) / normal_median, least);
    out[i] = scale > 0.0 && std::abs(apart[i]) > deviations * scale ? 1 : 0;
  }
  drop_events(out);
  return out;
}

std::vector<char> far_values(std::span<const double> values, double least, double most) {
  constexpr double far = 4.0;  // standard deviations
  std::vector<char> out(values.size(), 0);
  if (values.empty()) return out;
  std::vector<double> sizes;
  for (const double value : values) sizes.push_back(std::abs(value));
  const double limit = far * std::max(median(sizes) / normal_median, least);
  for (std::size_t i = 0; i < values.size(); ++i) out[i] = std::abs(values[i]) > limit ? 1 : 0;
  drop_events(out);
  const auto count = static_cast<double>(std::ranges::count(out, 1));
  if (count > most * static_cast<double>(out.size())) std::ranges::fill(out, char{0});
  return out;
}

std::vector<double> without_spikes(std::vector<double> values) {
  const std::vector<char> found = spikes(values);
  const std::size_t n = values.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (found[i] == 0) continue;
    std::size_t end = i;
    while (end < n && found[end] != 0) ++end;
    const double left = i > 0 ? values[i - 1] : (end < n ? values[end] : 0.0);
    const double right = end < n ? values[end] : left;
    for (std::size_t k = i; k < end; ++k)
      values[k] = left + (right - left) * static_cast<double>(k - i + 1) / static_cast<double>(end - i + 1);
    i = end;
  }
  return values;
}

}  // namespace coilwright::measurement::signals
