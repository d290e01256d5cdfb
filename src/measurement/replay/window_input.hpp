#pragma once

#include <span>

#include "measurement/replay/input_noise.hpp"
#include "measurement/replay/prepared_run.hpp"

namespace coilwright::measurement::replay {

/// What drives the model in a window: the commanded rows in force from its first to its last sample, and a little
/// beyond where clocks may be apart, with rows so dense that the motion can be interpolated between them. Edges whose
/// place is unknown lie in the middle between their samples. A run that starts at rest is driven from its first input
/// on; where that comes more than a minute before the first sample, from that minute's last hold of `ringing_time` on,
/// or for a minute. Sets `input`, `edges`, `bend` and `errors` of the window. `clean` are the rows of the run's input,
/// of which noise may have been taken out.
void set_input(Window& window, const data::Run& run, const CleanInput& clean, const actuator::Model& nominal);

/// How the input of a window differs from what was planned for it.
struct InputChange {
  std::span<const double> edges{};   ///< where they lie: numbers of InputEdge::shift()
  double bend{};                     ///< how much of its bend it has
  std::span<const double> errors{};  ///< of its errors, each over one standard deviation
};
[[nodiscard]] simulation::ModelInput as_driven(const Window& window, const InputChange& change);

/// The rows of the input in force at each sample of the window, at the samples' times.
[[nodiscard]] simulation::ModelInput at_samples(const Window& window, const data::Run& run);

}  // namespace coilwright::measurement::replay
