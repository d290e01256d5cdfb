#include "measurement/fit/residual_blocks.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "coilwright/simulation/initial_state.hpp"
#include "measurement/replay/prediction.hpp"

namespace coilwright::measurement::fit {
namespace {

using actuator::InternalStates;
using actuator::Model;
using simulation::State;

std::atomic<long> run_count{0};

// Of the size of a usual change: truncation of a forward difference is a ten-thousandth, the integrator's error below.
constexpr double parameter_step = 1e-4;
// Slopes that neither drown in the integrator's error nor leave the straight part: about the noise.
constexpr double start_step = 1e-5;

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

Eigen::VectorXd scaled(const replay::Record& record, replay::SampleRange stretch, const Eigen::VectorXd& predicted) {
  return (replay::measured_values(*record.run, stretch.first, stretch.last) - predicted)
      .cwiseQuotient(replay::sigmas(record, stretch.samples()));
}

Eigen::VectorXd with_pull(const ResidualBlock& block, const replay::Record& record, const Eigen::VectorXd& predicted,
                          std::span<const double> start) {
  const replay::Window& window = record.windows[block.window];
  Eigen::VectorXd out(block.rows);
  out.head(predicted.size()) = scaled(record, {window.first, window.last}, predicted);
  for (std::size_t i = 0; i < start.size(); ++i)
    out[predicted.size() + static_cast<Eigen::Index>(i)] = (block.guess[i] - start[i]) / block.sigmas[i];
  return out;
}

}  // namespace

// Residuals of the blocks of one run.
struct ResidualBlocks::RunValues {
  std::vector<Eigen::VectorXd> residuals{};
  Eigen::VectorXd predictions{};
  std::vector<InternalStates> internal{};  // with which each block starts; empty where a block is a whole run
};

State start_of(const ResidualBlock& block) {
  return unpack(block.start, {});
}

ResidualBlocks::ResidualBlocks(const FitRequest& request) : request_(request) {
  for (std::size_t r = 0; r < request.records.size(); ++r) add_blocks(r);
  std::size_t size = 0;
  for (const ResidualBlock& block : blocks_) size += block.guess.size();
  starts_.reserve(size);
  // A solver eliminates the starts in the order of their addresses: one after the other, so that the sums are always
  // taken in the same order.
  for (ResidualBlock& block : blocks_) {
    const bool from_fit = request.starts_from != nullptr && !block.whole_run;
    const std::vector<double> first =
        from_fit ? pack(request.starts_from->runs[block.record].starts[block.window]) : block.guess;
    const std::size_t begin = starts_.size();
    starts_.insert(starts_.end(), first.begin(), first.end());
    block.start = std::span(starts_).subspan(begin);
  }
}

void ResidualBlocks::add_blocks(std::size_t r) {
  const replay::Record& record = request_.records[r];
  const auto channels = static_cast<Eigen::Index>(record.run->channels.size());
  first_block_.push_back(blocks_.size());
  Eigen::Index first = 0;
  if (!record.has_nuisances()) {
    for (const replay::SampleRange& stretch : record.stretches())
      first += static_cast<Eigen::Index>(stretch.samples()) * channels;
    blocks_.push_back({.record = r, .whole_run = true, .rows = first});
  } else {
    for (std::size_t w = 0; w < record.windows.size(); ++w) {
      const replay::Window& window = record.windows[w];
      ResidualBlock block{.record = r, .window = w, .first = first};
      block.guess = pack(window.guess);
      block.sigmas = pack(window.guess_sigma);
      const auto values = static_cast<Eigen::Index>(window.samples()) * channels;
      block.rows = values + static_cast<Eigen::Index>(block.guess.size());
      first += values;
      blocks_.push_back(std::move(block));
    }
  }
  last_block_.push_back(blocks_.size());
}

std::optional<ResidualValues> ResidualBlocks::evaluate(const Eigen::VectorXd& parameters, Slopes slopes) const {
  const std::optional<Model> model = model_at(parameters);
  if (!model) return std::nullopt;
  const std::size_t runs = request_.records.size();
  std::vector<std::optional<RunValues>> found(runs);
  tbb::parallel_for(std::size_t{0}, runs, [&](std::size_t r) { found[r] = evaluate_run(*model, r); });
  ResidualValues out;
  std::vector<InternalStates> internal;
  for (std::optional<RunValues>& run : found) {
    if (!run) return std::nullopt;
    for (Eigen::VectorXd& residuals : run->residuals) out.blocks.push_back({.residuals = std::move(residuals)});
    out.predictions.push_back(std::move(run->predictions));
    run->internal.resize(run->residuals.size());
    internal.insert(internal.end(), run->internal.begin(), run->internal.end());
  }
  if (slopes == Slopes::none) return out;
  for (std::size_t b = 0; b < blocks_.size(); ++b) out.blocks[b].slopes.setZero(blocks_[b].rows, parameters.size());
  if (slopes == Slopes::all && !add_slopes(parameters, out)) return std::nullopt;
  if (!add_start_slopes(*model, internal, out)) return std::nullopt;
  return out;
}

std::optional<Model> ResidualBlocks::model_at(const Eigen::VectorXd& parameters) const {
  try {
    return request_.hypothesis->model_at(parameters);
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

std::optional<ResidualBlocks::RunValues> ResidualBlocks::evaluate_run(const Model& model, std::size_t r) const {
  ++run_count;
  const replay::Record& record = request_.records[r];
  std::optional<RunValues> out;
  if (!record.is_motion())
    out = evaluate_bench(model, record);
  else
    out = record.has_nuisances() ? evaluate_windows(model, r) : evaluate_rest_run(model, record);
  if (out && !std::ranges::all_of(out->residuals, [](const Eigen::VectorXd& one) { return one.allFinite(); }))
    return std::nullopt;
  return out;
}

std::optional<ResidualBlocks::RunValues> ResidualBlocks::evaluate_bench(const Model& model,
                                                                        const replay::Record& record) const {
  auto predicted = replay::predict_bench(model, record, request_.hypothesis->declared());
  if (!predicted) return std::nullopt;
  return RunValues{.residuals = {scaled(record, record.stretches().front(), *predicted)},
                   .predictions = std::move(*predicted)};
}

// Every window of a run that starts at rest.
std::optional<ResidualBlocks::RunValues> ResidualBlocks::evaluate_rest_run(const Model& model,
                                                                           const replay::Record& record) const {
  Eigen::Index size = 0;
  for (const replay::Window& window : record.windows)
    size += static_cast<Eigen::Index>(window.samples() * record.run->channels.size());
  Eigen::VectorXd residuals(size);
  RunValues out{.predictions = Eigen::VectorXd(size)};
  Eigen::Index at = 0;
  for (const replay::Window& window : record.windows) {
    const auto start = simulation::equilibrium_at_first_input(model, window.input);
    if (!start) return std::nullopt;
    const auto predicted = replay::predict_window(model, record, window, *start);
    if (!predicted) return std::nullopt;
    const Eigen::Index n = predicted->values.size();
    residuals.segment(at, n) = scaled(record, {window.first, window.last}, predicted->values);
    out.predictions.segment(at, n) = predicted->values;
    at += n;
  }
  out.residuals.push_back(std::move(residuals));
  return out;
}

// Window after window: the effects' own states (heat, creep) go on from one to the next, angles and rates start anew.
std::optional<ResidualBlocks::RunValues> ResidualBlocks::evaluate_windows(const Model& model, std::size_t r) const {
  const replay::Record& record = request_.records[r];
  RunValues out;
  Eigen::Index size = 0;
  for (const replay::Window& window : record.windows)
    size += static_cast<Eigen::Index>(window.samples() * record.run->channels.size());
  out.predictions.resize(size);
  InternalStates internal;
  for (std::size_t b = first_block_[r]; b < last_block_[r]; ++b) {
    const ResidualBlock& block = blocks_[b];
    out.internal.push_back(internal);
    const auto predicted =
        replay::predict_window(model, record, record.windows[block.window], unpack(block.start, internal));
    if (!predicted) return std::nullopt;
    internal = predicted->states.back().internal;
    out.residuals.push_back(with_pull(block, record, predicted->values, block.start));
    out.predictions.segment(block.first, predicted->values.size()) = predicted->values;
  }
  return out;
}

bool ResidualBlocks::add_slopes(const Eigen::VectorXd& parameters, ResidualValues& values) const {
  struct Moved {
    Eigen::Index parameter{};
    double step{};
    Model model;
  };
  std::vector<Moved> moved;
  for (Eigen::Index i = 0; i < parameters.size(); ++i) {
    if (request_.held == i) continue;
    Eigen::VectorXd at = parameters;
    const double step = slope_step(parameters, i);
    at[i] += step;
    std::optional<Model> model = model_at(at);
    if (!model) return false;
    moved.push_back({.parameter = i, .step = step, .model = std::move(*model)});
  }
  const std::size_t runs = request_.records.size();
  std::vector<char> good(moved.size() * runs, 0);
  tbb::parallel_for(std::size_t{0}, good.size(), [&](std::size_t task) {
    const Moved& to = moved[task / runs];
    const std::size_t r = task % runs;
    const auto there = evaluate_run(to.model, r);
    if (!there) return;
    for (std::size_t b = 0; b < there->residuals.size(); ++b) {
      ResidualValues::Block& block = values.blocks[first_block_[r] + b];
      block.slopes.col(to.parameter) = (there->residuals[b] - block.residuals) / to.step;
    }
    good[task] = 1;
  });
  return std::ranges::count(good, 0) == 0;
}

double ResidualBlocks::slope_step(const Eigen::VectorXd& parameters, Eigen::Index i) const {
  const FitParameter& parameter = request_.hypothesis->parameters()[static_cast<std::size_t>(i)];
  const double step = parameter_step * std::max(parameter.scale, std::abs(parameters[i]));
  return parameters[i] + step <= parameter.upper ? step : -step;
}

bool ResidualBlocks::add_start_slopes(const Model& model, const std::vector<InternalStates>& internal,
                                      ResidualValues& values) const {
  std::vector<char> good(blocks_.size(), 1);
  tbb::parallel_for(std::size_t{0}, blocks_.size(), [&](std::size_t b) {
    const ResidualBlock& block = blocks_[b];
    ResidualValues::Block& out = values.blocks[b];
    out.start_slopes.resize(block.rows, static_cast<Eigen::Index>(block.start.size()));
    if (block.whole_run) return;
    const replay::Record& record = request_.records[block.record];
    for (std::size_t i = 0; i < block.start.size(); ++i) {
      std::vector<double> start(block.start.begin(), block.start.end());
      const double step = start_step * std::max(1.0, std::abs(start[i]));
      start[i] += step;
      const auto predicted =
          replay::predict_window(model, record, record.windows[block.window], unpack(start, internal[b]));
      if (!predicted) {
        good[b] = 0;
        return;
      }
      out.start_slopes.col(static_cast<Eigen::Index>(i)) =
          (with_pull(block, record, predicted->values, start) - out.residuals) / step;
    }
  });
  return std::ranges::count(good, 0) == 0;
}

long simulated_runs() {
  return run_count.load();
}

}  // namespace coilwright::measurement::fit
