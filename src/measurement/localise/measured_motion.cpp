#include "measurement/localise/measured_motion.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <stdexcept>

namespace coilwright::measurement::localise {

void validate_motions(std::span<const MeasuredMotion> motions, const actuator::Model& model) {
  const auto joints = static_cast<std::size_t>(model.joints());
  for (const MeasuredMotion& motion : motions) {
    const auto require = [&](bool met, const char* rule, std::size_t got) {
      if (!met) throw std::invalid_argument(fmt::format("{}: {}; got {}", motion.run, rule, got));
    };
    try {
      motion.input.require_fits(model);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(fmt::format("{}: {}", motion.run, error.what()));
    }
    const std::size_t n = motion.input.times.size();
    require(motion.simulated.size() == n, "one simulated state for each sample", motion.simulated.size());
    for (const simulation::State& state : motion.simulated) {
      require(state.angles.size() == model.joints() && state.rates.size() == model.joints(),
              "a simulated state must have one angle and rate for each joint",
              static_cast<std::size_t>(state.angles.size()));
      require(state.internal.size() == model.internal_states(), "a simulated state must have the effects' own states",
              static_cast<std::size_t>(state.internal.size()));
    }
    require(motion.angles.size() == 1 || motion.angles.size() == joints,
            "measured angles must be of every joint, or their sum", motion.angles.size());
    require(motion.angles.size() == motions.front().angles.size(), "all motions must be measured alike",
            motion.angles.size());
    for (const std::vector<double>& series : motion.angles)
      require(series.size() == n, "one measured angle for each sample", series.size());
    require(motion.sigma.size() == motion.angles.size(), "one sigma for each measured series", motion.sigma.size());
    for (const double sigma : motion.sigma)
      if (!(sigma > 0.0)) throw std::invalid_argument(fmt::format("{}: sigma must be > 0; got {}", motion.run, sigma));
    require(!motion.starts.empty() && motion.starts.front() == 0, "the first window must start at sample 0",
            motion.starts.empty() ? 0 : motion.starts.front());
    for (std::size_t w = 1; w < motion.starts.size(); ++w)
      require(motion.starts[w] > motion.starts[w - 1] && motion.starts[w] < n,
              "starts of windows must rise and stay inside the run", motion.starts[w]);
  }
}

}  // namespace coilwright::measurement::localise
