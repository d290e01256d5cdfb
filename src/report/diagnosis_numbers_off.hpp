#pragma once

#include <string>
#include <vector>

#include "coilwright/measurement/diagnosis.hpp"

namespace coilwright::report {

/// The verdict in a sentence, where one declared number is off by itself (Diagnosis::numbers_off is not empty).
[[nodiscard]] std::string numbers_off_sentence(const measurement::Diagnosis& diagnosis);

/// Lines that say of each number that may be the one where the data put it, and what that gains; empty where none is.
[[nodiscard]] std::string numbers_off_text(const measurement::Diagnosis& diagnosis);

/// What to weigh or measure of a number: "/links/1/mass_kg (declared 0.0225, these data say 0.0201)".
[[nodiscard]] std::vector<std::string> numbers_off_to_measure(const measurement::Diagnosis& diagnosis);

/// What to measure where the coefficients of the torque's shape have moved: they mean nothing by themselves.
[[nodiscard]] std::string shape_to_measure();

}  // namespace coilwright::report
