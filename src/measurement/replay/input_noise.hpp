#pragma once

#include <optional>
#include <vector>

#include "coilwright/measurement/data/run.hpp"

namespace coilwright::measurement::replay {

/// The rows of a run's input without the noise of the instrument that recorded them.
struct CleanInput {
  std::vector<std::vector<double>> rows{};  ///< as Run::inputs
  double sigma{};                           ///< standard deviation of the noise that was taken out, in their unit
};

/// A recorded input has noise where hardly two neighbours are alike and what is left of smooth curves is more than
/// 0.3 % of its range. Between its edges (steps of more than eight standard deviations between two samples, to a level
/// that stays) it is then smoothed by Whittaker's smoother of least expected error. Nothing for an input without noise:
/// a command, which is exact.
[[nodiscard]] std::optional<CleanInput> without_noise(const data::Run& run);

}  // namespace coilwright::measurement::replay
