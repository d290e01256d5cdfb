#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "measurement/identification/fitted_hypothesis.hpp"

namespace coilwright::measurement::identification {

/// Some windows of long records: what a search compares on where its model is far from the noise, since what explains
/// most of a large residual is ranked by some windows as well as by all. Its best hypotheses are then fitted to all
/// windows, and judged on them.
class WindowSubsample {
 public:
  /// Of each run as many windows as keep about SearchEffort::thinned_samples samples of all runs together, at least
  /// SearchEffort::fewest_windows of a run, one at an uneven place in each block of equal length, so that a period of
  /// the motion does not fall in step with them. Refers to `all`. Null where no run would lose any.
  [[nodiscard]] static std::unique_ptr<WindowSubsample> of(std::span<replay::PreparedRun> all);

  /// The runs with these windows.
  [[nodiscard]] std::span<replay::PreparedRun> runs() { return some_; }
  /// "21 of 60 windows".
  [[nodiscard]] std::string text() const;
  /// Tells the runs with all windows which samples were set aside in these, and their noise.
  void hand_on_outliers() const;

  /// Hypotheses that were fitted to these windows, fitted to all of them from there. Those that cannot be simulated on
  /// all windows are left out.
  [[nodiscard]] std::vector<FittedHypothesis> on_all(std::span<const FittedHypothesis> best) const;

 private:
  WindowSubsample(std::span<replay::PreparedRun> all, std::vector<replay::PreparedRun> some)
      : all_(all), some_(std::move(some)) {}

  std::span<replay::PreparedRun> all_;
  std::vector<replay::PreparedRun> some_;
};

}  // namespace coilwright::measurement::identification
