#pragma once

#include <vector>

#include "coilwright/actuator/model/model_spec.hpp"
#include "coilwright/measurement/diagnosis.hpp"

namespace coilwright::measurement {

/// The effects that a diagnosis added, each with its fitted numbers.
[[nodiscard]] std::vector<actuator::Effect> effects_of(const Diagnosis& diagnosis);

/// The fitted calibration and the declared numbers as the data moved them, SI, as DeclaredModel::build takes them.
[[nodiscard]] std::vector<double> calibration_of(const Diagnosis& diagnosis);

/// The declared model after its diagnosis: with the fitted calibration and with the effects that were added. An added
/// effect takes the place of a declared one of its kind. `declared` is the model that was diagnosed.
[[nodiscard]] actuator::ModelSpec corrected_model(const replay::DeclaredModel& declared, const Diagnosis& diagnosis);

}  // namespace coilwright::measurement
