#pragma once

#include <string>
#include <vector>

#include "coilwright/formats/data/diagnosis_formatting.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::report {

/// Four digits: what the intervals of a fit bear, and a line holds. "none" for what is not finite.
[[nodiscard]] std::string number_text(double value);

/// An SI value in a unit, with the unit: "0.3 deg".
[[nodiscard]] std::string in_unit_text(double value, const units::Unit& unit);

/// Cells of a table: key, value with the digits that its interval bears, interval.
[[nodiscard]] std::vector<std::string> estimate_row(const measurement::compare::Estimate& estimate);

/// Where a fit has moved a declared number to: "1.43"; "below -7.85" if it changes nothing there.
[[nodiscard]] std::string moved_to_text(const measurement::MovedNumber& number);

/// "1 run", "2 runs".
[[nodiscard]] std::string counted(std::size_t count, const char* one);

/// Rms residual on the fit runs over the noise, of a chi-square: 1 is noise alone; NaN where nothing was compared.
[[nodiscard]] double over_noise(const measurement::Diagnosis& diagnosis, double chi_square);

}  // namespace coilwright::report
