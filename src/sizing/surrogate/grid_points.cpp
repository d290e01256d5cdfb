#include "sizing/surrogate/grid_points.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "sizing/sampling/eigen_vectors.hpp"

namespace coilwright::sizing {

using Point = std::vector<double>;

std::vector<Point> grid_points_near(const DesignSpace& space, const Eigen::VectorXd& optimum) {
  // Axes with a grid, first those in which the optimum is farthest from a grid value.
  std::vector<std::pair<double, std::size_t>> axes;
  for (std::size_t axis = 0; axis < space.dimension(); ++axis) {
    const double spacing = space.spacing(axis);
    if (spacing == 0) continue;
    const double position = optimum[static_cast<Eigen::Index>(axis)] / spacing;
    axes.emplace_back(-std::abs(position - std::round(position)), axis);
  }
  std::ranges::sort(axes);
  const std::size_t corner_axes = std::min<std::size_t>(axes.size(), 5);
  std::vector<Point> points;
  for (std::size_t mask = 0; mask < (std::size_t{1} << corner_axes); ++mask) {
    Point point = as_std(optimum);
    for (std::size_t c = 0; c < corner_axes; ++c) {
      const std::size_t axis = axes[c].second;
      const double spacing = space.spacing(axis), position = point[axis] / spacing;
      point[axis] = ((mask >> c & 1U) != 0 ? std::ceil(position) : std::floor(position)) * spacing;
    }
    points.push_back(space.snapped(point));
  }
  for (const auto& [distance, axis] : axes) {
    for (const double step : {-1.0, 1.0}) {
      Point point = space.snapped(as_std(optimum));
      point[axis] += step * space.spacing(axis);
      points.push_back(space.snapped(point));
    }
  }
  return points;
}

std::vector<Point> grid_neighbours(const DesignSpace& space, const Point& centre) {
  std::vector<Point> points;
  const std::size_t n = space.dimension();
  for (std::size_t a = 0; a < n; ++a) {
    if (space.spacing(a) == 0) continue;
    for (const double first : {-2.0, -1.0, 1.0, 2.0}) {
      Point point = centre;
      point[a] += first * space.spacing(a);
      points.push_back(space.snapped(point));
      for (std::size_t b = a + 1; b < n; ++b) {
        if (space.spacing(b) == 0) continue;
        for (const double second : {-1.0, 1.0}) {
          Point both = point;
          both[b] += second * space.spacing(b);
          points.push_back(space.snapped(both));
        }
      }
    }
  }
  return points;
}

}  // namespace coilwright::sizing
