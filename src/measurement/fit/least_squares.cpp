#include "measurement/fit/least_squares.hpp"

#include <ceres/ceres.h>

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace coilwright::measurement::fit {
namespace {

// Ceres announces each point once; everything is then evaluated in parallel, and the cost functions only copy.
class Coordinator : public ceres::EvaluationCallback {
 public:
  // With `updates` derivatives are taken at the first point, and carried on from there.
  Coordinator(ResidualBlocks& blocks, Eigen::VectorXd& parameters, Derivatives derivatives, bool updates)
      : blocks_(blocks), parameters_(parameters), derivatives_(derivatives), updates_(updates) {}

  void PrepareForEvaluation(bool derivatives, bool /*new_point*/) override { evaluate_here(derivatives); }
  // Residuals and derivatives at the point where the solver is: often kept from its last accepted step. Null if there
  // is no model.
  [[nodiscard]] ResidualValues* here() {
    evaluate_here(true);
    return current_->values ? &*current_->values : nullptr;
  }
  // What the cost functions copy.
  [[nodiscard]] const ResidualValues* values() const { return current_->values ? &*current_->values : nullptr; }

 private:
  [[nodiscard]] bool is_here(const ResidualPoint& point) const {
    return point.values && point.parameters == parameters_ &&
           std::ranges::equal(point.local_numbers, blocks_.local_numbers());
  }

  void evaluate_here(bool derivatives) {
    if (is_here(with_derivatives_) || (!derivatives && is_here(without_derivatives_))) {
      current_ = is_here(with_derivatives_) ? &with_derivatives_ : &without_derivatives_;
      return;
    }
    const bool carries = derivatives && updates_ && with_derivatives_.values;
    const std::span<const double> local_numbers = blocks_.local_numbers();
    auto found = blocks_.evaluate(parameters_, derivatives && !carries ? derivatives_ : Derivatives::none);
    ResidualPoint here{.parameters = parameters_,
                       .local_numbers = {local_numbers.begin(), local_numbers.end()},
                       .values = std::move(found)};
    if (carries && here.values) blocks_.carry_derivatives(with_derivatives_, here);
    current_ = derivatives ? &with_derivatives_ : &without_derivatives_;
    *current_ = std::move(here);
  }

  ResidualBlocks& blocks_;
  Eigen::VectorXd& parameters_;
  Derivatives derivatives_;
  bool updates_;
  ResidualPoint with_derivatives_, without_derivatives_;
  ResidualPoint* current_ = &without_derivatives_;
};

class BlockCost : public ceres::CostFunction {
 public:
  BlockCost(const Coordinator& coordinator, std::size_t block, Eigen::Index rows, Eigen::Index parameters,
            std::size_t local)
      : coordinator_(coordinator), block_(block) {
    set_num_residuals(static_cast<int>(rows));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(parameters));
    if (local > 0) mutable_parameter_block_sizes()->push_back(static_cast<int>(local));
  }
  bool Evaluate(const double* const* /*parameters*/, double* residuals, double** jacobians) const override {
    if (coordinator_.values() == nullptr) return false;
    using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    const ResidualValues::Block& values = coordinator_.values()->blocks[block_];
    Eigen::Map<Eigen::VectorXd>(residuals, values.residuals.size()) = values.residuals;
    if (jacobians == nullptr) return true;
    if (jacobians[0] != nullptr)
      Eigen::Map<RowMajor>(jacobians[0], values.jacobian.rows(), values.jacobian.cols()) = values.jacobian;
    if (parameter_block_sizes().size() > 1 && jacobians[1] != nullptr)
      Eigen::Map<RowMajor>(jacobians[1], values.local_jacobian.rows(), values.local_jacobian.cols()) =
          values.local_jacobian;
    return true;
  }

 private:
  const Coordinator& coordinator_;
  std::size_t block_;
};

// The prior of the parameters that have one.
class PriorCost : public ceres::CostFunction {
 public:
  PriorCost(const Hypothesis& hypothesis, double model_error, Eigen::Index rows, Eigen::Index width)
      : hypothesis_(hypothesis), model_error_(model_error) {
    set_num_residuals(static_cast<int>(rows));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(width));
  }
  bool Evaluate(const double* const* parameters, double* residuals, double** jacobians) const override {
    using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    const Eigen::Map<const Eigen::VectorXd> values(parameters[0], hypothesis_.size());
    Eigen::Map<Eigen::VectorXd>(residuals, num_residuals()) = hypothesis_.prior_residuals(values, model_error_);
    if (jacobians != nullptr && jacobians[0] != nullptr)
      Eigen::Map<RowMajor>(jacobians[0], num_residuals(), values.size()) =
          hypothesis_.prior_jacobian(values, model_error_);
    return true;
  }

 private:
  const Hypothesis& hypothesis_;
  double model_error_;
};

void set_bounds(ceres::Problem& problem, const Hypothesis& hypothesis, Eigen::VectorXd& values) {
  for (Eigen::Index i = 0; i < hypothesis.size(); ++i) {
    const FitParameter& parameter = hypothesis.parameters()[static_cast<std::size_t>(i)];
    if (std::isfinite(parameter.lower))
      problem.SetParameterLowerBound(values.data(), static_cast<int>(i), parameter.lower);
    if (std::isfinite(parameter.upper))
      problem.SetParameterUpperBound(values.data(), static_cast<int>(i), parameter.upper);
  }
}

// Moves parameters, if they are free, and local numbers to the least squares. They stay where the solver finds no step.
void minimise(const FitRequest& request, ResidualBlocks& blocks, bool parameters_free, const std::vector<int>& held,
              Coordinator& coordinator, Eigen::VectorXd& values) {
  const bool has_local_numbers =
      std::ranges::any_of(blocks.blocks(), [](const ResidualBlock& block) { return !block.local.empty(); });
  const bool free = parameters_free && static_cast<std::size_t>(values.size()) > held.size();
  if (!has_local_numbers && !free) return;
  const Eigen::VectorXd values_before = values;
  const std::vector<double> local_before(blocks.local_numbers().begin(), blocks.local_numbers().end());
  ceres::Problem::Options problem_options;
  problem_options.evaluation_callback = &coordinator;
  ceres::Problem problem(problem_options);
  // Even a hypothesis without parameters needs a parameter block for its residuals.
  Eigen::VectorXd no_parameter = Eigen::VectorXd::Zero(1);
  double* shared = values.size() > 0 ? values.data() : no_parameter.data();
  const Eigen::Index width = std::max<Eigen::Index>(1, values.size());
  problem.AddParameterBlock(shared, static_cast<int>(width));
  auto ordering = std::make_shared<ceres::ParameterBlockOrdering>();
  ordering->AddElementToGroup(shared, 1);
  for (std::size_t b = 0; b < blocks.blocks().size(); ++b) {
    const ResidualBlock& block = blocks.blocks()[b];
    auto* cost = new BlockCost(coordinator, b, block.rows, width, block.local.size());
    if (block.local.empty()) {
      problem.AddResidualBlock(cost, nullptr, shared);
    } else {
      problem.AddResidualBlock(cost, nullptr, shared, block.local.data());
      ordering->AddElementToGroup(block.local.data(), 0);
    }
  }
  if (const auto priors = std::ranges::count_if(request.hypothesis->parameters(), &FitParameter::has_prior); priors > 0)
    problem.AddResidualBlock(new PriorCost(*request.hypothesis, replay::model_error_of(request.runs), priors, width),
                             nullptr, shared);
  if (values.size() > 0) set_bounds(problem, *request.hypothesis, values);
  if (!free) problem.SetParameterBlockConstant(shared);
  if (free && !held.empty()) problem.SetManifold(shared, new ceres::SubsetManifold(static_cast<int>(width), held));
  ceres::Solver::Options options;
  options.linear_solver_type = has_local_numbers ? ceres::DENSE_SCHUR : ceres::DENSE_QR;
  if (has_local_numbers) options.linear_solver_ordering = ordering;
  options.max_num_iterations = request.effort.iterations;
  options.function_tolerance = request.effort.tolerance;
  options.parameter_tolerance = 1e-9;
  // A first step may lead where there is no model (a mass of nothing); each shorter one comes closer.
  options.max_num_consecutive_invalid_steps = 20;
  // Steps that leave the bounds are projected onto them; the line search along them that Ceres would add costs more
  // simulated runs than it saves.
  options.max_num_line_search_step_size_iterations = 0;
  options.logging_type = ceres::SILENT;
  options.num_threads = 1;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  if (summary.IsSolutionUsable()) return;
  // The last step that it tried, all of which led where there is no model.
  values = values_before;
  std::ranges::copy(local_before, blocks.local_numbers().begin());
}

// Numbers that change no residual where the values are, and that their priors pull elsewhere: the closing angle of
// faces that do not touch. Nothing tells a solver that a wall lies on their way; each of its steps would run into the
// wall and be refused, and the steps of all numbers would become as short as this one's.
std::vector<int> insensitive_to_residuals(const FitRequest& request, const ResidualValues& here,
                                          const Eigen::VectorXd& parameters) {
  constexpr double least_way = 0.1;  // tolerances: a nearer prior hardly pulls
  std::vector<int> out;
  for (Eigen::Index i = 0; i < parameters.size(); ++i) {
    const FitParameter& parameter = request.hypothesis->parameters()[static_cast<std::size_t>(i)];
    const bool pulled = parameter.is_pulled(parameters[i]) && std::abs(parameter.distance(parameters[i])) > least_way;
    if (!pulled || request.held_parameter == i) continue;
    if (std::ranges::all_of(here.blocks, [i](const auto& block) { return block.jacobian.col(i).isZero(0.0); }))
      out.push_back(static_cast<int>(i));
  }
  return out;
}

// Moves an idle number towards its declared value as far as the sum of squares falls. True if it moved notably.
bool slide(const FitRequest& request, ResidualBlocks& blocks, int number, Eigen::VectorXd& parameters) {
  constexpr double notable = 0.1;  // of chi-square
  constexpr int bits = 10;         // of the way
  const FitParameter& parameter = request.hypothesis->parameters()[static_cast<std::size_t>(number)];
  const double from = parameters[number];
  const auto squares = [&](double share) {
    parameters[number] = from + share * (parameter.declared - from);
    const auto there = blocks.evaluate(parameters, Derivatives::none);
    if (!there) return std::numeric_limits<double>::max();
    double sum = request.hypothesis->prior_residuals(parameters, replay::model_error_of(request.runs)).squaredNorm();
    for (const ResidualValues::Block& block : there->blocks) sum += block.residuals.squaredNorm();
    return sum;
  };
  const double here = squares(0.0);
  std::uintmax_t steps = 20;
  auto [share, least] = boost::math::tools::brent_find_minima(squares, 0.0, 1.0, bits, steps);
  if (const double whole = squares(1.0); whole <= least) {
    share = 1.0;
    least = whole;
  }
  const bool moved = here - least > notable;
  parameters[number] = moved ? from + share * (parameter.declared - from) : from;
  return moved;
}

}  // namespace

std::optional<Optimum> least_squares(const FitRequest& request, ResidualBlocks& blocks, Unknowns unknowns) {
  Eigen::VectorXd parameters = request.hypothesis->clamped(request.start);
  const Derivatives derivatives =
      unknowns == Unknowns::local_numbers ? Derivatives::by_local_numbers : Derivatives::all;
  Coordinator coordinator(blocks, parameters, derivatives, request.updates_derivatives);
  const int most_rounds = request.effort.iterations > 0 ? 3 : 0;
  for (int round = 0; round < most_rounds; ++round) {
    // A solver cannot start where there is no model.
    const ResidualValues* here = coordinator.here();
    if (here == nullptr) return std::nullopt;
    std::vector<int> held;
    if (unknowns == Unknowns::all) held = insensitive_to_residuals(request, *here, parameters);
    bool moved = round == 0;
    for (const int number : held) moved = slide(request, blocks, number, parameters) || moved;
    if (!moved) break;
    const bool any_idle = !held.empty();
    if (request.held_parameter) held.push_back(static_cast<int>(*request.held_parameter));
    minimise(request, blocks, unknowns == Unknowns::all, held, coordinator, parameters);
    if (!any_idle) break;
  }
  ResidualValues* found = coordinator.here();
  if (found == nullptr) return std::nullopt;
  return Optimum{.parameters = parameters, .values = std::move(*found)};
}

}  // namespace coilwright::measurement::fit
