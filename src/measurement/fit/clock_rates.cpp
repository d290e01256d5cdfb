
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "measurement/fit/parallel.hpp"
#include "measurement/fit/residual_blocks.hpp"
#include "measurement/fit/residual_place.hpp"

// The rates of clocks from which a fit of ResidualBlocks begins.

namespace coilwright::measurement::fit {
namespace {

// A finger of 8 Hz swings by a sixth of its period in this time, s. Clocks that may be farther apart at the end of a
// window let a fit begin on another swing, from where no derivative leads back.
constexpr double near = 0.02;
constexpr double apart = 0.004;          // between the places at which the end of a window is looked at, s
constexpr double most_deviations = 3.0;  // of the rate
constexpr int most_places = 250;         // on either side, which is a second
// Residuals beyond so many deviations count by their logarithm: misread pictures, and what the model does not say yet.
constexpr double robust = 3.0;

double duration_of(const replay::PreparedRun& prepared, const replay::Window& window) {
  return prepared.run->times[window.range.last - 1] - prepared.run->times[window.range.first];
}

double robust_cost(const Eigen::VectorXd& residuals, double deviations) {
  double out = deviations * deviations;
  for (const double each : residuals) out += robust * robust * std::log1p(each * each / (robust * robust));
  return out;
}

}  // namespace

void ResidualBlocks::start_clock_rates(const Eigen::VectorXd& parameters) {
  std::vector<std::size_t> far;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const replay::PreparedRun& prepared = request_.runs[blocks_[b].run];
    if (!blocks_[b].numbers.clock_rate_number()) continue;
    if (prepared.run->clock.rate_sigma * duration_of(prepared, prepared.windows[blocks_[b].window]) > near)
      far.push_back(b);
  }
  if (far.empty()) return;
  if (!is_here(parameters)) move_to(parameters);
  if (!here_) return;
  in_parallel(far.size(), [&](std::size_t k) {
    const ResidualBlock& block = blocks_[far[k]];
    const replay::PreparedRun& prepared = request_.runs[block.run];
    const replay::Window& window = prepared.windows[block.window];
    const replay::Trajectory& motion = here_->runs[block.run].trajectories[far[k] - first_block_[block.run]];
    const actuator::Model& model = here_->models.on(rig_of_run_[block.run]);
    const Eigen::VectorXd measured = replay::measured_values(*prepared.run, window.range);
    const std::size_t number = *block.numbers.clock_rate_number();
    const double sigma = block.numbers.sigma()[number];
    std::vector<double> local(block.local.begin(), block.local.end());
    const auto cost_at = [&](double rate) {
      local[number] = rate;
      const Eigen::VectorXd shown =
          replay::observed_values(model, prepared, window, motion, {.numbers = &block.numbers, .values = local});
      return robust_cost(replay::over_noise(prepared, window.range, measured - shown), rate / sigma);
    };
    const double step = apart / duration_of(prepared, window);
    double best = block.local[number];
    double least = cost_at(best);
    const auto steps = static_cast<int>(std::min<double>(most_places, most_deviations * sigma / step));
    for (int i = -steps; i <= steps; ++i) {
      const double cost = cost_at(i * step);
      if (!(cost < least)) continue;
      least = cost;
      best = i * step;
    }
    block.local[number] = best;
  });
}

}  // namespace coilwright::measurement::fit
