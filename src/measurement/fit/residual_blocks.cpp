#include "measurement/fit/residual_blocks.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "measurement/fit/fit.hpp"
#include "measurement/replay/rig_change.hpp"

namespace coilwright::measurement::fit {
namespace {

using actuator::InternalStates;
using actuator::Model;
using replay::Trajectory;

// Step of a forward difference as a fraction of a typical change: the truncation error is a ten-thousandth, and the
// integrator's error is smaller.
constexpr double parameter_step = 1e-4;
// The step in an initial state exceeds the integrator's error and stays in the linear range: it is about the noise.
constexpr double initial_state_step = 1e-5;
// The same for a number that has a tolerance, as a fraction of it.
constexpr double tolerance_step = 0.01;
// The step in another local number, as a fraction of its prior deviation; of half of the way between two samples for
// the place of an edge.
constexpr double local_number_step = 1e-3;

// The residuals of a window, followed by those of the prior of its local numbers.
Eigen::VectorXd with_prior(const ResidualBlock& block, const replay::PreparedRun& prepared, replay::SampleRange range,
                           const Eigen::VectorXd& predicted, std::span<const double> local) {
  Eigen::VectorXd out(block.rows);
  out.head(predicted.size()) =
      replay::over_noise(prepared, range, replay::measured_values(*prepared.run, range) - predicted);
  for (std::size_t i = 0; i < local.size(); ++i)
    out[predicted.size() + static_cast<Eigen::Index>(i)] =
        (block.numbers.mean()[i] - local[i]) / block.numbers.sigma()[i];
  return out;
}

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

// The models of one set of parameters, one for each way in which the rig was changed.
class ResidualBlocks::Models {
 public:
  Models(const actuator::ModelSpec& spec, const std::vector<data::RigChange>& rigs) {
    for (const data::RigChange& rig : rigs) models_.emplace_back(replay::on_changed_rig(spec, rig));
  }
  [[nodiscard]] const Model& on(std::size_t rig) const { return models_[rig]; }

 private:
  std::vector<Model> models_;
};

// What one run gives at one set of parameters.
struct ResidualBlocks::RunValues {
  std::vector<Eigen::VectorXd> residuals{};  // of its blocks
  Eigen::VectorXd predictions{};
  std::vector<InternalStates> internal{};  // at the start of each block
  std::vector<Trajectory> trajectories{};  // of each block; none on a bench
};

// The models with one parameter displaced, for a forward difference.
struct ResidualBlocks::Displaced {
  Eigen::Index parameter{};
  double step{};
  Models models;
};

// Parameters and local numbers with the models and motions that they give.
struct ResidualBlocks::Place {
  Eigen::VectorXd parameters{};
  std::vector<double> local_numbers{};
  Models models;
  std::vector<RunValues> runs{};
};

ResidualBlocks::~ResidualBlocks() = default;

ResidualBlocks::ResidualBlocks(const FitRequest& request) : request_(request) {
  for (std::size_t r = 0; r < request.runs.size(); ++r) {
    const data::RigChange& rig = request.runs[r].run->rig;
    const auto known = std::ranges::find(rigs_, rig);
    rig_of_run_.push_back(static_cast<std::size_t>(known - rigs_.begin()));
    if (known == rigs_.end()) rigs_.push_back(rig);
    add_blocks(r);
  }
  std::size_t size = 0;
  for (const ResidualBlock& block : blocks_) size += block.numbers.size();
  local_numbers_.reserve(size);
  // A solver eliminates the local numbers in the order of their addresses: they lie one after the other, so that sums
  // are always taken in the same order.
  for (ResidualBlock& block : blocks_) {
    const bool from_fit = request.local_numbers_from != nullptr && block.numbers.size() > 0;
    const std::vector<double>& values =
        from_fit ? request.local_numbers_from->runs[block.run].local_numbers[block.window] : block.numbers.mean();
    const std::size_t begin = local_numbers_.size();
    local_numbers_.insert(local_numbers_.end(), values.begin(), values.end());
    block.local = std::span(local_numbers_).subspan(begin, values.size());
  }
}

void ResidualBlocks::add_blocks(std::size_t r) {
  const replay::PreparedRun& prepared = request_.runs[r];
  first_block_.push_back(blocks_.size());
  if (!prepared.is_motion()) {
    blocks_.push_back({.run = r, .rows = prepared.values(), .numbers = replay::LocalNumbers()});
  } else {
    Eigen::Index first = 0;
    for (std::size_t w = 0; w < prepared.windows.size(); ++w) {
      const replay::Window& window = prepared.windows[w];
      ResidualBlock block{.run = r, .window = w, .first = first, .numbers = replay::LocalNumbers(prepared, window)};
      block.rows = prepared.values_in(window.range) + static_cast<Eigen::Index>(block.numbers.size());
      first += prepared.values_in(window.range);
      blocks_.push_back(std::move(block));
    }
  }
  last_block_.push_back(blocks_.size());
}

bool ResidualBlocks::is_here(const Eigen::VectorXd& parameters) const {
  return here_ && here_->parameters == parameters && here_->local_numbers == local_numbers_;
}

// Simulates all runs; returns their number. here_ is null if one of them cannot be.
long ResidualBlocks::move_to(const Eigen::VectorXd& parameters) {
  here_ = nullptr;
  std::optional<Models> models = models_at(parameters);
  if (!models) return 0;
  const std::size_t runs = request_.runs.size();
  std::vector<std::optional<RunValues>> evaluated(runs);
  tbb::parallel_for(std::size_t{0}, runs, [&](std::size_t r) { evaluated[r] = evaluate_run(*models, r); });
  if (std::ranges::all_of(evaluated, [](const auto& run) { return run.has_value(); })) {
    here_ = std::make_unique<Place>(
        Place{.parameters = parameters, .local_numbers = local_numbers_, .models = std::move(*models)});
    for (std::optional<RunValues>& run : evaluated) here_->runs.push_back(std::move(*run));
  }
  return static_cast<long>(runs);
}

Counted<std::optional<ResidualValues>> ResidualBlocks::evaluate(const Eigen::VectorXd& parameters,
                                                                Derivatives derivatives) {
  long simulated_runs = is_here(parameters) ? 0 : move_to(parameters);
  const auto no_model = [&] {
    return Counted<std::optional<ResidualValues>>{.value = std::nullopt, .simulated_runs = simulated_runs};
  };
  if (!here_) return no_model();
  ResidualValues out;
  for (const RunValues& run : here_->runs) {
    for (const Eigen::VectorXd& residuals : run.residuals) out.blocks.push_back({.residuals = residuals});
    out.predictions.push_back(run.predictions);
  }
  if (derivatives == Derivatives::none) return {.value = std::move(out), .simulated_runs = simulated_runs};
  for (std::size_t b = 0; b < blocks_.size(); ++b) out.blocks[b].jacobian.setZero(blocks_[b].rows, parameters.size());
  if (derivatives == Derivatives::all) {
    const auto displaced = displaced_models(parameters);
    if (!displaced) return no_model();
    simulated_runs += static_cast<long>(displaced->size() * request_.runs.size());
    add_jacobian(parameters, *displaced, out);
    add_known_columns(out);
  }
  if (!add_local_jacobian(here_->models, here_->runs, out)) return no_model();
  return {.value = std::move(out), .simulated_runs = simulated_runs};
}

std::optional<ResidualBlocks::Models> ResidualBlocks::models_at(const Eigen::VectorXd& parameters) const {
  try {
    return Models(request_.hypothesis->spec_at(parameters), rigs_);
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

std::optional<ResidualBlocks::RunValues> ResidualBlocks::evaluate_run(const Models& models, std::size_t r) const {
  const Model& model = models.on(rig_of_run_[r]);
  std::optional<RunValues> out = request_.runs[r].is_motion() ? evaluate_windows(model, r) : evaluate_bench(model, r);
  if (out && !std::ranges::all_of(out->residuals, [](const Eigen::VectorXd& one) { return one.allFinite(); }))
    return std::nullopt;
  return out;
}

std::optional<ResidualBlocks::RunValues> ResidualBlocks::evaluate_bench(const Model& model, std::size_t r) const {
  const replay::PreparedRun& prepared = request_.runs[r];
  auto predicted = replay::predict_bench(model, prepared, request_.hypothesis->declared());
  if (!predicted) return std::nullopt;
  return RunValues{
      .residuals = {with_prior(blocks_[first_block_[r]], prepared, prepared.sample_ranges().front(), *predicted, {})},
      .predictions = std::move(*predicted)};
}

// Window after window: where initial states are fitted, the internal states of effects (heat, creep) continue from one
// to the next; angles and rates have an initial state of their own in each.
std::optional<ResidualBlocks::RunValues> ResidualBlocks::evaluate_windows(const Model& model, std::size_t r) const {
  const replay::PreparedRun& prepared = request_.runs[r];
  RunValues out{.predictions = Eigen::VectorXd(prepared.values())};
  InternalStates internal;
  for (std::size_t b = first_block_[r]; b < last_block_[r]; ++b) {
    const ResidualBlock& block = blocks_[b];
    const replay::Window& window = prepared.windows[block.window];
    out.internal.push_back(internal);
    auto motion = replay::simulate_window(model, window, block.local_values(), internal);
    if (!motion) return std::nullopt;
    const Eigen::VectorXd predicted = replay::observed_values(model, prepared, window, *motion, block.local_values());
    if (block.numbers.has_initial_state()) internal = motion->at(prepared.run->times[window.range.last - 1]).internal;
    out.residuals.push_back(with_prior(block, prepared, window.range, predicted, block.local));
    out.predictions.segment(block.first, predicted.size()) = predicted;
    out.trajectories.push_back(std::move(*motion));
  }
  return out;
}

// Whether the derivatives with respect to a number are taken over from another fit.
bool ResidualBlocks::takes_known_column(Eigen::Index parameter) const {
  return request_.derivatives_from != nullptr && request_.hypothesis->is_nominal(parameter);
}

// Nothing if one of the models cannot be built.
std::optional<std::vector<ResidualBlocks::Displaced>> ResidualBlocks::displaced_models(
    const Eigen::VectorXd& parameters) const {
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
    if (!models) return std::nullopt;
    out.push_back({.parameter = i, .step = step, .models = std::move(*models)});
  }
  return out;
}

// Where a displaced model has no motion to either side (a pose about to lose its equilibrium), the derivatives of that
// run are left at zero: the fit then moves on by the others, and takes no step that does not lower its objective.
void ResidualBlocks::add_jacobian(const Eigen::VectorXd& parameters, const std::vector<Displaced>& displaced,
                                  ResidualValues& values) const {
  const std::size_t runs = request_.runs.size();
  tbb::parallel_for(std::size_t{0}, displaced.size() * runs, [&](std::size_t task) {
    const Displaced& to = displaced[task / runs];
    const std::size_t r = task % runs;
    double step = to.step;
    auto there = evaluate_run(to.models, r);
    if (!there) {
      step = -step;
      Eigen::VectorXd at = parameters;
      at[to.parameter] += step;
      if (const std::optional<Models> other = models_at(at)) there = evaluate_run(*other, r);
    }
    if (!there) return;
    for (std::size_t b = 0; b < there->residuals.size(); ++b) {
      ResidualValues::Block& block = values.blocks[first_block_[r] + b];
      block.jacobian.col(to.parameter) = (there->residuals[b] - block.residuals) / step;
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

// Whether all windows could be simulated.
bool ResidualBlocks::add_local_jacobian(const Models& models, const std::vector<RunValues>& runs,
                                        ResidualValues& values) const {
  std::vector<char> simulated(blocks_.size(), 1);
  tbb::parallel_for(std::size_t{0}, blocks_.size(), [&](std::size_t b) {
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
      const LocalStep step = local_step(block, window, i);
      std::vector<double> displaced(block.local.begin(), block.local.end());
      displaced[i] += step.number;
      const replay::LocalValues there{.numbers = &block.numbers, .values = displaced};
      std::optional<Trajectory> moved;
      if (block.numbers.moves(i)) {
        moved = replay::simulate_window(model, window, there, runs[block.run].internal[in_run]);
        if (!moved) {
          simulated[b] = 0;
          return;
        }
      }
      const Trajectory& motion = moved ? *moved : runs[block.run].trajectories[in_run];
      const Eigen::VectorXd predicted = replay::observed_values(model, prepared, window, motion, there);
      out.local_jacobian.col(column) =
          (with_prior(block, prepared, window.range, predicted, displaced) - out.residuals) / step.number;
      out.local_jacobian.col(column).head(samples) *= step.slope_over_chord;
    }
  });
  return std::ranges::count(simulated, 0) == 0;
}

}  // namespace coilwright::measurement::fit
