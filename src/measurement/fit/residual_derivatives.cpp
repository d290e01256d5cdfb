
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "measurement/fit/fit.hpp"
#include "measurement/fit/parallel.hpp"
#include "measurement/fit/residual_blocks.hpp"
#include "measurement/fit/residual_place.hpp"
#include "measurement/fit/update_derivatives.hpp"

// The derivatives of ResidualBlocks, by forward differences, and how they follow a fit.

namespace coilwright::measurement::fit {
namespace {

using actuator::Model;
using replay::Trajectory;

// Step of a forward difference as a fraction of a typical change: the truncation error is a ten-thousandth. Displaced
// models take the steps of the one that is not: under a measured torque, which is rough, their own would leave more in
// a difference than is in it.
constexpr double parameter_step = 1e-4;
// Of the noise: what a hundredth of a tolerance moves by less is rounding. The column is zero then, and the number
// known to be idle.
constexpr double nothing = 1e-7;
// The step in an initial state exceeds the integrator's error and stays in the linear range: it is about the noise.
constexpr double initial_state_step = 1e-5;
// The same for a number that has a tolerance, as a fraction of it.
constexpr double tolerance_step = 0.01;
// The step in another local number, as a fraction of its prior deviation; of half of the way between two samples for
// the place of an edge.
constexpr double local_number_step = 1e-3;

// How far a local number is displaced for its derivative, and what the slope there is over that of the chord.
struct LocalStep {
  double number{};
  double slope_over_chord = 1.0;
};

LocalStep local_step(const ResidualBlock& block, const replay::Window& window, std::size_t i) {
  if (block.numbers.is_state(i)) return {.number = initial_state_step * std::max(1.0, std::abs(block.local[i]))};
  const std::optional<std::size_t> place = block.numbers.edge_of(i);
  if (!place) return {.number = local_number_step * block.numbers.sigma()[i]};
  // Near a sample a number hardly moves its edge: the step is one in time, towards the middle.
  const replay::InputEdge& edge = window.edges[*place];
  const double shift = edge.shift(block.local[i]);
  const double step = std::copysign(local_number_step * edge.half_width, -shift);
  const double number = edge.number(shift + step) - block.local[i];
  return {.number = number, .slope_over_chord = edge.slope(block.local[i]) * number / step};
}

}  // namespace

// Whether the derivatives with respect to a number are taken over from another fit.
bool ResidualBlocks::takes_known_column(Eigen::Index parameter) const {
  return request_.derivatives_from != nullptr && request_.hypothesis->is_nominal(parameter);
}

// Without the numbers that make no model to either side.
std::vector<ResidualBlocks::Displaced> ResidualBlocks::displaced_models(const Eigen::VectorXd& parameters) const {
  std::vector<Displaced> out;
  for (Eigen::Index i = 0; i < parameters.size(); ++i) {
    if (request_.held_parameter == i || takes_known_column(i)) continue;
    // At the edge of what makes a model there may be one to the other side only.
    double step = difference_step(parameters, i);
    std::optional<Models> models;
    for (int side = 0; side < 2 && !models; ++side) {
      if (side == 1) step = -step;
      Eigen::VectorXd at = parameters;
      at[i] += step;
      models = models_at(at);
    }
    if (models) out.push_back({.parameter = i, .step = step, .models = std::move(*models)});
  }
  return out;
}

// Where there is no displaced model to either side, or none with a motion (a pose about to lose its equilibrium), the
// derivatives are left at zero: the fit then moves on by the others, and takes no step that does not lower its
// objective.
void ResidualBlocks::add_jacobian(const Eigen::VectorXd& parameters, const std::vector<Displaced>& displaced,
                                  ResidualValues& values) const {
  const std::size_t runs = request_.runs.size();
  in_parallel(displaced.size() * runs, [&](std::size_t task) {
    const Displaced& to = displaced[task / runs];
    const std::size_t r = task % runs;
    double step = to.step;
    const RunValues* here = &here_->runs[r];
    auto there = evaluate_run(to.models, r, here);
    if (!there) {
      step = -step;
      Eigen::VectorXd at = parameters;
      at[to.parameter] += step;
      if (const std::optional<Models> other = models_at(at)) there = evaluate_run(*other, r, here);
    }
    if (!there) return;
    for (std::size_t b = 0; b < there->residuals.size(); ++b) {
      ResidualValues::Block& block = values.blocks[first_block_[r] + b];
      const Eigen::VectorXd moved = there->residuals[b] - block.residuals;
      const bool may_be_idle = request_.hypothesis->parameters()[static_cast<std::size_t>(to.parameter)].has_prior();
      if (may_be_idle && moved.lpNorm<Eigen::Infinity>() <= nothing) continue;
      block.jacobian.col(to.parameter) = moved / step;
    }
  });
}

void ResidualBlocks::add_known_columns(ResidualValues& values) const {
  for (Eigen::Index i = 0; i < request_.hypothesis->size(); ++i) {
    if (request_.held_parameter == i || !takes_known_column(i)) continue;
    for (std::size_t b = 0; b < blocks_.size(); ++b)
      values.blocks[b].jacobian.col(i) = request_.derivatives_from->parameter_columns[b].col(i);
  }
}

double ResidualBlocks::difference_step(const Eigen::VectorXd& parameters, Eigen::Index i) const {
  const FitParameter& parameter = request_.hypothesis->parameters()[static_cast<std::size_t>(i)];
  // A tolerance is small compared with its number, and the step must still exceed the integrator's error.
  const double typical = parameter.has_prior() ? parameter.scale : std::max(parameter.scale, std::abs(parameters[i]));
  const double step = (parameter.has_prior() ? tolerance_step : parameter_step) * typical;
  return parameters[i] + step <= parameter.upper ? step : -step;
}

// The same of the numbers of one window, but for their priors.
void ResidualBlocks::add_local_jacobian(const Models& models, const std::vector<RunValues>& runs,
                                        ResidualValues& values) const {
  in_parallel(blocks_.size(), [&](std::size_t b) {
    const ResidualBlock& block = blocks_[b];
    ResidualValues::Block& out = values.blocks[b];
    out.local_jacobian.resize(block.rows, static_cast<Eigen::Index>(block.local.size()));
    if (block.local.empty()) return;
    const replay::PreparedRun& prepared = request_.runs[block.run];
    const replay::Window& window = prepared.windows[block.window];
    const Model& model = models.on(rig_of_run_[block.run]);
    const std::size_t in_run = b - first_block_[block.run];
    const Eigen::Index samples = block.samples();
    for (std::size_t i = 0; i < block.local.size(); ++i) {
      const auto column = static_cast<Eigen::Index>(i);
      const std::optional<std::size_t> edge = block.numbers.edge_of(i);
      if (request_.derivatives_from != nullptr && block.numbers.moves(i)) {
        out.local_jacobian.col(column) = request_.derivatives_from->local_columns[b].col(column);
        if (edge) {
          const replay::InputEdge& known = window.edges[*edge];
          const double there = request_.derivatives_from->runs[block.run].local_numbers[block.window][i];
          out.local_jacobian.col(column).head(samples) *= known.slope(block.local[i]) / known.slope(there);
        }
        continue;
      }
      LocalStep step = local_step(block, window, i);
      std::vector<double> displaced(block.local.begin(), block.local.end());
      displaced[i] += step.number;
      const replay::LocalValues there{.numbers = &block.numbers, .values = displaced};
      std::optional<Trajectory> moved;
      for (int side = 0; side < 2 && block.numbers.moves(i) && !moved; ++side) {
        if (side == 1) step.number = -step.number;
        displaced[i] = block.local[i] + step.number;
        moved = replay::simulate_window(model, window, there, runs[block.run].internal[in_run],
                                        &runs[block.run].trajectories[in_run]);
      }
      const Trajectory& motion = moved ? *moved : runs[block.run].trajectories[in_run];
      const Eigen::VectorXd predicted = replay::observed_values(model, prepared, window, motion, there);
      out.local_jacobian.col(column) =
          (residuals_with_prior(block, prepared, window.range, predicted, displaced) - out.residuals) / step.number;
      out.local_jacobian.col(column).head(samples) *= step.slope_over_chord;
    }
  });
}

void ResidualBlocks::carry_derivatives(const ResidualPoint& from, ResidualPoint& to) const {
  StepTaken step{.parameters = to.parameters - from.parameters, .parameter_scales = request_.hypothesis->scales()};
  std::size_t first = 0;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const ResidualBlock& block = blocks_[b];
    const auto count = static_cast<Eigen::Index>(block.local.size());
    const Eigen::Map<const Eigen::VectorXd> before(from.local_numbers.data() + first, count);
    const Eigen::Map<const Eigen::VectorXd> after(to.local_numbers.data() + first, count);
    step.local = after - before;
    step.local_scales = Eigen::Map<const Eigen::VectorXd>(block.numbers.sigma().data(), count);
    first += block.local.size();
    ResidualValues::Block& values = to.values->blocks[b];
    const ResidualValues::Block& known = from.values->blocks[b];
    values.jacobian = known.jacobian;
    values.local_jacobian = known.local_jacobian;
    for (std::size_t i = 0; i < block.local.size(); ++i) {
      const std::optional<std::size_t> place = block.numbers.edge_of(i);
      if (!place) continue;
      const replay::InputEdge& edge = request_.runs[block.run].windows[block.window].edges[*place];
      const auto at = static_cast<Eigen::Index>(i);
      values.local_jacobian.col(at).head(block.samples()) *= edge.slope(after[at]) / edge.slope(before[at]);
    }
    update_derivatives(step, known.residuals, values);
  }
}

}  // namespace coilwright::measurement::fit
