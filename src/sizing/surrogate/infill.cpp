#include "sizing/surrogate/infill.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <random>

#include "sizing/nlopt/goal_program.hpp"
#include "sizing/sampling/random.hpp"
#include "sizing/surrogate/surrogate.hpp"

namespace coilwright::sizing {
namespace {

// The model's constraints are asked to hold with this to spare (in their scale): the optimum sits on them, and the
// model is off by a rounding or two.
constexpr double model_margin = 1e-6;
// A design nearer than this (unit cube) to a known one would tell nothing new.
constexpr double same_design = 1e-7;
// Range of a constraint over a model's nodes from which on it is compressed; constraints are scaled to order 1.
constexpr double steep = 50.0;
// How far short of its goal a grid point may be expected to fall and still be worth a look: from point to point of a
// grid quantities jump more than a model can tell (1 is the size of the gap).
constexpr double grid_doubt = 0.5;
// Random starts: ranked by the model (4 us each), only the best two are descended from.
constexpr std::size_t random_starts = 40;
// Pairs of grid steps are ranked up to this many axes: 400 points, 2 ms.
constexpr std::size_t most_axes_in_pairs = 10;

Eigen::Map<const Eigen::VectorXd> as_vector(const std::vector<double>& values) {
  return {values.data(), static_cast<Eigen::Index>(values.size())};
}

std::vector<double> as_std(const Eigen::VectorXd& values) {
  return {values.begin(), values.end()};
}

// Enough nodes for a full quadratic and half as many again, within what a factorisation costs (100 nodes: 0.2 ms).
std::size_t node_count(std::size_t dimension) {
  const std::size_t quadratic = (dimension + 1) * (dimension + 2) / 2;
  return std::min<std::size_t>(quadratic + quadratic / 2 + 8, 90);
}

// A sample's coordinates, moved to the level that a region holds.
std::vector<double> at_level(const Region& region, const Sample& sample) {
  std::vector<double> unit = sample.unit;
  if (region.level) unit[region.level->axis] = region.level->value;
  return unit;
}

/// The goal on the models of one region.
class LocalModel {
 public:
  LocalModel(const Samples& samples, const Goal& goal, const Region& region) : goal_{goal}, samples_{samples} {
    const Sample& from = samples[region.from];
    const Sample& to = samples[region.to];
    const std::size_t wanted = node_count(samples.space().dimension());
    const std::vector<double> a = at_level(region, from), b = at_level(region, to);
    Samples::Neighbourhood where{
        .combination = from.combination, .a = a, .b = b, .count = wanted, .apart = region.apart};
    if (region.level) where.stretched = region.level->axis;
    nodes_ = samples.nearest(where, Samples::Wanted::evaluated);
    if (nodes_.size() < 3) return;
    fit_values();
    set_box(region.margin);
    fit_failures(where);
  }

  [[nodiscard]] bool usable() const { return values_.has_value(); }
  [[nodiscard]] const Box& box() const { return box_; }
  [[nodiscard]] const std::vector<std::size_t>& nodes() const { return nodes_; }

  /// Goal plus a steep price on predicted violation: for ranking.
  [[nodiscard]] double merit(const Eigen::VectorXd& x) const {
    const Eigen::VectorXd y = values_->values(x);
    const Eigen::VectorXd limits = y.tail(constraints());
    double worst = goal_.kind == Goal::Kind::feasibility || limits.size() == 0 ? 0.0 : limits.maxCoeff();
    if (failure_) worst = std::max(worst, failure_->values(x)[0]);
    return priced(goal_.scalar(y.head(objectives()), limits), worst);
  }

  /// The least error of the model, in the goal or in a constraint, with which `x` may be progress.
  [[nodiscard]] double shortfall(const Eigen::VectorXd& x) const {
    const Eigen::VectorXd y = values_->values(x);
    const Eigen::VectorXd limits = y.tail(constraints());
    double worst = goal_.scalar(y.head(objectives()), limits) - goal_.to_beat;
    if (limits.size() > 0) worst = std::max(worst, limits.maxCoeff());
    return failure_ ? std::max(worst, failure_->values(x)[0]) : worst;
  }

  /// Minimises the goal over the box, from `start`, moving only the axes in `free`.
  [[nodiscard]] Eigen::VectorXd minimise(const Eigen::VectorXd& start, const std::vector<Eigen::Index>& free) const;

 private:
  [[nodiscard]] Eigen::Index objectives() const { return static_cast<Eigen::Index>(samples_.objective_count()); }
  [[nodiscard]] Eigen::Index constraints() const { return static_cast<Eigen::Index>(samples_.constraint_count()); }

  void fit_values() {
    const auto count = static_cast<Eigen::Index>(nodes_.size());
    const auto dimension = static_cast<Eigen::Index>(samples_.space().dimension());
    Eigen::MatrixXd at(count, dimension), outputs(count, objectives() + constraints());
    for (Eigen::Index i = 0; i < count; ++i) {
      const Sample& sample = samples_[nodes_[static_cast<std::size_t>(i)]];
      at.row(i) = as_vector(sample.unit).transpose();
      outputs.row(i) << as_vector(sample.values).transpose(), as_vector(sample.constraints).transpose();
    }
    compress_steep_constraints(outputs.rightCols(constraints()));
    values_.emplace(at, outputs);
    box_ = {.lower = at.colwise().minCoeff().transpose(), .upper = at.colwise().maxCoeff().transpose()};
  }

  // A constraint that runs over decades would drown its own limit: beyond order 1 its logarithm is modelled. The
  // limit stays where it is, and constraints of order 1 all over (as any is near the answer) stay themselves.
  static void compress_steep_constraints(Eigen::Ref<Eigen::MatrixXd> values) {
    for (auto column : values.colwise()) {
      if (column.maxCoeff() - column.minCoeff() > steep)
        column = column.unaryExpr([](double v) { return std::asinh(v); });
    }
  }

  void set_box(double margin) {
    const Eigen::VectorXd range = box_.upper - box_.lower;
    const double widest = range.size() > 0 ? range.maxCoeff() : 0;
    for (Eigen::Index axis = 0; axis < range.size(); ++axis) {
      const double spacing = samples_.space().spacing(static_cast<std::size_t>(axis));
      const double extra = std::max({margin * range[axis], 0.05 * widest, 1.01 * spacing, 1e-6});
      box_.lower[axis] = std::max(0.0, box_.lower[axis] - extra);
      box_.upper[axis] = std::min(samples_.space().ceiling(static_cast<std::size_t>(axis)), box_.upper[axis] + extra);
    }
  }

  // Failed designs have no values, only the fact: a field of -1 (evaluated) and +1 (failed) between them.
  void fit_failures(Samples::Neighbourhood where) {
    where.count /= 2;
    std::vector<std::size_t> failed = samples_.nearest(where, Samples::Wanted::failed);
    std::erase_if(failed, [&](std::size_t i) {
      const auto x = as_vector(samples_[i].unit);
      return (x.array() < box_.lower.array()).any() || (x.array() > box_.upper.array()).any();
    });
    if (failed.empty()) return;
    const std::size_t good = std::min(nodes_.size(), where.count);
    Eigen::MatrixXd at(static_cast<Eigen::Index>(good + failed.size()), box_.lower.size());
    Eigen::MatrixXd label(at.rows(), 1);
    for (std::size_t i = 0; i < good + failed.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      at.row(row) = as_vector(samples_[i < good ? nodes_[i] : failed[i - good]].unit).transpose();
      label(row, 0) = i < good ? -1.0 : 1.0;
    }
    failure_.emplace(at, label);
  }

  [[nodiscard]] Surrogate::Linearisation linearised(const Eigen::VectorXd& x) const;

  const Goal& goal_;
  const Samples& samples_;
  std::vector<std::size_t> nodes_;
  std::optional<Surrogate> values_, failure_;
  Box box_;
};

Eigen::VectorXd LocalModel::minimise(const Eigen::VectorXd& start, const std::vector<Eigen::Index>& free) const {
  const Field field{.at = [this](const Eigen::VectorXd& x, Field::Wanted) { return linearised(x); },
                    .objectives = objectives(),
                    .constraints = constraints() + (failure_ ? 1 : 0),
                    .margin = model_margin};
  // SLSQP needs tens of steps; on the 30 variables of ZDT1 a looser tolerance stopped it half way.
  return sizing::minimise(field, goal_, box_, start, free,
                          {.algorithm = Algorithm::slsqp, .max_calls = 120, .relative_tolerance = 1e-8});
}

Surrogate::Linearisation LocalModel::linearised(const Eigen::VectorXd& x) const {
  Surrogate::Linearisation all = values_->linearised(x);
  if (!failure_) return all;
  const Surrogate::Linearisation failure = failure_->linearised(x);
  const Eigen::Index last = all.values.size();
  all.values.conservativeResize(last + 1);
  all.jacobian.conservativeResize(last + 1, Eigen::NoChange);
  all.values[last] = failure.values[0];
  all.jacobian.row(last) = failure.jacobian.row(0);
  return all;
}

std::vector<Eigen::Index> axes_where(const DesignSpace& space, bool (*wanted)(double spacing)) {
  std::vector<Eigen::Index> axes;
  for (std::size_t axis = 0; axis < space.dimension(); ++axis) {
    if (wanted(space.spacing(axis))) axes.push_back(static_cast<Eigen::Index>(axis));
  }
  return axes;
}

using Point = std::vector<double>;

// Grid points round `optimum`: floor and ceiling in up to five axes (those nearest to half way), then single steps.
std::vector<Point> grid_points_near(const DesignSpace& space, const Eigen::VectorXd& optimum) {
  std::vector<std::pair<double, std::size_t>> doubtful;
  for (std::size_t axis = 0; axis < space.dimension(); ++axis) {
    const double spacing = space.spacing(axis);
    if (spacing == 0) continue;
    const double position = optimum[static_cast<Eigen::Index>(axis)] / spacing;
    doubtful.emplace_back(-std::abs(position - std::round(position)), axis);
  }
  std::ranges::sort(doubtful);
  const std::size_t corners = std::min<std::size_t>(doubtful.size(), 5);
  std::vector<Point> points;
  for (std::size_t mask = 0; mask < (std::size_t{1} << corners); ++mask) {
    Point point = as_std(optimum);
    for (std::size_t c = 0; c < corners; ++c) {
      const std::size_t axis = doubtful[c].second;
      const double spacing = space.spacing(axis), position = point[axis] / spacing;
      point[axis] = ((mask >> c & 1U) != 0 ? std::ceil(position) : std::floor(position)) * spacing;
    }
    points.push_back(space.snapped(point));
  }
  for (const auto& [distance, axis] : doubtful) {
    for (const double step : {-1.0, 1.0}) {
      Point point = space.snapped(as_std(optimum));
      point[axis] += step * space.spacing(axis);
      points.push_back(space.snapped(point));
    }
  }
  return points;
}

// One and two steps from a sample, along one or two axes of the grid.
void append_grid_neighbours(const DesignSpace& space, const Point& centre, std::vector<Point>& points) {
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
}

struct Ranked {
  double merit;
  Point unit;
};

std::vector<Ranked> rank_on_grid(const Samples& samples, const LocalModel& model, const Region& region,
                                 const Eigen::VectorXd& optimum) {
  const DesignSpace& space = samples.space();
  std::vector<Point> points = grid_points_near(space, optimum);
  if (space.dimension() <= most_axes_in_pairs) {
    append_grid_neighbours(space, at_level(region, samples[region.from]), points);
    if (region.to != region.from) append_grid_neighbours(space, at_level(region, samples[region.to]), points);
  }
  if (region.level) {
    // Captured by value under new names: Clang 14 does not capture structured bindings.
    const auto [level_axis, level_value] = *region.level;
    std::erase_if(points, [&space, axis = level_axis, value = level_value](const Point& point) {
      return std::abs(point[axis] - value) > 0.5 * space.spacing(axis);
    });
  }
  std::ranges::sort(points);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  const std::uint64_t combination = samples[region.from].combination;
  std::erase_if(points, [&](const Point& point) { return samples.knows(point, combination); });
  std::vector<Ranked> ranked;
  for (Point& point : points) ranked.push_back({.merit = model.merit(as_vector(point)), .unit = std::move(point)});
  std::ranges::stable_sort(ranked, {}, &Ranked::merit);
  const std::vector<Eigen::Index> smooth = axes_where(space, [](double spacing) { return spacing == 0; });
  if (smooth.empty()) return ranked;
  ranked.resize(std::min<std::size_t>(ranked.size(), 3));
  for (Ranked& entry : ranked) {
    const Eigen::VectorXd moved = model.minimise(as_vector(entry.unit), smooth);
    const double merit = model.merit(moved);
    if (merit < entry.merit) entry = {.merit = merit, .unit = space.snapped(as_std(moved))};
  }
  std::ranges::stable_sort(ranked, {}, &Ranked::merit);
  return ranked;
}

bool near_known(const Samples& samples, const std::vector<std::size_t>& nodes, const Point& unit) {
  return std::ranges::any_of(nodes, [&](std::size_t i) {
    return (as_vector(samples[i].unit) - as_vector(unit)).cwiseAbs().maxCoeff() < same_design;
  });
}

}  // namespace

std::vector<Candidate> infill(const Samples& samples, const Goal& goal, const Region& region) {
  const DesignSpace& space = samples.space();
  if (space.dimension() == 0) return {};
  const LocalModel model{samples, goal, region};
  if (!model.usable()) return {};
  std::vector<Eigen::Index> all = axes_where(space, [](double) { return true; });
  if (region.level) std::erase(all, static_cast<Eigen::Index>(region.level->axis));
  if (all.empty()) return {};
  std::vector<Eigen::VectorXd> starts{as_vector(at_level(region, samples[region.from]))};
  if (region.to != region.from) {
    starts.emplace_back(as_vector(at_level(region, samples[region.to])));
    starts.emplace_back(0.5 * (starts[0] + starts[1]));
  }
  if (region.seed != 0) {
    std::mt19937_64 random{region.seed};
    for (std::size_t i = 0; i < random_starts; ++i) {
      Eigen::VectorXd x(starts[0].size());
      for (Eigen::Index axis = 0; axis < x.size(); ++axis) {
        x[axis] = std::lerp(model.box().lower[axis], model.box().upper[axis], uniform(random));
      }
      if (region.level) x[static_cast<Eigen::Index>(region.level->axis)] = region.level->value;
      starts.push_back(std::move(x));
    }
  }
  // Descents from the two starts the model likes best.
  std::ranges::stable_sort(starts, {}, [&](const Eigen::VectorXd& x) { return model.merit(x); });
  starts.resize(std::min<std::size_t>(starts.size(), 2));
  Eigen::VectorXd best;
  double best_merit = std::numeric_limits<double>::infinity();
  for (const Eigen::VectorXd& start : starts) {
    const Eigen::VectorXd x = model.minimise(start, all);
    const double merit = model.merit(x);
    if (merit < best_merit) {
      best_merit = merit;
      best = x;
    }
    if (best_merit < goal.to_beat) break;
  }
  if (best.size() == 0) return {};
  std::vector<Ranked> ranked;
  if (space.has_grid()) {
    ranked = rank_on_grid(samples, model, region, best);
  } else {
    ranked.push_back({.merit = best_merit, .unit = space.snapped(as_std(best))});
  }
  const double doubt = space.has_grid() && goal.kind == Goal::Kind::gap ? grid_doubt : 0.0;
  double least = goal.to_beat + doubt;
  if (region.level && !ranked.empty() && ranked.front().merit >= least) {
    // Few designs of this level may be known: the model learns nothing there unless something is evaluated.
    for (Ranked& entry : ranked) entry.merit = model.shortfall(as_vector(entry.unit));
    std::ranges::stable_sort(ranked, {}, &Ranked::merit);
    least = std::numeric_limits<double>::infinity();
  }
  std::vector<Candidate> result;
  for (Ranked& entry : ranked) {
    if (entry.merit >= least || result.size() == 3) break;
    if (samples.knows(entry.unit, samples[region.from].combination)) continue;
    if (near_known(samples, model.nodes(), entry.unit)) continue;
    result.push_back({.unit = std::move(entry.unit), .combination = samples[region.from].combination});
  }
  return result;
}

std::vector<Candidate> near_misses(const Samples& samples, const Goal& goal, std::size_t of, std::size_t count) {
  const DesignSpace& space = samples.space();
  if (!space.has_grid() || space.dimension() > most_axes_in_pairs) return {};
  const LocalModel model{samples, goal, {.from = of, .to = of}};
  if (!model.usable()) return {};
  const std::uint64_t combination = samples[of].combination;
  std::vector<Point> points;
  append_grid_neighbours(space, samples[of].unit, points);
  std::ranges::sort(points);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  std::erase_if(points, [&](const Point& point) { return samples.knows(point, combination); });
  std::vector<Ranked> ranked;
  for (Point& point : points) ranked.push_back({.merit = model.shortfall(as_vector(point)), .unit = std::move(point)});
  std::ranges::stable_sort(ranked, {}, &Ranked::merit);
  ranked.resize(std::min(ranked.size(), count));
  std::vector<Candidate> result;
  for (Ranked& entry : ranked) result.push_back({.unit = std::move(entry.unit), .combination = combination});
  return result;
}

}  // namespace coilwright::sizing
