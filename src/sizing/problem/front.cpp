#include "coilwright/sizing/problem/front.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <stdexcept>

namespace coilwright::sizing {
namespace {

bool no_worse(std::span<const double> a, std::span<const double> b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] > b[i]) return false;
  }
  return true;
}

// In lexicographic order every point comes after those that dominate it, so one pass against the kept ones is enough.
std::vector<std::size_t> lexicographic_order(const std::vector<Objectives>& points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return points[a] < points[b]; });
  return order;
}

std::vector<std::size_t> non_dominated_2d(const std::vector<Objectives>& points) {
  std::vector<std::size_t> kept;
  double best_second = std::numeric_limits<double>::infinity();
  for (const std::size_t i : lexicographic_order(points)) {
    if (points[i][1] >= best_second) continue;
    best_second = points[i][1];
    kept.push_back(i);
  }
  return kept;
}

// Area below the reference corner, grown point by point. Keys: first objective; values: second, strictly falling.
class Staircase {
 public:
  Staircase(double first_reference, double second_reference) : first_{first_reference}, second_{second_reference} {}

  void add(double first, double second) {
    auto after = steps_.upper_bound(first);
    double ceiling = after == steps_.begin() ? second_ : std::prev(after)->second;
    if (ceiling <= second) return;
    // The new corner adds the strips between the steps that it covers, each up to the old ceiling.
    double left = first;
    auto it = steps_.lower_bound(first);
    while (it != steps_.end() && it->second >= second) {
      area_ += (it->first - left) * (ceiling - second);
      left = it->first;
      ceiling = it->second;
      it = steps_.erase(it);
    }
    const double right = it == steps_.end() ? first_ : it->first;
    area_ += (right - left) * (ceiling - second);
    steps_.emplace(first, second);
  }

  [[nodiscard]] double area() const { return area_; }

 private:
  double first_, second_;
  double area_ = 0;
  std::map<double, double> steps_;
};

double hypervolume_1d(const std::vector<Objectives>& points, double reference) {
  double best = reference;
  for (const Objectives& point : points) best = std::min(best, point[0]);
  return reference - best;
}

double hypervolume_2d(const std::vector<Objectives>& points, std::span<const double> reference) {
  Staircase staircase{reference[0], reference[1]};
  for (const Objectives& point : points) staircase.add(point[0], point[1]);
  return staircase.area();
}

double hypervolume_3d(std::vector<Objectives> points, std::span<const double> reference) {
  std::ranges::sort(points, {}, [](const Objectives& point) { return point[2]; });
  Staircase staircase{reference[0], reference[1]};
  double volume = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    staircase.add(points[i][0], points[i][1]);
    const double next = i + 1 < points.size() ? points[i + 1][2] : reference[2];
    volume += staircase.area() * (next - points[i][2]);
  }
  return volume;
}

}  // namespace

bool dominates(std::span<const double> a, std::span<const double> b) {
  return no_worse(a, b) && !std::ranges::equal(a, b);
}

std::vector<std::size_t> non_dominated(const std::vector<Objectives>& points) {
  std::vector<std::size_t> kept;
  if (!points.empty() && points.front().size() == 2) {
    kept = non_dominated_2d(points);
  } else {
    for (const std::size_t i : lexicographic_order(points)) {
      if (std::ranges::none_of(kept, [&](std::size_t k) { return no_worse(points[k], points[i]); })) kept.push_back(i);
    }
  }
  std::ranges::sort(kept);
  return kept;
}

double hypervolume(const std::vector<Objectives>& points, std::span<const double> reference) {
  const std::size_t count = reference.size();
  if (count < 1 || count > 3) {
    throw std::invalid_argument(fmt::format("reference: must have 1, 2 or 3 objectives; got {}", count));
  }
  std::vector<Objectives> inside;
  for (const Objectives& point : points) {
    if (point.size() != count) {
      throw std::invalid_argument(fmt::format("points: must have {} objectives each; got {}", count, point.size()));
    }
    bool below = true;
    for (std::size_t i = 0; i < count; ++i) below = below && point[i] < reference[i];
    if (below) inside.push_back(point);
  }
  if (count == 1) return hypervolume_1d(inside, reference[0]);
  if (count == 2) return hypervolume_2d(inside, reference);
  return hypervolume_3d(std::move(inside), reference);
}

FrontFrame frame_of(const std::vector<Objectives>& points) {
  if (points.empty()) throw std::invalid_argument("points: must hold at least one; got none");
  FrontFrame frame;
  for (const std::size_t i : non_dominated(points)) {
    const Objectives& point = points[i];
    if (frame.ideal.empty()) frame = {.ideal = point, .nadir = point};
    for (std::size_t k = 0; k < point.size(); ++k) {
      frame.ideal[k] = std::min(frame.ideal[k], point[k]);
      frame.nadir[k] = std::max(frame.nadir[k], point[k]);
    }
  }
  return frame;
}

double normalised_hypervolume(const std::vector<Objectives>& points, const FrontFrame& frame) {
  constexpr double reference = 1.1;
  std::vector<Objectives> scaled = points;
  for (Objectives& point : scaled) {
    for (std::size_t k = 0; k < point.size(); ++k) {
      const double range = frame.nadir.at(k) - frame.ideal.at(k);
      point[k] = (point[k] - frame.ideal[k]) / (range > 0 ? range : 1.0);
    }
  }
  return hypervolume(scaled, std::vector<double>(frame.ideal.size(), reference));
}

}  // namespace coilwright::sizing
