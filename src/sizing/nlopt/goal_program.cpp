#include "sizing/nlopt/goal_program.hpp"

#include <algorithm>
#include <cmath>

namespace coilwright::sizing {
namespace {

// Values of a min-max goal NLopt may look at: a gap's are of order 1, so are constraints.
constexpr double bound_limit = 10.0;

/// The minimisation as NLopt sees it: the free axes over the box as [0, 1] and perhaps the bound t.
class GoalProgram {
 public:
  GoalProgram(const Field& field, const Goal& goal, const Box& box, const Eigen::VectorXd& start,
              const std::vector<Eigen::Index>& free, Algorithm algorithm)
      : field_{field},
        goal_{goal},
        box_{box},
        start_{start},
        free_{free},
        priced_{!takes_constraints(algorithm)},
        bounded_{!priced_ && goal.kind != Goal::Kind::objective} {}

  [[nodiscard]] NloptTask task(const Descent& descent);

  [[nodiscard]] Eigen::VectorXd design(std::span<const double> z) const {
    Eigen::VectorXd x = start_;
    for (std::size_t a = 0; a < free_.size(); ++a) {
      x[free_[a]] = std::lerp(box_.lower[free_[a]], box_.upper[free_[a]], z[a]);
    }
    return x;
  }

 private:
  [[nodiscard]] double objective(std::span<const double> z, std::span<double> gradient);
  void constraints(std::span<const double> z, std::span<double> result, std::span<double> jacobian);
  void refresh(std::span<const double> z, Field::Wanted wanted);
  [[nodiscard]] std::vector<double> position() const;
  [[nodiscard]] double scalar() const {
    return goal_.scalar(at_.values.head(field_.objectives), at_.values.tail(field_.constraints));
  }
  [[nodiscard]] double slope(Eigen::Index output, std::size_t axis) const {
    return at_.jacobian(output, free_[axis]) * (box_.upper[free_[axis]] - box_.lower[free_[axis]]);
  }
  [[nodiscard]] std::size_t rows() const {
    const Eigen::Index terms = bounded_ && goal_.kind == Goal::Kind::gap ? field_.objectives : 0;
    return priced_ ? 0 : static_cast<std::size_t>(terms + field_.constraints);
  }

  const Field& field_;
  const Goal& goal_;
  const Box& box_;
  const Eigen::VectorXd& start_;
  const std::vector<Eigen::Index>& free_;
  bool priced_, bounded_;
  Surrogate::Linearisation at_;
  std::vector<double> last_;
  enum class Fresh { nothing, values, slopes } fresh_ = Fresh::nothing;
};

NloptTask GoalProgram::task(const Descent& descent) {
  NloptTask task{.algorithm = descent.algorithm,
                 .lower = std::vector<double>(free_.size(), 0.0),
                 .upper = std::vector<double>(free_.size(), 1.0),
                 .start = position(),
                 .first_step = descent.first_step,
                 .objective = [this](auto z, auto gradient) { return objective(z, gradient); },
                 .constraint_count = rows(),
                 .constraints = [this](auto z, auto result, auto jacobian) { constraints(z, result, jacobian); },
                 .max_calls = descent.max_calls,
                 .relative_tolerance = descent.relative_tolerance,
                 .seed = descent.seed};
  if (bounded_) {
    refresh(task.start, Field::Wanted::values);
    task.lower.push_back(-bound_limit);
    task.upper.push_back(bound_limit);
    task.start.push_back(std::clamp(scalar(), -bound_limit, bound_limit));
  }
  return task;
}

double GoalProgram::objective(std::span<const double> z, std::span<double> gradient) {
  std::ranges::fill(gradient, 0.0);
  if (bounded_) {
    if (!gradient.empty()) gradient.back() = 1.0;
    return z.back();
  }
  refresh(z, gradient.empty() ? Field::Wanted::values : Field::Wanted::slopes);
  for (Eigen::Index i = 0; i < field_.objectives && !gradient.empty(); ++i) {
    for (std::size_t a = 0; a < free_.size(); ++a) gradient[a] += slope(i, a) / goal_.span[static_cast<std::size_t>(i)];
  }
  if (!priced_ || field_.constraints == 0 || goal_.kind == Goal::Kind::feasibility) return scalar();
  // No jump at the limit here, unlike in `priced`: a descent follows the slope of the price.
  return scalar() + 10.0 * std::max(0.0, at_.values.tail(field_.constraints).maxCoeff() + field_.margin);
}

void GoalProgram::constraints(std::span<const double> z, std::span<double> result, std::span<double> jacobian) {
  refresh(z, jacobian.empty() ? Field::Wanted::values : Field::Wanted::slopes);
  const std::size_t width = free_.size() + (bounded_ ? 1 : 0);
  const double bound = bounded_ ? z.back() : 0.0;
  std::size_t row = 0;
  const auto put = [&](Eigen::Index output, double scale, double shift, double bound_slope) {
    result[row] = at_.values[output] * scale + shift;
    if (!jacobian.empty()) {
      for (std::size_t a = 0; a < free_.size(); ++a) jacobian[row * width + a] = slope(output, a) * scale;
      if (bounded_) jacobian[row * width + width - 1] = bound_slope;
    }
    ++row;
  };
  for (Eigen::Index i = 0; i < field_.objectives && goal_.kind == Goal::Kind::gap; ++i) {
    const auto k = static_cast<std::size_t>(i);
    put(i, 1 / goal_.span[k], -goal_.origin[k] / goal_.span[k] - bound, -1.0);
  }
  const bool slack = goal_.kind == Goal::Kind::feasibility;
  for (Eigen::Index j = 0; j < field_.constraints; ++j) {
    put(field_.objectives + j, 1.0, slack ? -bound : field_.margin, slack ? -1.0 : 0.0);
  }
}

// NLopt asks for objective and constraints at the same point one after the other.
void GoalProgram::refresh(std::span<const double> z, Field::Wanted wanted) {
  const std::span<const double> axes = z.first(free_.size());
  const Fresh needed = wanted == Field::Wanted::values ? Fresh::values : Fresh::slopes;
  if (fresh_ >= needed && std::ranges::equal(axes, last_)) return;
  fresh_ = Fresh::nothing;
  last_.assign(axes.begin(), axes.end());
  at_ = field_.at(design(axes), wanted);
  fresh_ = needed;
}

std::vector<double> GoalProgram::position() const {
  std::vector<double> z(free_.size());
  for (std::size_t a = 0; a < free_.size(); ++a) {
    const double width = box_.upper[free_[a]] - box_.lower[free_[a]];
    z[a] = std::clamp((start_[free_[a]] - box_.lower[free_[a]]) / width, 0.0, 1.0);
  }
  return z;
}

}  // namespace

Eigen::VectorXd minimise(const Field& field, const Goal& goal, const Box& box, const Eigen::VectorXd& start,
                         const std::vector<Eigen::Index>& free, const Descent& descent) {
  if (free.empty()) return start;
  GoalProgram program{field, goal, box, start, free, descent.algorithm};
  return program.design(run_nlopt(program.task(descent)));
}

}  // namespace coilwright::sizing
