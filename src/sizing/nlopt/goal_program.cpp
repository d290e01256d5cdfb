#include "sizing/nlopt/goal_program.hpp"

#include <algorithm>
#include <cmath>

namespace coilwright::sizing {
namespace {

// Range of the variable that stands for the value of a min-max goal: terms of a gap and constraints are of order 1.
constexpr double bound_limit = 10.0;

/// The minimisation in NLopt's variables: the free axes, each over the box as [0, 1], and in epigraph form the bound of
/// a min-max goal.
class GoalProgram {
 public:
  GoalProgram(const DesignFunctions& functions, const Goal& goal, const Box& box, const Eigen::VectorXd& start,
              const std::vector<Eigen::Index>& free, Algorithm algorithm)
      : functions_{functions},
        goal_{goal},
        box_{box},
        start_{start},
        free_{free},
        penalised_{!takes_constraints(algorithm)},
        epigraph_{!penalised_ && goal.kind != Goal::Kind::objective} {}

  [[nodiscard]] NloptTask task(const NloptSettings& settings);

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
  void refresh(std::span<const double> z, DesignFunctions::Wanted wanted);
  [[nodiscard]] std::vector<double> position() const;
  [[nodiscard]] double scalar() const {
    return goal_.scalar(at_.values.head(functions_.objectives), at_.values.tail(functions_.constraints));
  }
  [[nodiscard]] double slope(Eigen::Index output, std::size_t axis) const {
    return at_.jacobian(output, free_[axis]) * (box_.upper[free_[axis]] - box_.lower[free_[axis]]);
  }
  [[nodiscard]] std::size_t rows() const {
    const Eigen::Index terms = epigraph_ && goal_.kind == Goal::Kind::gap ? functions_.objectives : 0;
    return penalised_ ? 0 : static_cast<std::size_t>(terms + functions_.constraints);
  }

  const DesignFunctions& functions_;
  const Goal& goal_;
  const Box& box_;
  const Eigen::VectorXd& start_;
  const std::vector<Eigen::Index>& free_;
  bool penalised_, epigraph_;
  Linearisation at_;
  std::vector<double> last_;
  enum class Known { nothing, values, gradients } known_ = Known::nothing;  // at last_
};

NloptTask GoalProgram::task(const NloptSettings& settings) {
  NloptTask task{.algorithm = settings.algorithm,
                 .lower = std::vector<double>(free_.size(), 0.0),
                 .upper = std::vector<double>(free_.size(), 1.0),
                 .start = position(),
                 .first_step = settings.first_step,
                 .objective = [this](auto z, auto gradient) { return objective(z, gradient); },
                 .constraint_count = rows(),
                 .constraints = [this](auto z, auto result, auto jacobian) { constraints(z, result, jacobian); },
                 .max_calls = settings.max_calls,
                 .relative_tolerance = settings.relative_tolerance,
                 .seed = settings.seed};
  if (epigraph_) {
    refresh(task.start, DesignFunctions::Wanted::values);
    task.lower.push_back(-bound_limit);
    task.upper.push_back(bound_limit);
    task.start.push_back(std::clamp(scalar(), -bound_limit, bound_limit));
  }
  return task;
}

double GoalProgram::objective(std::span<const double> z, std::span<double> gradient) {
  std::ranges::fill(gradient, 0.0);
  if (epigraph_) {
    if (!gradient.empty()) gradient.back() = 1.0;
    return z.back();
  }
  refresh(z, gradient.empty() ? DesignFunctions::Wanted::values : DesignFunctions::Wanted::gradients);
  for (Eigen::Index i = 0; i < functions_.objectives && !gradient.empty(); ++i) {
    for (std::size_t a = 0; a < free_.size(); ++a) gradient[a] += slope(i, a) / goal_.span[static_cast<std::size_t>(i)];
  }
  if (!penalised_ || functions_.constraints == 0 || goal_.kind == Goal::Kind::feasibility) return scalar();
  // Continuous at the limit, unlike `penalised`: the algorithm follows the slope of the penalty.
  return scalar() + 10.0 * std::max(0.0, at_.values.tail(functions_.constraints).maxCoeff() + functions_.margin);
}

void GoalProgram::constraints(std::span<const double> z, std::span<double> result, std::span<double> jacobian) {
  refresh(z, jacobian.empty() ? DesignFunctions::Wanted::values : DesignFunctions::Wanted::gradients);
  const std::size_t width = free_.size() + (epigraph_ ? 1 : 0);
  const double bound = epigraph_ ? z.back() : 0.0;
  std::size_t row = 0;
  const auto put = [&](Eigen::Index output, double scale, double shift, double bound_slope) {
    result[row] = at_.values[output] * scale + shift;
    if (!jacobian.empty()) {
      for (std::size_t a = 0; a < free_.size(); ++a) jacobian[row * width + a] = slope(output, a) * scale;
      if (epigraph_) jacobian[row * width + width - 1] = bound_slope;
    }
    ++row;
  };
  for (Eigen::Index i = 0; i < functions_.objectives && goal_.kind == Goal::Kind::gap; ++i) {
    const auto k = static_cast<std::size_t>(i);
    put(i, 1 / goal_.span[k], -goal_.origin[k] / goal_.span[k] - bound, -1.0);
  }
  const bool slack = goal_.kind == Goal::Kind::feasibility;
  for (Eigen::Index j = 0; j < functions_.constraints; ++j) {
    put(functions_.objectives + j, 1.0, slack ? -bound : functions_.margin, slack ? -1.0 : 0.0);
  }
}

// NLopt asks for the objective and the constraints at the same point one after the other.
void GoalProgram::refresh(std::span<const double> z, DesignFunctions::Wanted wanted) {
  const std::span<const double> axes = z.first(free_.size());
  const Known needed = wanted == DesignFunctions::Wanted::values ? Known::values : Known::gradients;
  if (known_ >= needed && std::ranges::equal(axes, last_)) return;
  known_ = Known::nothing;
  last_.assign(axes.begin(), axes.end());
  at_ = functions_.at(design(axes), wanted);
  known_ = needed;
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

Box whole_box(const DesignSpace& space) {
  const auto n = static_cast<Eigen::Index>(space.dimension());
  Box box{.lower = Eigen::VectorXd::Zero(n), .upper = Eigen::VectorXd(n)};
  for (Eigen::Index axis = 0; axis < n; ++axis) box.upper[axis] = space.ceiling(static_cast<std::size_t>(axis));
  return box;
}

Eigen::VectorXd minimise(const DesignFunctions& functions, const Goal& goal, const Box& box,
                         const Eigen::VectorXd& start, const std::vector<Eigen::Index>& free,
                         const NloptSettings& settings) {
  if (free.empty()) return start;
  GoalProgram program{functions, goal, box, start, free, settings.algorithm};
  return program.design(run_nlopt(program.task(settings)));
}

}  // namespace coilwright::sizing
