#pragma once

#include "measurement/replay/prepared_run.hpp"

namespace coilwright::measurement::replay {

/// What drives the model in a window: the commanded rows in force from its first to its last sample, and a little
/// beyond where clocks may be apart, with rows so dense that the motion can be interpolated between them. Edges whose
/// place is unknown lie in the middle between their samples. Sets `input`, `edges` and `bend` of the window.
/// `rows` are those of the run's input, of which noise may have been taken out.
void set_input(Window& window, const data::Run& run, const std::vector<std::vector<double>>& rows,
               const actuator::Model& nominal);

/// The input with its edges moved, s, and with so much of its bend. A shift beyond the two samples of its edge ends
/// there.
[[nodiscard]] simulation::ModelInput as_driven(const Window& window, std::span<const double> shifts, double bend);

/// The rows of the input in force at each sample of the window, at the samples' times.
[[nodiscard]] simulation::ModelInput at_samples(const Window& window, const data::Run& run);

}  // namespace coilwright::measurement::replay
