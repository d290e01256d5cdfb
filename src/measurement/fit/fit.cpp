#include "measurement/fit/fit.hpp"

#include <ceres/ceres.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "measurement/fit/residual_blocks.hpp"

namespace coilwright::measurement::fit {
namespace {

// Ceres asks once for a point; everything is evaluated then, in parallel, and the blocks only copy.
class Coordinator : public ceres::EvaluationCallback {
 public:
  Coordinator(ResidualBlocks& blocks, Eigen::VectorXd& parameters, Slopes slopes)
      : blocks_(blocks), parameters_(parameters), slopes_(slopes) {}

  void PrepareForEvaluation(bool slopes, bool /*new_point*/) override { move_here(slopes); }
  // All there is to know where the solver stands: often kept from its last good step. Null where there is no model.
  [[nodiscard]] const ResidualValues* here() {
    move_here(true);
    return values();
  }
  // What the blocks copy.
  [[nodiscard]] const ResidualValues* values() const { return now_->values ? &*now_->values : nullptr; }

 private:
  struct Point {
    Eigen::VectorXd parameters{};
    std::vector<double> starts{};
    std::optional<ResidualValues> values{};
  };

  [[nodiscard]] bool is_here(const Point& point) const {
    return point.values && point.parameters == parameters_ && std::ranges::equal(point.starts, blocks_.starts());
  }

  void move_here(bool slopes) {
    if (is_here(with_slopes_) || (!slopes && is_here(without_slopes_))) {
      now_ = is_here(with_slopes_) ? &with_slopes_ : &without_slopes_;
      return;
    }
    now_ = slopes ? &with_slopes_ : &without_slopes_;
    const std::span<const double> starts = blocks_.starts();
    *now_ = {.parameters = parameters_,
             .starts = {starts.begin(), starts.end()},
             .values = blocks_.evaluate(parameters_, slopes ? slopes_ : Slopes::none)};
  }

  ResidualBlocks& blocks_;
  Eigen::VectorXd& parameters_;
  Slopes slopes_;
  Point with_slopes_, without_slopes_;
  Point* now_ = &without_slopes_;
};

class BlockCost : public ceres::CostFunction {
 public:
  BlockCost(const Coordinator& coordinator, std::size_t block, Eigen::Index rows, Eigen::Index parameters,
            std::size_t start)
      : coordinator_(coordinator), block_(block) {
    set_num_residuals(static_cast<int>(rows));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(parameters));
    if (start > 0) mutable_parameter_block_sizes()->push_back(static_cast<int>(start));
  }
  bool Evaluate(const double* const* /*parameters*/, double* residuals, double** jacobians) const override {
    if (coordinator_.values() == nullptr) return false;
    using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    const ResidualValues::Block& values = coordinator_.values()->blocks[block_];
    Eigen::Map<Eigen::VectorXd>(residuals, values.residuals.size()) = values.residuals;
    if (jacobians == nullptr) return true;
    if (jacobians[0] != nullptr)
      Eigen::Map<RowMajor>(jacobians[0], values.slopes.rows(), values.slopes.cols()) = values.slopes;
    if (parameter_block_sizes().size() > 1 && jacobians[1] != nullptr)
      Eigen::Map<RowMajor>(jacobians[1], values.start_slopes.rows(), values.start_slopes.cols()) = values.start_slopes;
    return true;
  }

 private:
  const Coordinator& coordinator_;
  std::size_t block_;
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

// Moves parameters (where they are free) and starts to the least squares. False where the solver finds no way.
bool minimize(const FitRequest& request, const ResidualBlocks& blocks, bool parameters_free, Coordinator& coordinator,
              Eigen::VectorXd& values) {
  const bool starts = std::ranges::any_of(blocks.blocks(), [](const ResidualBlock& block) { return !block.whole_run; });
  const bool free = parameters_free && values.size() > (request.held ? 1 : 0);
  if (!starts && !free) return true;
  ceres::Problem::Options problem_options;
  problem_options.evaluation_callback = &coordinator;
  ceres::Problem problem(problem_options);
  // A hypothesis without numbers still needs a block to hang the residuals on.
  Eigen::VectorXd nothing = Eigen::VectorXd::Zero(1);
  double* shared = values.size() > 0 ? values.data() : nothing.data();
  const Eigen::Index width = std::max<Eigen::Index>(1, values.size());
  problem.AddParameterBlock(shared, static_cast<int>(width));
  auto ordering = std::make_shared<ceres::ParameterBlockOrdering>();
  ordering->AddElementToGroup(shared, 1);
  for (std::size_t b = 0; b < blocks.blocks().size(); ++b) {
    const ResidualBlock& block = blocks.blocks()[b];
    auto* cost = new BlockCost(coordinator, b, block.rows, width, block.start.size());
    if (block.whole_run) {
      problem.AddResidualBlock(cost, nullptr, shared);
    } else {
      problem.AddResidualBlock(cost, nullptr, shared, block.start.data());
      ordering->AddElementToGroup(block.start.data(), 0);
    }
  }
  if (values.size() > 0) set_bounds(problem, *request.hypothesis, values);
  if (!free) problem.SetParameterBlockConstant(shared);
  if (free && request.held)
    problem.SetManifold(shared, new ceres::SubsetManifold(static_cast<int>(width), {static_cast<int>(*request.held)}));
  ceres::Solver::Options options;
  options.linear_solver_type = starts ? ceres::DENSE_SCHUR : ceres::DENSE_QR;
  if (starts) options.linear_solver_ordering = ordering;
  options.max_num_iterations = request.effort.iterations;
  options.function_tolerance = request.effort.tolerance;
  options.parameter_tolerance = 1e-9;
  // Steps that leave the bounds are projected onto them; the line search along them that Ceres would add costs more
  // runs than it saves.
  options.max_num_line_search_step_size_iterations = 0;
  options.logging_type = ceres::SILENT;
  options.num_threads = 1;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  return summary.IsSolutionUsable();
}

// Orthonormal columns that span what the start of a window can do to its residuals.
Eigen::MatrixXd basis_of(const Eigen::MatrixXd& start_slopes) {
  if (start_slopes.cols() == 0) return Eigen::MatrixXd(start_slopes.rows(), 0);
  const Eigen::HouseholderQR<Eigen::MatrixXd> factor(start_slopes);
  return factor.householderQ() * Eigen::MatrixXd::Identity(start_slopes.rows(), start_slopes.cols());
}

Fit read_out(const FitRequest& request, std::span<const ResidualBlock> blocks, const ResidualValues& found,
             const Eigen::VectorXd& values) {
  Fit out{.values = values};
  const Eigen::Index p = values.size();
  out.normal.setZero(p, p);
  out.runs.resize(request.records.size());
  for (std::size_t r = 0; r < out.runs.size(); ++r) {
    out.runs[r].normal.setZero(p, p);
    out.runs[r].slope.setZero(p);
    out.runs[r].predictions = found.predictions[r];
    out.runs[r].residuals.resize(out.runs[r].predictions.size());
  }
  Eigen::Index rows = 0;
  for (const ResidualBlock& block : blocks) rows += block.rows;
  out.stacked.resize(rows);
  out.slopes.resize(rows, p);
  Eigen::Index row = 0;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const ResidualBlock& block = blocks[b];
    RunFit& run = out.runs[block.record];
    const ResidualValues::Block& there = found.blocks[b];
    const Eigen::Index pulls = static_cast<Eigen::Index>(block.start.size());
    run.residuals.segment(block.first, block.rows - pulls) = there.residuals.head(block.rows - pulls);
    const Eigen::MatrixXd basis = basis_of(there.start_slopes);
    const Eigen::MatrixXd slopes = there.slopes - basis * (basis.transpose() * there.slopes);
    run.normal += slopes.transpose() * slopes;
    run.slope += slopes.transpose() * there.residuals;
    out.stacked.segment(row, block.rows) = there.residuals;
    out.slopes.middleRows(row, block.rows) = slopes;
    out.start_bases.push_back(basis);
    row += block.rows;
    if (!block.whole_run) run.starts.push_back(start_of(block));
  }
  for (const RunFit& run : out.runs) {
    out.chi_square += run.residuals.squaredNorm();
    out.normal += run.normal;
  }
  for (Eigen::Index i = 0; i < p; ++i) {
    const FitParameter& parameter = request.hypothesis->parameters()[static_cast<std::size_t>(i)];
    const double near = 1e-6 * parameter.scale;
    out.at_bound.push_back(values[i] <= parameter.lower + near || values[i] >= parameter.upper - near);
  }
  return out;
}

std::optional<Fit> solve(const FitRequest& request, bool parameters_free, Slopes slopes) {
  ResidualBlocks blocks(request);
  Eigen::VectorXd values = request.hypothesis->clamped(request.start);
  Coordinator coordinator(blocks, values, slopes);
  // A start where there is no model is nothing for a solver.
  if (coordinator.here() == nullptr) return std::nullopt;
  if (!minimize(request, blocks, parameters_free, coordinator, values)) return std::nullopt;
  const ResidualValues* found = coordinator.here();
  if (found == nullptr) return std::nullopt;
  return read_out(request, blocks.blocks(), *found, values);
}

}  // namespace

std::size_t Fit::samples() const {
  Eigen::Index count = 0;
  for (const RunFit& run : runs) count += run.residuals.size();
  return static_cast<std::size_t>(count);
}

std::optional<Fit> fit(const FitRequest& request) {
  return solve(request, true, Slopes::all);
}

std::optional<Fit> evaluate_at(const FitRequest& request) {
  return solve(request, false, Slopes::of_starts);
}

std::optional<Fit> evaluate_with_slopes(const FitRequest& request) {
  return solve(request, false, Slopes::all);
}

std::vector<whiteness::ScaledResidual> scaled_residuals(std::span<const replay::Record> records, const Fit& fit) {
  std::vector<whiteness::ScaledResidual> out;
  for (std::size_t r = 0; r < records.size(); ++r) {
    const data::Run& run = *records[r].run;
    const std::size_t channels = run.channels.size();
    const auto first = out.size();
    for (std::size_t c = 0; c < channels; ++c)
      out.push_back({.run = channels == 1 ? run.name : run.name + " " + run.channels[c].name,
                     .starts = {},
                     .sigma_given = records[r].noise[c].given});
    Eigen::Index at = 0;
    for (const replay::SampleRange& stretch : records[r].stretches()) {
      for (std::size_t c = 0; c < channels; ++c) {
        whiteness::ScaledResidual& series = out[first + c];
        series.starts.push_back(series.values.size());
        for (std::size_t i = stretch.first; i < stretch.last; ++i) {
          series.values.push_back(fit.runs[r].residuals[at++]);
          if (!run.times.empty()) series.times.push_back(run.times[i]);
        }
      }
    }
  }
  return out;
}

}  // namespace coilwright::measurement::fit
