#pragma once

#include <cstddef>
#include <vector>

#include "coilwright/algebra/smooth_curve.hpp"
#include "measurement/replay/input_rows.hpp"

namespace coilwright::measurement::replay {

/// The smooth curve through the rows from `first` to `last`.
[[nodiscard]] algebra::SmoothCurve curve_through(const std::vector<double>& times, const std::vector<InputRow>& rows,
                                                 std::size_t first, std::size_t last);

/// Its row at a time, s.
[[nodiscard]] InputRow row_at(const algebra::SmoothCurve& curve, double time);

/// The largest difference between any two rows in a column.
[[nodiscard]] double range_of(const std::vector<InputRow>& rows);

/// Whether rows are those of a curve: five or more, whose fourth differences are small beside the second ones or, at
/// most 0.4 %, beside their range. They are (w h)^2 of the second ones for a sine, a quarter at 10 Hz and 8 ms, and 3.4
/// times as large in white noise, of which the ends of a curve would leave too much in speeds and places.
[[nodiscard]] bool is_of_a_curve(const std::vector<InputRow>& rows);

/// Rows at `times`, s, for which a smooth curve moves what is slow beside them as straight lines through `rows` do:
/// with the lines' impulse and its first moment. Of at least five rows.
[[nodiscard]] std::vector<InputRow> lines_as_curve(const std::vector<double>& times, const std::vector<InputRow>& rows);

/// The same for rows that are held from `times` on: rows in the `middles` of the time for which each is held. From the
/// first middle to the last one the curve has the steps' impulse and its first moment.
[[nodiscard]] std::vector<InputRow> steps_as_curve(const std::vector<double>& middles, const std::vector<double>& times,
                                                   const std::vector<InputRow>& rows);

}  // namespace coilwright::measurement::replay
