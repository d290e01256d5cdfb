#include "fit.hpp"

#include <ceres/ceres.h>
#include <tbb/parallel_for.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <utility>

#include "prediction.hpp"

namespace coilwright::measurement {
namespace {

using actuator::Model;
using simulation::State;

std::atomic<long> run_count{0};

// Of the size of a usual change: truncation of a forward difference is a ten-thousandth, the integrator's error below.
constexpr double slope_step = 1e-4;

// One run, or one window of it where starts are fitted, as the least-squares program sees it.
struct Block {
  std::size_t record{};
  std::size_t window{};       // of the record
  bool whole_run{};           // all windows in one: nothing of their own to fit
  Eigen::Index rows{};        // residuals, and the pull of the start towards the measurement
  Eigen::Index first{};       // of its residuals in those of the run
  std::span<double> start{};  // angles, rates; what is fitted along
  std::vector<double> guess{}, guess_sigma{};
  std::vector<double> first_start{};
};

// Values of one block and their slopes.
struct BlockValues {
  Eigen::VectorXd residuals;
  Eigen::MatrixXd slopes;        // by the parameters
  Eigen::MatrixXd start_slopes;  // by the start
};

std::vector<double> pack(const State& state) {
  std::vector<double> out(state.angles.begin(), state.angles.end());
  out.insert(out.end(), state.rates.begin(), state.rates.end());
  return out;
}

State unpack(std::span<const double> values, const actuator::InternalStates& internal) {
  const auto n = static_cast<Eigen::Index>(values.size() / 2);
  return {.angles = Eigen::Map<const Eigen::VectorXd>(values.data(), n),
          .rates = Eigen::Map<const Eigen::VectorXd>(values.data() + n, n),
          .internal = internal};
}

// The residuals of all records as a function of parameters and window starts.
class Evaluation {
 public:
  Evaluation(const FitRequest& request) : request_(request) {
    for (std::size_t r = 0; r < request.records.size(); ++r) add_blocks(r);
    place_starts();
  }

  [[nodiscard]] std::vector<Block>& blocks() { return blocks_; }
  [[nodiscard]] const std::vector<BlockValues>& values() const { return values_; }
  [[nodiscard]] const std::vector<Eigen::VectorXd>& predictions() const { return predictions_; }

  // Residuals of all blocks at `parameters`, and their slopes. False where a model cannot be simulated.
  bool evaluate(const Eigen::VectorXd& parameters, bool slopes) {
    values_.assign(blocks_.size(), {});
    predictions_.assign(request_.records.size(), {});
    internal_.assign(blocks_.size(), {});
    std::optional<Model> model = model_at(parameters);
    if (!model) return false;
    const std::size_t runs = request_.records.size();
    std::vector<char> good(runs, 1);
    tbb::parallel_for(std::size_t{0}, runs, [&](std::size_t r) { good[r] = evaluate_run(*model, r, nullptr); });
    if (std::ranges::count(good, 0) > 0) return false;
    return !slopes || evaluate_slopes(*model, parameters);
  }

 private:
  // Ceres eliminates the starts in the order of their addresses: one after the other, so that the sums are always taken
  // in the same order.
  void place_starts() {
    std::size_t size = 0;
    for (const Block& block : blocks_) size += block.first_start.size();
    starts_.reserve(size);
    for (Block& block : blocks_) {
      const std::size_t first = starts_.size();
      starts_.insert(starts_.end(), block.first_start.begin(), block.first_start.end());
      block.start = std::span(starts_).subspan(first);
    }
  }

  void add_blocks(std::size_t r) {
    const Record& record = request_.records[r];
    const auto channels = static_cast<Eigen::Index>(record.run->channels.size());
    first_block_.push_back(blocks_.size());
    if (!record.has_nuisances()) {
      Eigen::Index rows = static_cast<Eigen::Index>(record.run->samples()) * channels;
      if (record.is_motion()) {
        rows = 0;
        for (const Window& window : record.windows) rows += static_cast<Eigen::Index>(window.samples()) * channels;
      }
      blocks_.push_back({.record = r, .whole_run = true, .rows = rows});
    } else {
      Eigen::Index first = 0;
      for (std::size_t w = 0; w < record.windows.size(); ++w) {
        const Window& window = record.windows[w];
        Block block{.record = r, .window = w, .first = first};
        block.guess = pack(window.guess);
        block.guess_sigma = pack(window.guess_sigma);
        block.first_start =
            request_.starts_from == nullptr ? block.guess : pack(request_.starts_from->runs[r].starts[w]);
        const auto samples = static_cast<Eigen::Index>(window.samples()) * channels;
        block.rows = samples + static_cast<Eigen::Index>(block.first_start.size());
        first += samples;
        blocks_.push_back(std::move(block));
      }
    }
    last_block_.push_back(blocks_.size());
  }

  [[nodiscard]] std::optional<Model> model_at(const Eigen::VectorXd& parameters) const {
    try {
      return request_.hypothesis->model_at(parameters);
    } catch (const std::invalid_argument&) {
      return std::nullopt;
    }
  }

  // Residuals of the blocks of a run. With `into`, they go there (one vector a block) instead of into values_.
  bool evaluate_run(const Model& model, std::size_t r, std::vector<Eigen::VectorXd>* into) {
    const Record& record = request_.records[r];
    ++run_count;
    const std::size_t first = first_block_[r];
    if (!record.is_motion()) {
      const auto predicted = predict_bench(model, record, *request_.declared);
      if (!predicted) return false;
      const std::size_t samples = record.run->samples();
      Eigen::VectorXd residuals =
          (measured_values(*record.run, 0, samples) - *predicted).cwiseQuotient(sigmas(record, samples));
      if (into == nullptr) predictions_[r] = *predicted;
      (into != nullptr ? into->front() : values_[first].residuals) = std::move(residuals);
      return true;
    }
    return record.has_nuisances() ? evaluate_windows(model, r, into) : evaluate_rest_run(model, r, into);
  }

  // Every window of a run that starts at rest.
  bool evaluate_rest_run(const Model& model, std::size_t r, std::vector<Eigen::VectorXd>* into) {
    const Record& record = request_.records[r];
    const std::size_t first = first_block_[r];
    Eigen::VectorXd residuals(blocks_[first].rows);
    Eigen::VectorXd predictions(blocks_[first].rows);
    Eigen::Index at = 0;
    for (const Window& window : record.windows) {
      const auto start = rest_start(model, window);
      if (!start) return false;
      const auto predicted = predict_window(model, record, window, *start);
      if (!predicted) return false;
      const Eigen::Index n = predicted->values.size();
      residuals.segment(at, n) = scaled(record, window, predicted->values);
      predictions.segment(at, n) = predicted->values;
      at += n;
    }
    if (into == nullptr) predictions_[r] = std::move(predictions);
    (into != nullptr ? into->front() : values_[first].residuals) = std::move(residuals);
    return residuals_finite(into != nullptr ? into->front() : values_[first].residuals);
  }

  // Window after window: the effects' own states (heat, creep) go on from one to the next, angles and rates start anew.
  bool evaluate_windows(const Model& model, std::size_t r, std::vector<Eigen::VectorXd>* into) {
    const Record& record = request_.records[r];
    actuator::InternalStates internal;
    Eigen::Index samples = 0;
    for (const Window& window : record.windows)
      samples += static_cast<Eigen::Index>(window.samples() * record.run->channels.size());
    Eigen::VectorXd predictions(samples);
    for (std::size_t b = first_block_[r]; b < last_block_[r]; ++b) {
      const Block& block = blocks_[b];
      const Window& window = record.windows[block.window];
      if (into == nullptr) internal_[b] = internal;
      const auto predicted = predict_window(model, record, window, unpack(block.start, internal));
      if (!predicted) return false;
      internal = predicted->states.back().internal;
      Eigen::VectorXd residuals = with_pull(block, record, window, predicted->values, block.start);
      if (!residuals_finite(residuals)) return false;
      predictions.segment(block.first, predicted->values.size()) = predicted->values;
      (into != nullptr ? (*into)[b - first_block_[r]] : values_[b].residuals) = std::move(residuals);
    }
    if (into == nullptr) predictions_[r] = std::move(predictions);
    return true;
  }

  static bool residuals_finite(const Eigen::VectorXd& residuals) { return residuals.allFinite(); }

  [[nodiscard]] static Eigen::VectorXd scaled(const Record& record, const Window& window,
                                              const Eigen::VectorXd& predicted) {
    return (measured_values(*record.run, window.first, window.last) - predicted)
        .cwiseQuotient(sigmas(record, window.samples()));
  }

  [[nodiscard]] static Eigen::VectorXd with_pull(const Block& block, const Record& record, const Window& window,
                                                 const Eigen::VectorXd& predicted, std::span<const double> start) {
    Eigen::VectorXd out(block.rows);
    out.head(predicted.size()) = scaled(record, window, predicted);
    for (std::size_t i = 0; i < start.size(); ++i)
      out[predicted.size() + static_cast<Eigen::Index>(i)] = (block.guess[i] - start[i]) / block.guess_sigma[i];
    return out;
  }

  bool evaluate_slopes(const Model& model, const Eigen::VectorXd& parameters) {
    const Eigen::Index p = parameters.size();
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      values_[b].slopes.setZero(blocks_[b].rows, p);
      values_[b].start_slopes.resize(blocks_[b].rows, static_cast<Eigen::Index>(blocks_[b].start.size()));
    }
    const std::size_t runs = request_.records.size();
    const std::size_t columns = static_cast<std::size_t>(p) * runs;
    std::vector<std::optional<Model>> moved(static_cast<std::size_t>(p));
    std::vector<double> steps(static_cast<std::size_t>(p), 0.0);
    for (Eigen::Index i = 0; i < p; ++i) {
      if (request_.held == i) continue;
      Eigen::VectorXd at = parameters;
      steps[static_cast<std::size_t>(i)] = step_of(parameters, i);
      at[i] += steps[static_cast<std::size_t>(i)];
      moved[static_cast<std::size_t>(i)] = model_at(at);
      if (!moved[static_cast<std::size_t>(i)]) return false;
    }
    std::vector<char> good(columns, 1);
    tbb::parallel_for(std::size_t{0}, columns, [&](std::size_t task) {
      const std::size_t i = task / runs;
      const std::size_t r = task % runs;
      if (!moved[i]) return;
      std::vector<Eigen::VectorXd> out(last_block_[r] - first_block_[r]);
      good[task] = evaluate_run(*moved[i], r, &out);
      if (!good[task]) return;
      for (std::size_t b = 0; b < out.size(); ++b) {
        BlockValues& values = values_[first_block_[r] + b];
        values.slopes.col(static_cast<Eigen::Index>(i)) = (out[b] - values.residuals) / steps[i];
      }
    });
    if (std::ranges::count(good, 0) > 0) return false;
    return evaluate_start_slopes(model);
  }

  [[nodiscard]] double step_of(const Eigen::VectorXd& parameters, Eigen::Index i) const {
    const FitParameter& parameter = request_.hypothesis->parameters()[static_cast<std::size_t>(i)];
    const double step = slope_step * std::max(parameter.scale, std::abs(parameters[i]));
    return parameters[i] + step <= parameter.upper ? step : -step;
  }

  bool evaluate_start_slopes(const Model& model) {
    std::vector<char> good(blocks_.size(), 1);
    tbb::parallel_for(std::size_t{0}, blocks_.size(), [&](std::size_t b) {
      const Block& block = blocks_[b];
      if (block.whole_run) return;
      const Record& record = request_.records[block.record];
      const Window& window = record.windows[block.window];
      for (std::size_t i = 0; i < block.start.size(); ++i) {
        std::vector<double> start(block.start.begin(), block.start.end());
        // Slopes that neither drown in the integrator's error nor leave the straight part: about the noise.
        const double step = 1e-5 * std::max(1.0, std::abs(start[i]));
        start[i] += step;
        const auto predicted = predict_window(model, record, window, unpack(start, internal_[b]));
        if (!predicted) {
          good[b] = 0;
          return;
        }
        values_[b].start_slopes.col(static_cast<Eigen::Index>(i)) =
            (with_pull(block, record, window, predicted->values, start) - values_[b].residuals) / step;
      }
    });
    return std::ranges::count(good, 0) == 0;
  }

  const FitRequest& request_;
  std::vector<Block> blocks_;
  std::vector<double> starts_;                         // of all blocks; never moves
  std::vector<std::size_t> first_block_, last_block_;  // of each record
  std::vector<BlockValues> values_;
  std::vector<Eigen::VectorXd> predictions_;  // of each record
  std::vector<actuator::InternalStates> internal_;
};

// Ceres asks once for a point; everything is evaluated then, in parallel, and the blocks only copy.
class Coordinator : public ceres::EvaluationCallback {
 public:
  Coordinator(Evaluation& evaluation, Eigen::VectorXd& parameters) : evaluation_(evaluation), parameters_(parameters) {}
  // Evaluates the point from which the solver will start. False where there is no model there: nothing for a solver.
  [[nodiscard]] bool start() {
    good_ = evaluation_.evaluate(parameters_, true);
    has_slopes_ = good_;
    at_start_ = true;
    return good_;
  }
  void PrepareForEvaluation(bool slopes, bool new_point) override {
    if (std::exchange(at_start_, false)) return;
    if (!new_point && (has_slopes_ || !slopes)) return;
    good_ = evaluation_.evaluate(parameters_, slopes);
    has_slopes_ = slopes;
  }
  [[nodiscard]] bool good() const { return good_; }

 private:
  Evaluation& evaluation_;
  Eigen::VectorXd& parameters_;
  bool good_ = false;
  bool has_slopes_ = false;
  bool at_start_ = false;
};

class BlockCost : public ceres::CostFunction {
 public:
  BlockCost(const Evaluation& evaluation, const Coordinator& coordinator, std::size_t block, Eigen::Index rows,
            Eigen::Index parameters, std::size_t start)
      : evaluation_(evaluation), coordinator_(coordinator), block_(block) {
    set_num_residuals(static_cast<int>(rows));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(parameters));
    if (start > 0) mutable_parameter_block_sizes()->push_back(static_cast<int>(start));
  }
  bool Evaluate(const double* const* /*parameters*/, double* residuals, double** jacobians) const override {
    if (!coordinator_.good()) return false;
    using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    const BlockValues& values = evaluation_.values()[block_];
    Eigen::Map<Eigen::VectorXd>(residuals, values.residuals.size()) = values.residuals;
    if (jacobians == nullptr) return true;
    if (jacobians[0] != nullptr)
      Eigen::Map<RowMajor>(jacobians[0], values.slopes.rows(), values.slopes.cols()) = values.slopes;
    if (parameter_block_sizes().size() > 1 && jacobians[1] != nullptr)
      Eigen::Map<RowMajor>(jacobians[1], values.start_slopes.rows(), values.start_slopes.cols()) = values.start_slopes;
    return true;
  }

 private:
  const Evaluation& evaluation_;
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

// Orthonormal columns that span what the start of a window can do to its residuals.
Eigen::MatrixXd basis_of(const Eigen::MatrixXd& start_slopes) {
  if (start_slopes.cols() == 0) return Eigen::MatrixXd(start_slopes.rows(), 0);
  const Eigen::HouseholderQR<Eigen::MatrixXd> factor(start_slopes);
  return factor.householderQ() * Eigen::MatrixXd::Identity(start_slopes.rows(), start_slopes.cols());
}

Fit read_out(const FitRequest& request, Evaluation& evaluation, const Eigen::VectorXd& values) {
  Fit out{.values = values};
  const Eigen::Index p = values.size();
  out.normal.setZero(p, p);
  out.runs.resize(request.records.size());
  for (std::size_t r = 0; r < out.runs.size(); ++r) {
    out.runs[r].normal.setZero(p, p);
    out.runs[r].slope.setZero(p);
    out.runs[r].predictions = evaluation.predictions()[r];
    out.runs[r].residuals.resize(out.runs[r].predictions.size());
  }
  Eigen::Index rows = 0;
  for (const Block& block : evaluation.blocks()) rows += block.rows;
  out.stacked.resize(rows);
  out.slopes.resize(rows, p);
  Eigen::Index row = 0;
  for (std::size_t b = 0; b < evaluation.blocks().size(); ++b) {
    const Block& block = evaluation.blocks()[b];
    RunFit& run = out.runs[block.record];
    const BlockValues& values_of = evaluation.values()[b];
    const Eigen::Index pulls = static_cast<Eigen::Index>(block.start.size());
    run.residuals.segment(block.first, block.rows - pulls) = values_of.residuals.head(block.rows - pulls);
    const Eigen::MatrixXd basis = basis_of(values_of.start_slopes);
    const Eigen::MatrixXd slopes = values_of.slopes - basis * (basis.transpose() * values_of.slopes);
    run.normal += slopes.transpose() * slopes;
    run.slope += slopes.transpose() * values_of.residuals;
    out.stacked.segment(row, block.rows) = values_of.residuals;
    out.slopes.middleRows(row, block.rows) = slopes;
    out.start_bases.push_back(basis);
    row += block.rows;
    if (!block.whole_run) run.starts.push_back(unpack(block.start, {}));
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

// The least-squares program over parameters (unless they are held as a whole) and starts.
std::optional<Fit> solve(const FitRequest& request, bool parameters_free) {
  const Hypothesis& hypothesis = *request.hypothesis;
  Evaluation evaluation(request);
  Eigen::VectorXd values = request.start;
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const FitParameter& parameter = hypothesis.parameters()[static_cast<std::size_t>(i)];
    values[i] = std::clamp(values[i], parameter.lower, parameter.upper);
  }
  Coordinator coordinator(evaluation, values);
  const bool starts = std::ranges::any_of(evaluation.blocks(), [](const Block& block) { return !block.whole_run; });
  const bool free = parameters_free && hypothesis.size() > (request.held ? 1 : 0);
  if (starts || free) {
    if (!coordinator.start()) return std::nullopt;
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
    for (std::size_t b = 0; b < evaluation.blocks().size(); ++b) {
      Block& block = evaluation.blocks()[b];
      auto* cost = new BlockCost(evaluation, coordinator, b, block.rows, width, block.start.size());
      if (block.whole_run) {
        problem.AddResidualBlock(cost, nullptr, shared);
      } else {
        problem.AddResidualBlock(cost, nullptr, shared, block.start.data());
        ordering->AddElementToGroup(block.start.data(), 0);
      }
    }
    if (values.size() > 0) set_bounds(problem, hypothesis, values);
    if (!free) problem.SetParameterBlockConstant(shared);
    if (free && request.held)
      problem.SetManifold(shared,
                          new ceres::SubsetManifold(static_cast<int>(width), {static_cast<int>(*request.held)}));
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
    if (!summary.IsSolutionUsable()) return std::nullopt;
  }
  if (!evaluation.evaluate(values, true)) return std::nullopt;
  return read_out(request, evaluation, values);
}

}  // namespace

std::size_t Fit::samples() const {
  Eigen::Index count = 0;
  for (const RunFit& run : runs) count += run.residuals.size();
  return static_cast<std::size_t>(count);
}

std::optional<Fit> fit(const FitRequest& request) {
  return solve(request, true);
}

std::optional<Fit> evaluate_at(const FitRequest& request) {
  return solve(request, false);
}

std::optional<Eigen::VectorXd> direction(const FitRequest& request, const Fit& base) {
  Evaluation evaluation(request);
  if (!evaluation.evaluate(request.start, false)) return std::nullopt;
  Eigen::VectorXd out(base.stacked.size());
  Eigen::Index row = 0;
  for (std::size_t b = 0; b < evaluation.blocks().size(); ++b) {
    const Eigen::Index rows = evaluation.blocks()[b].rows;
    Eigen::VectorXd moved = evaluation.values()[b].residuals - base.stacked.segment(row, rows);
    const Eigen::MatrixXd& basis = base.start_bases[b];
    moved -= basis * (basis.transpose() * moved);
    out.segment(row, rows) = moved;
    row += rows;
  }
  if (base.slopes.cols() == 0) return out;
  const Eigen::VectorXd absorbed = base.normal.completeOrthogonalDecomposition().solve(base.slopes.transpose() * out);
  return Eigen::VectorXd(out - base.slopes * absorbed);
}

std::vector<ScaledResidual> scaled_residuals(std::span<const Record> records, const Fit& fit) {
  std::vector<ScaledResidual> out;
  for (std::size_t r = 0; r < records.size(); ++r) {
    const Run& run = *records[r].run;
    const std::size_t channels = run.channels.size();
    const auto first = out.size();
    for (std::size_t c = 0; c < channels; ++c)
      out.push_back({.run = channels == 1 ? run.name : run.name + " " + run.channels[c].name,
                     .starts = {},
                     .sigma_given = records[r].noise[c].source == "given"});
    Eigen::Index at = 0;
    const auto append = [&](std::size_t begin, std::size_t end) {
      for (std::size_t c = 0; c < channels; ++c) {
        ScaledResidual& series = out[first + c];
        series.starts.push_back(series.values.size());
        for (std::size_t i = begin; i < end; ++i) {
          series.values.push_back(fit.runs[r].residuals[at++]);
          if (!run.times.empty()) series.times.push_back(run.times[i]);
        }
      }
    };
    if (!records[r].is_motion()) append(0, run.samples());
    for (const Window& window : records[r].windows) append(window.first, window.last);
  }
  return out;
}

long simulated_runs() {
  return run_count.load();
}

}  // namespace coilwright::measurement
