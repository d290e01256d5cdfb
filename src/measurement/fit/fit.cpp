#include "measurement/fit/fit.hpp"

#include <utility>

#include "coilwright/algebra/least_squares.hpp"
#include "measurement/fit/least_squares.hpp"
#include "measurement/fit/recorded_fit.hpp"
#include "measurement/fit/residual_blocks.hpp"

namespace coilwright::measurement::fit {
namespace {

// Orthonormal columns that span what the local numbers of a window can do to its residuals.
Eigen::MatrixXd basis_of(const Eigen::MatrixXd& local_jacobian) {
  if (local_jacobian.cols() == 0) return {local_jacobian.rows(), 0};
  return algebra::orthonormal(local_jacobian);
}

Fit fit_at(const FitRequest& request, std::span<const ResidualBlock> blocks, const Optimum& optimum) {
  const Eigen::VectorXd& values = optimum.parameters;
  const Hypothesis& hypothesis = *request.hypothesis;
  Fit out{.values = values};
  const Eigen::Index p = values.size();
  out.runs.resize(request.runs.size());
  for (std::size_t r = 0; r < out.runs.size(); ++r) {
    out.runs[r].normal_matrix.setZero(p, p);
    out.runs[r].gradient.setZero(p);
    out.runs[r].predictions = optimum.values.predictions[r];
    out.runs[r].residuals.resize(out.runs[r].predictions.size());
    out.used_samples += static_cast<std::size_t>(out.runs[r].residuals.size() - request.runs[r].values_set_aside());
  }
  out.model_error = replay::model_error_of(request.runs);
  const Eigen::VectorXd prior = hypothesis.prior_residuals(values, out.model_error);
  Eigen::Index rows = prior.size();
  for (const ResidualBlock& block : blocks) rows += block.rows;
  out.stacked_residuals.resize(rows);
  out.jacobian.resize(rows, p);
  Eigen::Index row = 0;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const ResidualBlock& block = blocks[b];
    RunFit& run = out.runs[block.run];
    const ResidualValues::Block& there = optimum.values.blocks[b];
    run.residuals.segment(block.first, block.samples()) = there.residuals.head(block.samples());
    out.priors += there.residuals.tail(block.rows - block.samples()).squaredNorm();
    const Eigen::MatrixXd basis = basis_of(there.local_jacobian);
    const Eigen::MatrixXd jacobian = there.jacobian - basis * (basis.transpose() * there.jacobian);
    run.normal_matrix += jacobian.transpose() * jacobian;
    run.gradient += jacobian.transpose() * there.residuals;
    out.stacked_residuals.segment(row, block.rows) = there.residuals;
    // Without parameters there is no memory to point into.
    if (p > 0) out.jacobian.middleRows(row, block.rows) = jacobian;
    out.local_bases.push_back(basis);
    out.parameter_columns.push_back(there.jacobian);
    out.local_columns.push_back(there.local_jacobian);
    row += block.rows;
    run.local_numbers.emplace_back(block.local.begin(), block.local.end());
  }
  const Eigen::MatrixXd prior_jacobian = hypothesis.prior_jacobian(values, out.model_error);
  out.stacked_residuals.tail(prior.size()) = prior;
  if (p > 0) out.jacobian.bottomRows(prior.size()) = prior_jacobian;
  out.prior_chi_square = hypothesis.prior_residuals(values).squaredNorm();
  out.priors += prior.squaredNorm();
  out.normal_matrix = prior_jacobian.transpose() * prior_jacobian;
  for (const RunFit& run : out.runs) {
    out.chi_square += run.residuals.squaredNorm();
    out.normal_matrix += run.normal_matrix;
  }
  for (Eigen::Index i = 0; i < p; ++i) {
    const FitParameter& parameter = hypothesis.parameters()[static_cast<std::size_t>(i)];
    const double near = 1e-6 * parameter.scale;
    out.at_bound.push_back(values[i] <= parameter.lower + near || values[i] >= parameter.upper - near);
  }
  return out;
}

std::optional<Fit> solve(const FitRequest& request, Unknowns unknowns) {
  ResidualBlocks blocks(request);
  const auto optimum = recorded_or(request, blocks, unknowns, [&] {
    if (request.local_numbers_from == nullptr) blocks.start_clock_rates(request.start);
    return least_squares(request, blocks, unknowns);
  });
  if (!optimum) return std::nullopt;
  return fit_at(request, blocks.blocks(), *optimum);
}

}  // namespace

std::optional<Fit> fit(const FitRequest& request) {
  return solve(request, Unknowns::all);
}

std::optional<Fit> evaluate_at(const FitRequest& request) {
  return solve(request, Unknowns::local_numbers);
}

std::optional<Fit> evaluate_with_jacobian(const FitRequest& request) {
  return solve(request, Unknowns::local_numbers_with_jacobian);
}

namespace {

std::vector<signals::ScaledResidual::KnownBand> known_bands(const replay::PreparedRun& prepared, std::size_t channel) {
  std::vector<signals::ScaledResidual::KnownBand> out;
  if (channel >= prepared.whiteners.size() || prepared.whiteners[channel] == nullptr) return out;
  const signals::Whitener& whitener = *prepared.whiteners[channel];
  for (const signals::NoiseColour::Band& band : whitener.colour().bands)
    out.push_back({.to = band.to * whitener.interval(), .freedom = band.freedom});
  return out;
}

}  // namespace

std::vector<signals::ScaledResidual> scaled_residuals(std::span<const replay::PreparedRun> runs, const Fit& fit) {
  std::vector<signals::ScaledResidual> out;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const data::Run& run = *runs[r].run;
    const std::size_t channels = run.channels.size();
    const auto first = out.size();
    for (std::size_t c = 0; c < channels; ++c)
      out.push_back({.run = channels == 1 ? run.name : run.name + " " + run.channels[c].name,
                     .starts = {},
                     .own_estimate = runs[r].noise[c].from_the_run && !runs[r].noise[c].pooled,
                     .freedom = runs[r].noise[c].freedom,
                     .bands = known_bands(runs[r], c)});
    Eigen::Index at = 0;
    for (const replay::SampleRange& range : runs[r].sample_ranges()) {
      for (std::size_t c = 0; c < channels; ++c) {
        signals::ScaledResidual& series = out[first + c];
        series.starts.push_back(series.values.size());
        for (std::size_t i = range.first; i < range.last; ++i) {
          series.values.push_back(fit.runs[r].residuals[at++]);
          if (!run.times.empty()) series.times.push_back(run.times[i]);
        }
      }
    }
  }
  return out;
}

}  // namespace coilwright::measurement::fit
