#pragma once

#include <span>
#include <string>
#include <vector>

#include "coilwright/formats/data/diagnosis_json.hpp"
#include "coilwright/measurement/diagnosis.hpp"

namespace coilwright::report {

/// Whether something is left over that is no noise: partly_explained and unexplained.
[[nodiscard]] bool leaves_structure(const measurement::Diagnosis& diagnosis);

/// The runs that warnings are of.
[[nodiscard]] std::vector<std::string> names_of_runs(std::span<const measurement::data::Warning> warnings);

/// Whether the rms of errors is larger by more than a tenth of the noise.
[[nodiscard]] bool has_risen(const measurement::Errors& from, const measurement::Errors& to, double noise);

/// Where the error on the runs that no fit has seen is larger than before effects were added, or before anything was
/// fitted: one sentence a quantity.
[[nodiscard]] std::vector<std::string> risen_errors(const measurement::Diagnosis& diagnosis);

/// Where what is left over on the fit runs is noise, and the error on the runs that no fit has seen is more than a
/// tenth above it all the same: one sentence a quantity. Empty where risen_errors() says more.
[[nodiscard]] std::vector<std::string> errors_beyond_noise(const measurement::Diagnosis& diagnosis);

/// One sentence naming the declared numbers that moved by more than three tolerances although what is left over is
/// noise; empty where none did, or where the verdict says it.
[[nodiscard]] std::string far_numbers(const measurement::Diagnosis& diagnosis);

/// One sentence with the words of the other commands where they refuse the updated actuator as input; empty where they
/// take it.
[[nodiscard]] std::string refusal(const formats::DiagnosisReport& report);

/// Whether what is left over may be noise of the camera: no record shows the colour of the noise of any channel without
/// the motion, and there is not more of it than colour makes.
[[nodiscard]] bool may_be_the_camera(const measurement::Diagnosis& diagnosis);

/// What a person would do next, the most useful first: which number to weigh or measure, which run to record, or
/// whether to go on with the updated actuator.
[[nodiscard]] std::vector<std::string> next_steps(const formats::DiagnosisReport& report);

}  // namespace coilwright::report
