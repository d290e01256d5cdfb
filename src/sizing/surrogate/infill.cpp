#include "sizing/surrogate/infill.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <random>
#include <utility>

#include "sizing/sampling/eigen_vectors.hpp"
#include "sizing/sampling/random.hpp"
#include "sizing/surrogate/grid_points.hpp"
#include "sizing/surrogate/local_model.hpp"

namespace coilwright::sizing {
namespace {

// A design nearer than this to a known one (in the unit cube) adds no information.
constexpr double same_design = 1e-7;
// How far above the value to beat the merit of a grid point may lie (1 is the size of a gap): from one grid point to
// the next, quantities jump by more than a model can predict.
constexpr double grid_tolerance = 0.5;
// Random starts are ranked by the model (4 us each); SLSQP runs from the best two only.
constexpr std::size_t random_starts = 40;
// Pairs of grid steps are ranked up to this number of axes: 400 points, 2 ms.
constexpr std::size_t max_axes_for_pairs = 10;

// A coordinate this near to an end of its range, relative to the width of the model's box, may be meant to be there.
constexpr double near_range_end = 0.1;

using Point = std::vector<double>;

std::vector<Eigen::Index> axes_where(const DesignSpace& space, bool (*wanted)(double spacing)) {
  std::vector<Eigen::Index> axes;
  for (std::size_t axis = 0; axis < space.dimension(); ++axis) {
    if (wanted(space.spacing(axis))) axes.push_back(static_cast<Eigen::Index>(axis));
  }
  return axes;
}

struct RankedPoint {
  double merit;
  Point unit;
};

// The points without those that are known, each once, in ascending order.
std::vector<Point> unknown_of(std::vector<Point> points, const Samples& samples, std::uint64_t combination) {
  std::ranges::sort(points);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  std::erase_if(points, [&](const Point& point) { return samples.knows(point, combination); });
  return points;
}

std::vector<Point> grid_candidates(const Samples& samples, const Region& region, const Eigen::VectorXd& optimum) {
  const DesignSpace& space = samples.space();
  std::vector<Point> points = grid_points_near(space, optimum);
  if (space.dimension() <= max_axes_for_pairs) {
    const auto append_neighbours = [&](std::size_t index) {
      for (Point& point : grid_neighbours(space, at_level(region, samples[index]))) points.push_back(std::move(point));
    };
    append_neighbours(region.from);
    if (region.to != region.from) append_neighbours(region.to);
  }
  if (region.level) {
    // Captured by value under new names: Clang 14 does not capture structured bindings.
    const auto [level_axis, level_value] = *region.level;
    std::erase_if(points, [&space, axis = level_axis, value = level_value](const Point& point) {
      return std::abs(point[axis] - value) > 0.5 * space.spacing(axis);
    });
  }
  return unknown_of(std::move(points), samples, samples[region.from].combination);
}

// Unknown grid points by the merit of the model, best first; axes without a grid are optimised again for the best
// three.
std::vector<RankedPoint> rank_on_grid(const Samples& samples, const LocalModel& model, const Region& region,
                                      const Eigen::VectorXd& optimum) {
  const DesignSpace& space = samples.space();
  std::vector<RankedPoint> ranked;
  for (Point& point : grid_candidates(samples, region, optimum))
    ranked.push_back({.merit = model.merit(as_vector(point)), .unit = std::move(point)});
  std::ranges::stable_sort(ranked, {}, &RankedPoint::merit);
  const std::vector<Eigen::Index> without_grid = axes_where(space, [](double spacing) { return spacing == 0; });
  if (without_grid.empty()) return ranked;
  ranked.resize(std::min<std::size_t>(ranked.size(), 3));
  for (RankedPoint& entry : ranked) {
    const Eigen::VectorXd moved = model.minimise(as_vector(entry.unit), without_grid);
    const double merit = model.merit(moved);
    if (merit < entry.merit) entry = {.merit = merit, .unit = space.snapped(as_std(moved))};
  }
  std::ranges::stable_sort(ranked, {}, &RankedPoint::merit);
  return ranked;
}

// The ends and the middle of the region's segment, and random points of the model's box.
std::vector<Eigen::VectorXd> starts_in(const Samples& samples, const LocalModel& model, const Region& region) {
  std::vector<Eigen::VectorXd> starts{as_vector(at_level(region, samples[region.from]))};
  if (region.to != region.from) {
    starts.emplace_back(as_vector(at_level(region, samples[region.to])));
    starts.emplace_back(0.5 * (starts[0] + starts[1]));
  }
  if (region.seed == 0) return starts;
  std::mt19937_64 random{region.seed};
  for (std::size_t i = 0; i < random_starts; ++i) {
    Eigen::VectorXd x(starts[0].size());
    for (Eigen::Index axis = 0; axis < x.size(); ++axis) {
      x[axis] = std::lerp(model.box().lower[axis], model.box().upper[axis], uniform(random));
    }
    if (region.level) x[static_cast<Eigen::Index>(region.level->axis)] = region.level->value;
    starts.push_back(std::move(x));
  }
  return starts;
}

struct Optimum {
  Eigen::VectorXd point;
  double merit = std::numeric_limits<double>::infinity();
};

// The optimum of the goal on the model, from the two starts of best merit; nothing if no merit is finite.
std::optional<Optimum> optimum_of(const LocalModel& model, const Goal& goal, std::vector<Eigen::VectorXd> starts,
                                  const std::vector<Eigen::Index>& axes) {
  std::ranges::stable_sort(starts, {}, [&](const Eigen::VectorXd& x) { return model.merit(x); });
  starts.resize(std::min<std::size_t>(starts.size(), 2));
  Optimum best;
  for (const Eigen::VectorXd& start : starts) {
    const Eigen::VectorXd x = model.minimise(start, axes);
    const double merit = model.merit(x);
    if (merit < best.merit) best = {.point = x, .merit = merit};
    if (best.merit < goal.to_beat) break;
  }
  if (best.point.size() == 0) return std::nullopt;
  return best;
}

// The optimum with every coordinate that lies near an end of its range moved there, unless the model then loses more
// than a small part of the progress.
Optimum at_range_ends(const LocalModel& model, const DesignSpace& space, const Goal& goal, Optimum optimum) {
  Eigen::VectorXd moved = optimum.point;
  for (Eigen::Index axis = 0; axis < moved.size(); ++axis) {
    const double ceiling = space.ceiling(static_cast<std::size_t>(axis));
    const double near = near_range_end * (model.box().upper[axis] - model.box().lower[axis]);
    if (moved[axis] < near) moved[axis] = 0;
    if (moved[axis] > ceiling - near) moved[axis] = ceiling;
  }
  if (moved == optimum.point) return optimum;
  const double merit = model.merit(moved);
  if (merit > optimum.merit + 0.1 * std::max(0.0, goal.to_beat - optimum.merit)) return optimum;
  return {.point = std::move(moved), .merit = merit};
}

bool near_known(const Samples& samples, const std::vector<std::size_t>& nodes, const Point& unit) {
  return std::ranges::any_of(nodes, [&](std::size_t i) {
    return (as_vector(samples[i].unit) - as_vector(unit)).cwiseAbs().maxCoeff() < same_design;
  });
}

// Between the sample that the region starts from and, of the designs of the front on the other side of the goal's
// centre, the nearest in the variables, where a straight line between their objectives comes nearest to the centre. No
// model is asked, so that a gap between two near designs closes even where objectives turn faster than a model can
// follow.
std::vector<UnitPoint> interpolated(const Samples& samples, const Goal& goal, const Region& region) {
  const Sample& from = samples[region.from];
  const std::size_t objectives = from.values.size();
  const auto relative = [&](const Sample& sample, std::size_t i) {
    return (sample.values[i] - goal.origin[i]) / goal.span[i] - 0.5;
  };
  std::optional<std::size_t> across;
  double nearest = std::numeric_limits<double>::infinity();
  for (const std::size_t index : samples.front()) {
    const Sample& other = samples[index];
    if (other.combination != from.combination) continue;
    double product = 0;
    for (std::size_t i = 0; i < objectives; ++i) product += relative(from, i) * relative(other, i);
    if (product >= 0) continue;
    const double distance = (as_vector(other.unit) - as_vector(from.unit)).squaredNorm();
    if (distance >= nearest) continue;
    nearest = distance;
    across = index;
  }
  if (!across) return {};
  const Sample& to = samples[*across];
  double along = 0, length = 0;
  for (std::size_t i = 0; i < objectives; ++i) {
    const double step = relative(to, i) - relative(from, i);
    along -= step * relative(from, i);
    length += step * step;
  }
  const double fraction = std::clamp(length > 0 ? along / length : 0.5, 0.1, 0.9);
  const Eigen::VectorXd between = as_vector(from.unit) + fraction * (as_vector(to.unit) - as_vector(from.unit));
  UnitPoint point{.unit = samples.space().snapped(as_std(between)), .combination = from.combination};
  if (std::sqrt(nearest) < same_design || samples.rules_out(point.unit, point.combination)) return {};
  return {std::move(point)};
}

}  // namespace

std::vector<UnitPoint> infill(const Samples& samples, const Goal& goal, const Region& region) {
  const DesignSpace& space = samples.space();
  if (space.dimension() == 0) return {};
  if (region.interpolated) return interpolated(samples, goal, region);
  const LocalModel model{samples, goal, region};
  if (!model.usable()) return {};
  std::vector<Eigen::Index> axes = axes_where(space, [](double) { return true; });
  if (region.level) std::erase(axes, static_cast<Eigen::Index>(region.level->axis));
  if (axes.empty()) return {};
  std::optional<Optimum> optimum = optimum_of(model, goal, starts_in(samples, model, region), axes);
  if (!optimum) return {};
  if (space.is_wide()) optimum = at_range_ends(model, space, goal, *std::move(optimum));
  std::vector<RankedPoint> ranked;
  if (space.has_grid()) {
    ranked = rank_on_grid(samples, model, region, optimum->point);
  } else {
    ranked.push_back({.merit = optimum->merit, .unit = space.snapped(as_std(optimum->point))});
  }
  const double tolerance = space.has_grid() && goal.kind == Goal::Kind::gap ? grid_tolerance : 0.0;
  double bound = goal.to_beat + tolerance;
  if (region.level && !ranked.empty() && ranked.front().merit >= bound) {
    // Few designs of this level may be known: the model improves there only if something is evaluated.
    for (RankedPoint& entry : ranked) entry.merit = model.required_error(as_vector(entry.unit));
    std::ranges::stable_sort(ranked, {}, &RankedPoint::merit);
    bound = std::numeric_limits<double>::infinity();
  }
  const std::uint64_t combination = samples[region.from].combination;
  std::vector<UnitPoint> result;
  for (RankedPoint& entry : ranked) {
    if (entry.merit >= bound || result.size() == 3) break;
    if (samples.rules_out(entry.unit, combination) || near_known(samples, model.nodes(), entry.unit)) continue;
    result.push_back({.unit = std::move(entry.unit), .combination = combination});
  }
  return result;
}

std::vector<UnitPoint> least_surprising_neighbours(const Samples& samples, const Goal& goal, std::size_t index,
                                                   std::size_t count) {
  const DesignSpace& space = samples.space();
  if (!space.has_grid() || space.dimension() > max_axes_for_pairs) return {};
  const LocalModel model{samples, goal, {.from = index, .to = index}};
  if (!model.usable()) return {};
  const std::uint64_t combination = samples[index].combination;
  std::vector<RankedPoint> ranked;
  for (Point& point : unknown_of(grid_neighbours(space, samples[index].unit), samples, combination))
    ranked.push_back({.merit = model.required_error(as_vector(point)), .unit = std::move(point)});
  std::ranges::stable_sort(ranked, {}, &RankedPoint::merit);
  std::vector<UnitPoint> result;
  for (RankedPoint& entry : ranked) {
    if (result.size() == count) break;
    if (samples.rules_out(entry.unit, combination)) continue;
    result.push_back({.unit = std::move(entry.unit), .combination = combination});
  }
  return result;
}

}  // namespace coilwright::sizing
