#include "measurement/fit/residual_blocks.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "coilwright/simulation/initial_state.hpp"
#include "measurement/fit/fit.hpp"
#include "measurement/replay/prediction.hpp"

namespace coilwright::measurement::fit {
namespace {

using actuator::InternalStates;
using actuator::Model;
using simulation::State;

// Step of a forward difference as a fraction of a typical change: the truncation error is a ten-thousandth, and the
// integrator's error is smaller.
constexpr double parameter_step = 1e-4;
// The step in an initial state exceeds the integrator's error and stays in the linear range: it is about the noise.
constexpr double initial_state_step = 1e-5;

std::vector<double> pack(const State& state) {
  std::vector<double> out(state.angles.begin(), state.angles.end());
  out.insert(out.end(), state.rates.begin(), state.rates.end());
  return out;
}

State unpack(std::span<const double> values, const InternalStates& internal) {
  const auto n = static_cast<Eigen::Index>(values.size() / 2);
  return {.angles = Eigen::Map<const Eigen::VectorXd>(values.data(), n),
          .rates = Eigen::Map<const Eigen::VectorXd>(values.data() + n, n),
          .internal = internal};
}

Eigen::VectorXd scaled(const replay::PreparedRun& prepared, replay::SampleRange range,
                       const Eigen::VectorXd& predicted) {
  return (replay::measured_values(*prepared.run, range) - predicted)
      .cwiseQuotient(replay::noise_sigmas(prepared, range.samples()));
}

// The residuals of a window, followed by those of the prior of its initial state.
Eigen::VectorXd with_prior(const ResidualBlock& block, const replay::PreparedRun& prepared,
                           const Eigen::VectorXd& predicted, std::span<const double> initial_state) {
  Eigen::VectorXd out(block.rows);
  out.head(predicted.size()) = scaled(prepared, prepared.windows[block.window].range, predicted);
  for (std::size_t i = 0; i < initial_state.size(); ++i)
    out[predicted.size() + static_cast<Eigen::Index>(i)] =
        (block.prior_mean[i] - initial_state[i]) / block.prior_sigma[i];
  return out;
}

}  // namespace

// Residuals of the blocks of one run.
struct ResidualBlocks::RunValues {
  std::vector<Eigen::VectorXd> residuals{};
  Eigen::VectorXd predictions{};
  std::vector<InternalStates>
      internal{};  // internal states at the start of each block; empty if a block is a whole run
};

// The model with one parameter displaced, for a forward difference.
struct ResidualBlocks::Displaced {
  Eigen::Index parameter{};
  double step{};
  Model model;
};

State initial_state_of(const ResidualBlock& block) {
  return unpack(block.initial_state, {});
}

ResidualBlocks::ResidualBlocks(const FitRequest& request) : request_(request) {
  for (std::size_t r = 0; r < request.runs.size(); ++r) add_blocks(r);
  std::size_t size = 0;
  for (const ResidualBlock& block : blocks_) size += block.prior_mean.size();
  initial_states_.reserve(size);
  // A solver eliminates the initial states in the order of their addresses: they lie one after the other, so that sums
  // are always taken in the same order.
  for (ResidualBlock& block : blocks_) {
    const bool from_fit = request.initial_states_from != nullptr && !block.whole_run;
    const std::vector<double> values =
        from_fit ? pack(request.initial_states_from->runs[block.run].initial_states[block.window]) : block.prior_mean;
    const std::size_t begin = initial_states_.size();
    initial_states_.insert(initial_states_.end(), values.begin(), values.end());
    block.initial_state = std::span(initial_states_).subspan(begin);
  }
}

void ResidualBlocks::add_blocks(std::size_t r) {
  const replay::PreparedRun& prepared = request_.runs[r];
  first_block_.push_back(blocks_.size());
  if (!prepared.fits_initial_states()) {
    blocks_.push_back({.run = r, .whole_run = true, .rows = prepared.values()});
  } else {
    Eigen::Index first = 0;
    for (std::size_t w = 0; w < prepared.windows.size(); ++w) {
      const replay::Window& window = prepared.windows[w];
      ResidualBlock block{.run = r, .window = w, .first = first};
      block.prior_mean = pack(window.prior.mean);
      block.prior_sigma = pack(window.prior.sigma);
      block.rows = prepared.values_in(window.range) + static_cast<Eigen::Index>(block.prior_mean.size());
      first += prepared.values_in(window.range);
      blocks_.push_back(std::move(block));
    }
  }
  last_block_.push_back(blocks_.size());
}

Counted<std::optional<ResidualValues>> ResidualBlocks::evaluate(const Eigen::VectorXd& parameters,
                                                                Derivatives derivatives) const {
  const std::optional<Model> model = model_at(parameters);
  if (!model) return {};
  const std::size_t runs = request_.runs.size();
  std::vector<std::optional<RunValues>> found(runs);
  tbb::parallel_for(std::size_t{0}, runs, [&](std::size_t r) { found[r] = evaluate_run(*model, r); });
  auto simulated_runs = static_cast<long>(runs);
  ResidualValues out;
  std::vector<InternalStates> internal;
  for (std::optional<RunValues>& run : found) {
    if (!run) return {.value = std::nullopt, .simulated_runs = simulated_runs};
    for (Eigen::VectorXd& residuals : run->residuals) out.blocks.push_back({.residuals = std::move(residuals)});
    out.predictions.push_back(std::move(run->predictions));
    run->internal.resize(run->residuals.size());
    internal.insert(internal.end(), run->internal.begin(), run->internal.end());
  }
  if (derivatives == Derivatives::none) return {.value = std::move(out), .simulated_runs = simulated_runs};
  for (std::size_t b = 0; b < blocks_.size(); ++b) out.blocks[b].jacobian.setZero(blocks_[b].rows, parameters.size());
  if (derivatives == Derivatives::all) {
    const auto displaced = displaced_models(parameters);
    if (!displaced) return {.value = std::nullopt, .simulated_runs = simulated_runs};
    simulated_runs += static_cast<long>(displaced->size() * runs);
    if (!add_jacobian(*displaced, out)) return {.value = std::nullopt, .simulated_runs = simulated_runs};
  }
  if (!add_initial_state_jacobian(*model, internal, out))
    return {.value = std::nullopt, .simulated_runs = simulated_runs};
  return {.value = std::move(out), .simulated_runs = simulated_runs};
}

std::optional<Model> ResidualBlocks::model_at(const Eigen::VectorXd& parameters) const {
  try {
    return request_.hypothesis->model_at(parameters);
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

std::optional<ResidualBlocks::RunValues> ResidualBlocks::evaluate_run(const Model& model, std::size_t r) const {
  const replay::PreparedRun& prepared = request_.runs[r];
  std::optional<RunValues> out;
  if (!prepared.is_motion())
    out = evaluate_bench(model, prepared);
  else
    out = prepared.fits_initial_states() ? evaluate_windows(model, r) : evaluate_run_from_rest(model, prepared);
  if (out && !std::ranges::all_of(out->residuals, [](const Eigen::VectorXd& one) { return one.allFinite(); }))
    return std::nullopt;
  return out;
}

std::optional<ResidualBlocks::RunValues> ResidualBlocks::evaluate_bench(const Model& model,
                                                                        const replay::PreparedRun& prepared) const {
  auto predicted = replay::predict_bench(model, prepared, request_.hypothesis->declared());
  if (!predicted) return std::nullopt;
  return RunValues{.residuals = {scaled(prepared, prepared.sample_ranges().front(), *predicted)},
                   .predictions = std::move(*predicted)};
}

// All windows of a run that starts at rest, in one block.
std::optional<ResidualBlocks::RunValues> ResidualBlocks::evaluate_run_from_rest(
    const Model& model, const replay::PreparedRun& prepared) const {
  Eigen::VectorXd residuals(prepared.values());
  RunValues out{.predictions = Eigen::VectorXd(prepared.values())};
  Eigen::Index at = 0;
  for (const replay::Window& window : prepared.windows) {
    const auto start = simulation::equilibrium_at_first_input(model, window.input);
    if (!start) return std::nullopt;
    const auto predicted = replay::predict_window(model, prepared, window, *start);
    if (!predicted) return std::nullopt;
    const Eigen::Index n = predicted->values.size();
    residuals.segment(at, n) = scaled(prepared, window.range, predicted->values);
    out.predictions.segment(at, n) = predicted->values;
    at += n;
  }
  out.residuals.push_back(std::move(residuals));
  return out;
}

// Window after window: the internal states of effects (heat, creep) continue from one to the next, angles and rates
// have an initial state of their own in each.
std::optional<ResidualBlocks::RunValues> ResidualBlocks::evaluate_windows(const Model& model, std::size_t r) const {
  const replay::PreparedRun& prepared = request_.runs[r];
  RunValues out;
  out.predictions.resize(prepared.values());
  InternalStates internal;
  for (std::size_t b = first_block_[r]; b < last_block_[r]; ++b) {
    const ResidualBlock& block = blocks_[b];
    out.internal.push_back(internal);
    const auto predicted =
        replay::predict_window(model, prepared, prepared.windows[block.window], unpack(block.initial_state, internal));
    if (!predicted) return std::nullopt;
    internal = predicted->states.back().internal;
    out.residuals.push_back(with_prior(block, prepared, predicted->values, block.initial_state));
    out.predictions.segment(block.first, predicted->values.size()) = predicted->values;
  }
  return out;
}

// Nothing if one of the models cannot be built.
std::optional<std::vector<ResidualBlocks::Displaced>> ResidualBlocks::displaced_models(
    const Eigen::VectorXd& parameters) const {
  std::vector<Displaced> out;
  for (Eigen::Index i = 0; i < parameters.size(); ++i) {
    if (request_.held_parameter == i) continue;
    Eigen::VectorXd at = parameters;
    const double step = difference_step(parameters, i);
    at[i] += step;
    std::optional<Model> model = model_at(at);
    if (!model) return std::nullopt;
    out.push_back({.parameter = i, .step = step, .model = std::move(*model)});
  }
  return out;
}

// Whether all of them could be simulated.
bool ResidualBlocks::add_jacobian(const std::vector<Displaced>& displaced, ResidualValues& values) const {
  const std::size_t runs = request_.runs.size();
  std::vector<char> simulated(displaced.size() * runs, 0);
  tbb::parallel_for(std::size_t{0}, simulated.size(), [&](std::size_t task) {
    const Displaced& to = displaced[task / runs];
    const std::size_t r = task % runs;
    const auto there = evaluate_run(to.model, r);
    if (!there) return;
    for (std::size_t b = 0; b < there->residuals.size(); ++b) {
      ResidualValues::Block& block = values.blocks[first_block_[r] + b];
      block.jacobian.col(to.parameter) = (there->residuals[b] - block.residuals) / to.step;
    }
    simulated[task] = 1;
  });
  return std::ranges::count(simulated, 0) == 0;
}

double ResidualBlocks::difference_step(const Eigen::VectorXd& parameters, Eigen::Index i) const {
  const FitParameter& parameter = request_.hypothesis->parameters()[static_cast<std::size_t>(i)];
  const double step = parameter_step * std::max(parameter.scale, std::abs(parameters[i]));
  return parameters[i] + step <= parameter.upper ? step : -step;
}

// Whether all windows could be simulated.
bool ResidualBlocks::add_initial_state_jacobian(const Model& model, const std::vector<InternalStates>& internal,
                                                ResidualValues& values) const {
  std::vector<char> simulated(blocks_.size(), 1);
  tbb::parallel_for(std::size_t{0}, blocks_.size(), [&](std::size_t b) {
    const ResidualBlock& block = blocks_[b];
    ResidualValues::Block& out = values.blocks[b];
    out.initial_state_jacobian.resize(block.rows, static_cast<Eigen::Index>(block.initial_state.size()));
    if (block.whole_run) return;
    const replay::PreparedRun& prepared = request_.runs[block.run];
    for (std::size_t i = 0; i < block.initial_state.size(); ++i) {
      std::vector<double> displaced(block.initial_state.begin(), block.initial_state.end());
      const double step = initial_state_step * std::max(1.0, std::abs(displaced[i]));
      displaced[i] += step;
      const auto predicted =
          replay::predict_window(model, prepared, prepared.windows[block.window], unpack(displaced, internal[b]));
      if (!predicted) {
        simulated[b] = 0;
        return;
      }
      out.initial_state_jacobian.col(static_cast<Eigen::Index>(i)) =
          (with_prior(block, prepared, predicted->values, displaced) - out.residuals) / step;
    }
  });
  return std::ranges::count(simulated, 0) == 0;
}

}  // namespace coilwright::measurement::fit
