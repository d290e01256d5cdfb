#include "sizing/infill.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <random>

#include "sizing/nlopt_run.hpp"
#include "sizing/random.hpp"
#include "sizing/surrogate.hpp"

namespace coilwright::sizing {
namespace {

// The model's constraints are asked to hold with this to spare (in their scale): the optimum sits on them, and the
// model is off by a rounding or two.
constexpr double model_margin = 1e-6;
// A design nearer than this (unit cube) to a known one would tell nothing new.
constexpr double same_design = 1e-7;
// Random starts: ranked by the model (4 us each), only the best two are descended from.
constexpr std::size_t random_starts = 40;

struct Box {
  Eigen::VectorXd lower, upper;
};

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

/// The goal on the models of one region.
class LocalModel {
 public:
  LocalModel(const Samples& samples, const Goal& goal, const Region& region) : goal_{goal}, samples_{samples} {
    const Sample& from = samples[region.from];
    const Sample& to = samples[region.to];
    const std::size_t wanted = node_count(samples.space().dimension());
    const Samples::Neighbourhood where{.combination = from.combination,
                                       .a = from.unit,
                                       .b = to.unit,
                                       .count = wanted,
                                       .apart = region.apart};
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
    double scalar = goal_scalar(y), worst = 0;
    if (goal_.kind != Goal::Kind::feasibility) {
      for (Eigen::Index j = objectives(); j < y.size(); ++j) worst = std::max(worst, y[j]);
    }
    if (failure_) worst = std::max(worst, failure_->values(x)[0]);
    return scalar + (worst > 0 ? 1.0 + 10 * worst : 0.0);
  }

  /// Minimises the goal over the box, from `start`, moving only the axes in `free`.
  [[nodiscard]] Eigen::VectorXd minimise(const Eigen::VectorXd& start, const std::vector<Eigen::Index>& free) const;

 private:
  [[nodiscard]] Eigen::Index objectives() const { return static_cast<Eigen::Index>(samples_.objective_count()); }

  void fit_values() {
    const auto count = static_cast<Eigen::Index>(nodes_.size());
    const auto dimension = static_cast<Eigen::Index>(samples_.space().dimension());
    const auto constraints = static_cast<Eigen::Index>(samples_.constraint_count());
    Eigen::MatrixXd at(count, dimension), outputs(count, objectives() + constraints);
    for (Eigen::Index i = 0; i < count; ++i) {
      const Sample& sample = samples_[nodes_[static_cast<std::size_t>(i)]];
      at.row(i) = as_vector(sample.unit).transpose();
      outputs.row(i) << as_vector(sample.values).transpose(), as_vector(sample.constraints).transpose();
    }
    values_.emplace(at, outputs);
    box_ = {.lower = at.colwise().minCoeff().transpose(), .upper = at.colwise().maxCoeff().transpose()};
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

  [[nodiscard]] double goal_scalar(const Eigen::VectorXd& y) const {
    double scalar = goal_.kind == Goal::Kind::objective ? 0.0 : -std::numeric_limits<double>::infinity();
    if (goal_.kind == Goal::Kind::feasibility) return y.tail(y.size() - objectives()).maxCoeff();
    for (Eigen::Index i = 0; i < objectives(); ++i) {
      const auto k = static_cast<std::size_t>(i);
      const double term = (y[i] - goal_.origin[k]) / goal_.span[k];
      scalar = goal_.kind == Goal::Kind::objective ? scalar + term : std::max(scalar, term);
    }
    return scalar;
  }

  const Goal& goal_;
  const Samples& samples_;
  std::vector<std::size_t> nodes_;
  std::optional<Surrogate> values_, failure_;
  Box box_;
};

// The minimisation as NLopt sees it: the free axes over the box as [0, 1], and, for a min-max goal, its value t as one
// more variable with every term of the maximum a constraint term - t <= 0.
class ModelProgram {
 public:
  ModelProgram(const Surrogate& values, const Surrogate* failure, const Goal& goal, Eigen::Index objectives,
               const Box& box, const Eigen::VectorXd& start, const std::vector<Eigen::Index>& free)
      : values_{values}, failure_{failure}, goal_{goal}, objectives_{objectives}, box_{box}, x_{start}, free_{free} {
    constraint_rows_ = values_.values(x_).size() - objectives_;
  }

  [[nodiscard]] bool has_bound_variable() const { return goal_.kind != Goal::Kind::objective; }
  [[nodiscard]] std::size_t variables() const { return free_.size() + (has_bound_variable() ? 1 : 0); }
  [[nodiscard]] std::size_t constraints() const {
    const Eigen::Index terms = goal_.kind == Goal::Kind::gap ? objectives_ : 0;
    return static_cast<std::size_t>(terms + constraint_rows_ + (failure_ ? 1 : 0));
  }

  double objective(std::span<const double> z, std::span<double> gradient) {
    if (has_bound_variable()) {
      std::ranges::fill(gradient, 0.0);
      if (!gradient.empty()) gradient.back() = 1.0;
      return z.back();
    }
    refresh(z);
    double sum = 0;
    std::ranges::fill(gradient, 0.0);
    for (Eigen::Index i = 0; i < objectives_; ++i) {
      const auto k = static_cast<std::size_t>(i);
      sum += (at_.values[i] - goal_.origin[k]) / goal_.span[k];
      for (std::size_t a = 0; a < gradient.size(); ++a) gradient[a] += slope(at_, i, a) / goal_.span[k];
    }
    return sum;
  }

  void constraints(std::span<const double> z, std::span<double> result, std::span<double> jacobian) {
    refresh(z);
    const std::size_t width = variables();
    std::size_t row = 0;
    const auto put = [&](const Surrogate::Linearisation& from, Eigen::Index output, double scale, double shift,
                         double bound_slope) {
      result[row] = from.values[output] * scale + shift;
      if (!jacobian.empty()) {
        for (std::size_t a = 0; a < free_.size(); ++a) jacobian[row * width + a] = slope(from, output, a) * scale;
        if (has_bound_variable()) jacobian[row * width + width - 1] = bound_slope;
      }
      ++row;
    };
    const double bound = has_bound_variable() ? z.back() : 0.0;
    if (goal_.kind == Goal::Kind::gap) {
      for (Eigen::Index i = 0; i < objectives_; ++i) {
        const auto k = static_cast<std::size_t>(i);
        put(at_, i, 1 / goal_.span[k], -goal_.origin[k] / goal_.span[k] - bound, -1.0);
      }
    }
    const bool slack = goal_.kind == Goal::Kind::feasibility;
    for (Eigen::Index j = 0; j < constraint_rows_; ++j) {
      put(at_, objectives_ + j, 1.0, slack ? -bound : model_margin, slack ? -1.0 : 0.0);
    }
    if (failure_) put(failed_, 0, 1.0, 0.0, 0.0);
  }

  [[nodiscard]] Eigen::VectorXd design(std::span<const double> z) const {
    Eigen::VectorXd x = x_;
    for (std::size_t a = 0; a < free_.size(); ++a) {
      x[free_[a]] = std::lerp(box_.lower[free_[a]], box_.upper[free_[a]], z[a]);
    }
    return x;
  }

  [[nodiscard]] std::vector<double> position(const Eigen::VectorXd& x) const {
    std::vector<double> z(free_.size());
    for (std::size_t a = 0; a < free_.size(); ++a) {
      const double width = box_.upper[free_[a]] - box_.lower[free_[a]];
      z[a] = std::clamp((x[free_[a]] - box_.lower[free_[a]]) / width, 0.0, 1.0);
    }
    return z;
  }

 private:
  // NLopt asks for objective and constraints at the same point one after the other.
  void refresh(std::span<const double> z) {
    const std::span<const double> axes = z.first(free_.size());
    if (fresh_ && std::ranges::equal(axes, last_)) return;
    last_.assign(axes.begin(), axes.end());
    const Eigen::VectorXd x = design(axes);
    at_ = values_.linearised(x);
    if (failure_) failed_ = failure_->linearised(x);
    fresh_ = true;
  }

  [[nodiscard]] double slope(const Surrogate::Linearisation& of, Eigen::Index output, std::size_t axis) const {
    return of.jacobian(output, free_[axis]) * (box_.upper[free_[axis]] - box_.lower[free_[axis]]);
  }

  const Surrogate& values_;
  const Surrogate* failure_;
  const Goal& goal_;
  Eigen::Index objectives_, constraint_rows_ = 0;
  const Box& box_;
  Eigen::VectorXd x_;
  const std::vector<Eigen::Index>& free_;
  Surrogate::Linearisation at_, failed_;
  std::vector<double> last_;
  bool fresh_ = false;
};

Eigen::VectorXd LocalModel::minimise(const Eigen::VectorXd& start, const std::vector<Eigen::Index>& free) const {
  if (free.empty()) return start;
  ModelProgram program{*values_, failure_ ? &*failure_ : nullptr, goal_, objectives(), box_, start, free};
  NloptTask task{.algorithm = Algorithm::slsqp,
                 .lower = std::vector<double>(program.variables(), 0.0),
                 .upper = std::vector<double>(program.variables(), 1.0),
                 .start = program.position(start),
                 .objective = [&](auto z, auto gradient) { return program.objective(z, gradient); },
                 .constraint_count = program.constraints(),
                 .constraints = [&](auto z, auto result, auto jacobian) { program.constraints(z, result, jacobian); },
                 .max_calls = 120,
                 .relative_tolerance = 1e-8,
                 .seed = 1};
  if (program.has_bound_variable()) {
    const double at_start = std::clamp(goal_scalar(values_->values(start)), -10.0, 10.0);
    task.lower.back() = -10.0;
    task.upper.back() = 10.0;
    task.start.push_back(at_start);
  }
  std::vector<double> z = run_nlopt(task);
  z.resize(free.size());
  return program.design(z);
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
  if (space.dimension() <= 10) {
    append_grid_neighbours(space, samples[region.from].unit, points);
    if (region.to != region.from) append_grid_neighbours(space, samples[region.to].unit, points);
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

double Goal::scalar(const Sample& sample) const {
  double result = kind == Kind::objective ? 0.0 : -std::numeric_limits<double>::infinity();
  if (kind == Kind::feasibility) return *std::ranges::max_element(sample.constraints);
  for (std::size_t i = 0; i < sample.values.size(); ++i) {
    const double term = (sample.values[i] - origin[i]) / span[i];
    result = kind == Kind::objective ? result + term : std::max(result, term);
  }
  return result;
}

std::vector<Candidate> infill(const Samples& samples, const Goal& goal, const Region& region) {
  const DesignSpace& space = samples.space();
  if (space.dimension() == 0) return {};
  const LocalModel model{samples, goal, region};
  if (!model.usable()) return {};
  const std::vector<Eigen::Index> all = axes_where(space, [](double) { return true; });
  std::vector<Eigen::VectorXd> starts{as_vector(samples[region.from].unit)};
  if (region.to != region.from) {
    starts.emplace_back(as_vector(samples[region.to].unit));
    starts.emplace_back(0.5 * (starts[0] + starts[1]));
  }
  if (region.seed != 0) {
    std::mt19937_64 random{region.seed};
    for (std::size_t i = 0; i < random_starts; ++i) {
      Eigen::VectorXd x(starts[0].size());
      for (Eigen::Index axis = 0; axis < x.size(); ++axis) {
        x[axis] = std::lerp(model.box().lower[axis], model.box().upper[axis], uniform(random));
      }
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
  std::vector<Candidate> result;
  for (Ranked& entry : ranked) {
    if (entry.merit >= goal.to_beat || result.size() == 3) break;
    if (samples.knows(entry.unit, samples[region.from].combination)) continue;
    if (near_known(samples, model.nodes(), entry.unit)) continue;
    result.push_back({.unit = std::move(entry.unit), .combination = samples[region.from].combination});
  }
  return result;
}

}  // namespace coilwright::sizing
