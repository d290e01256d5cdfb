#include "measurement/fit/residual_blocks.hpp"

#include <algorithm>
#include <utility>

#include "measurement/fit/fit.hpp"
#include "measurement/fit/parallel.hpp"
#include "measurement/fit/residual_place.hpp"
#include "measurement/replay/if_possible.hpp"

namespace coilwright::measurement::fit {

using actuator::InternalStates;
using actuator::Model;

Eigen::VectorXd residuals_with_prior(const ResidualBlock& block, const replay::PreparedRun& prepared,
                                     replay::SampleRange range, const Eigen::VectorXd& predicted,
                                     std::span<const double> local) {
  Eigen::VectorXd out(block.rows);
  out.head(predicted.size()) =
      replay::over_noise(prepared, range, replay::measured_values(*prepared.run, range) - predicted);
  for (std::size_t i = 0; i < local.size(); ++i)
    out[predicted.size() + static_cast<Eigen::Index>(i)] =
        prepared.model_error * (block.numbers.mean()[i] - local[i]) / block.numbers.sigma()[i];
  return out;
}

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
    // A fit with another model error may have had more of them, or fewer.
    const bool from_fit =
        request.local_numbers_from != nullptr && block.numbers.size() > 0 &&
        request.local_numbers_from->runs[block.run].local_numbers[block.window].size() == block.numbers.size();
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

// Simulates all runs. here_ is null if one of them cannot be.
void ResidualBlocks::move_to(const Eigen::VectorXd& parameters) {
  here_ = nullptr;
  std::optional<Models> models = models_at(parameters);
  if (!models) return;
  const std::size_t runs = request_.runs.size();
  std::vector<std::optional<RunValues>> evaluated(runs);
  in_parallel(runs, [&](std::size_t r) { evaluated[r] = evaluate_run(*models, r); });
  if (std::ranges::all_of(evaluated, [](const auto& run) { return run.has_value(); })) {
    here_ = std::make_unique<Place>(
        Place{.parameters = parameters, .local_numbers = local_numbers_, .models = std::move(*models)});
    for (std::optional<RunValues>& run : evaluated) here_->runs.push_back(std::move(*run));
  }
  for (const replay::PreparedRun& prepared : request_.runs) prepared.count_simulations(1);
}

std::optional<ResidualValues> ResidualBlocks::evaluate(const Eigen::VectorXd& parameters, Derivatives derivatives) {
  if (!is_here(parameters)) move_to(parameters);
  if (!here_) return std::nullopt;
  ResidualValues out;
  for (const RunValues& run : here_->runs) {
    for (const Eigen::VectorXd& residuals : run.residuals) out.blocks.push_back({.residuals = residuals});
    out.predictions.push_back(run.predictions);
  }
  if (derivatives == Derivatives::none) return out;
  for (std::size_t b = 0; b < blocks_.size(); ++b) out.blocks[b].jacobian.setZero(blocks_[b].rows, parameters.size());
  if (derivatives == Derivatives::all) {
    const std::vector<Displaced> displaced = displaced_models(parameters);
    for (const replay::PreparedRun& prepared : request_.runs) prepared.count_simulations(displaced.size());
    add_jacobian(parameters, displaced, out);
    add_known_columns(out);
  }
  add_local_jacobian(here_->models, here_->runs, out);
  return out;
}

std::optional<ResidualBlocks::Models> ResidualBlocks::models_at(const Eigen::VectorXd& parameters) const {
  return replay::if_possible<Models>([&] { return Models(request_.hypothesis->spec_at(parameters), rigs_); });
}

std::optional<ResidualBlocks::RunValues> ResidualBlocks::evaluate_run(const Models& models, std::size_t r,
                                                                      const RunValues* nearby) const {
  const Model& model = models.on(rig_of_run_[r]);
  auto out = replay::if_possible<RunValues>(
      [&] { return request_.runs[r].is_motion() ? evaluate_windows(model, r, nearby) : evaluate_bench(model, r); });
  if (out && !std::ranges::all_of(out->residuals, [](const Eigen::VectorXd& one) { return one.allFinite(); }))
    return std::nullopt;
  return out;
}

std::optional<ResidualBlocks::RunValues> ResidualBlocks::evaluate_bench(const Model& model, std::size_t r) const {
  const replay::PreparedRun& prepared = request_.runs[r];
  auto predicted = replay::predict_bench(model, prepared, request_.hypothesis->declared());
  if (!predicted) return std::nullopt;
  return RunValues{.residuals = {residuals_with_prior(blocks_[first_block_[r]], prepared,
                                                      prepared.sample_ranges().front(), *predicted, {})},
                   .predictions = std::move(*predicted)};
}

// Window after window: the internal states of effects (heat, creep) continue from one to the next; angles and rates
// have an initial state of their own in each.
std::optional<ResidualBlocks::RunValues> ResidualBlocks::evaluate_windows(const Model& model, std::size_t r,
                                                                          const RunValues* nearby) const {
  const replay::PreparedRun& prepared = request_.runs[r];
  RunValues out{.predictions = Eigen::VectorXd(prepared.values())};
  InternalStates internal;
  for (std::size_t b = first_block_[r]; b < last_block_[r]; ++b) {
    const ResidualBlock& block = blocks_[b];
    const replay::Window& window = prepared.windows[block.window];
    out.internal.push_back(internal);
    auto motion = replay::simulate_window(model, window, block.local_values(), internal,
                                          nearby != nullptr ? &nearby->trajectories[b - first_block_[r]] : nullptr);
    if (!motion) return std::nullopt;
    const Eigen::VectorXd predicted = replay::observed_values(model, prepared, window, *motion, block.local_values());
    internal = motion->at(prepared.run->times[window.range.last - 1]).internal;
    out.residuals.push_back(residuals_with_prior(block, prepared, window.range, predicted, block.local));
    out.predictions.segment(block.first, predicted.size()) = predicted;
    out.trajectories.push_back(std::move(*motion));
  }
  return out;
}

}  // namespace coilwright::measurement::fit
