#pragma once

#include <Eigen/Core>

#include "coilwright/measurement/planning/experiment.hpp"
#include "coilwright/measurement/planning/synthetic_data.hpp"
#include "coilwright/measurement/replay/declared_model.hpp"

namespace coilwright::measurement::planning {

/// The SI unit of what drives a run, as a reader sees it.
[[nodiscard]] const char* unit_of_drive(data::Drive drive);

/// Throws std::invalid_argument, naming the run, the number and the cure, where a run is to be simulated at more times
/// than simulation::most_samples, or where all runs together have more samples.
void require_few_samples(const Experiment& experiment);

/// The planned run with its times and inputs, and with values that are still zero. Throws std::invalid_argument where
/// it drives a coil or a joint that the model does not have.
[[nodiscard]] data::Run with_inputs(const PlannedRun& planned, const actuator::Model& model);

/// What perfect instruments show of a run from with_inputs(), whose clock is this one: channel after channel, SI.
/// `model` is on the changed rig already. Throws std::invalid_argument naming the run if it does not fit the model,
/// std::runtime_error naming it if its motion cannot be simulated.
[[nodiscard]] Eigen::VectorXd true_values(const PlannedRun& planned, const data::Run& recorded, const TrueClock& clock,
                                          const replay::DeclaredModel& rig, const actuator::Model& model);

}  // namespace coilwright::measurement::planning
