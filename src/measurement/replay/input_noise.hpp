#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "coilwright/measurement/data/run.hpp"

namespace coilwright::measurement::replay {

/// What noise may still have done to one column of the input between two edges: so much, times a number of the standard
/// normal distribution.
struct InputError {
  std::size_t column{};
  std::size_t first{};          ///< row from which it acts
  std::vector<double> shape{};  ///< its standard deviation in that row and those after it, in their unit
};

/// The rows of a run's input without the noise of the instrument that recorded them.
struct CleanInput {
  std::vector<std::vector<double>> rows{};  ///< as Run::inputs
  double sigma{};                           ///< standard deviation of the noise that was taken out, in their unit
  std::vector<InputError> errors{};         ///< independent of one another
  bool as_steps = false;                    ///< whether fine steps stay steps, however smooth they are
};

/// A recorded input has noise where hardly two neighbours are alike and what is left of smooth curves is more than
/// 0.3 % of its range. Between its edges (steps of more than eight standard deviations between two samples, to a level
/// that stays, and of four times its median step where it moves all the time) it is then the simplest command that
/// explains it (command_shape.hpp), whose few numbers keep an error each; what no such command explains is smoothed by
/// Whittaker's smoother of least expected error, and what that leaves is not among the errors. Nothing for an input
/// without noise: a command, which is exact.
[[nodiscard]] std::optional<CleanInput> without_noise(const data::Run& run);

}  // namespace coilwright::measurement::replay
