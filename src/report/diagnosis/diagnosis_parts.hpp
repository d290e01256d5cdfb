#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "coilwright/formats/data/diagnosis_formatting.hpp"
#include "coilwright/formats/data/diagnosis_json.hpp"
#include "coilwright/measurement/diagnosis.hpp"
#include "coilwright/report/simulation/document.hpp"
#include "coilwright/report/simulation/percent.hpp"
#include "coilwright/units/unit.hpp"

// What the text of a diagnosis is made of; each part has a file of its name.
namespace coilwright::report {

// diagnosis_numbers.cpp

/// Four digits: what the intervals of a fit bear, and a line holds. "none" for what is not finite.
[[nodiscard]] std::string number_text(double value);

/// An SI value in a unit, with the unit: "0.3 deg".
[[nodiscard]] std::string in_unit_text(double value, const units::Unit& unit);

/// Cells of a table: key, value with the digits that its interval bears, interval.
[[nodiscard]] std::vector<std::string> estimate_row(const measurement::identification::Estimate& estimate);

/// Where a fit has moved a declared number to: "1.43"; "below -7.85" if it changes nothing there.
[[nodiscard]] std::string moved_to_text(const measurement::MovedNumber& number);

/// "1 run", "2 runs".
[[nodiscard]] std::string counted(std::size_t count, const char* one);

/// Rms residual on the fit runs over the noise, of a chi-square: 1 is noise alone; NaN where nothing was compared.
[[nodiscard]] double over_noise(const measurement::Diagnosis& diagnosis, double chi_square);

// diagnosis_numbers_off.cpp

/// The verdict in a sentence, where one declared number is off by itself (Diagnosis::numbers_off is not empty).
[[nodiscard]] std::string numbers_off_sentence(const measurement::Diagnosis& diagnosis);

/// Lines that say of each number that may be the one where the data put it, and what that gains; empty where none is.
[[nodiscard]] std::string numbers_off_text(const measurement::Diagnosis& diagnosis);

/// What to weigh or measure of a number: "/links/1/mass_kg (declared 0.0225, these data say 0.0201)".
[[nodiscard]] std::vector<std::string> numbers_off_to_measure(const measurement::Diagnosis& diagnosis);

/// What to measure where the coefficients of the torque's shape have moved: they mean nothing by themselves.
[[nodiscard]] std::string shape_to_measure();

// diagnosis_advice.cpp

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

// diagnosis_assumptions.cpp

/// What a diagnosis took for granted: the runs, the numbers that were free, moved within tolerances or exact, the noise
/// and the samples that were left out.
[[nodiscard]] Section assumptions_section(const formats::DiagnosisReport& report);

// diagnosis_correction.cpp

/// What a nameless correction of the torque is, how far it is to be trusted and what it shows; or why there is none.
/// Without blocks where nothing was left over.
[[nodiscard]] Section correction_section(const formats::DiagnosisReport& report);

// diagnosis_rivals.cpp

/// How sure the answer is: what these data cannot tell from it, what they refute by little and how that shows itself
/// at the rig.
[[nodiscard]] std::string rivals_text(const measurement::Diagnosis& diagnosis);
/// Whether effects are probable that are not reported since they would not be seen (identification::answer_of()).
[[nodiscard]] bool has_unseen_effects(const measurement::Diagnosis& diagnosis);
/// Adds the table of what was compared; nothing where nothing was.
void add_compared(Section& section, const measurement::Diagnosis& diagnosis);

}  // namespace coilwright::report
