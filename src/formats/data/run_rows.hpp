#pragma once

#include <optional>

#include "coilwright/text/csv/csv_table.hpp"
#include "formats/data/run_columns.hpp"

namespace coilwright::formats {

/// A run without the rows that lack something, and what to say about that.
struct RunOfRows {
  measurement::data::Run run{};
  std::optional<measurement::data::Warning> warning{};
};

/// Takes the values that are not there out of a run that has an entry for each row of its table. Where rows lack the
/// input or all measured values, both get times of their own, on one clock: a measured value before the first input,
/// or later after the last than the longest interval of the input, is left out. Throws InputError for a row that has
/// some of the measured values or inputs and not all, and where nothing is left.
[[nodiscard]] RunOfRows with_values_that_are_there(measurement::data::Run run, const text::CsvTable& table,
                                                   const RunColumns& columns);

/// An objection, and the column of a layout that answers it.
struct Objection {
  text::InputError error;
  std::optional<text::CsvColumn> wrapped{};
};

/// Why a run cannot be used though its file is well formed: an angle that no finger reaches, a reading that wraps at a
/// half or a whole turn.
[[nodiscard]] std::optional<Objection> objection_to(const measurement::data::Run& run, const text::CsvTable& table,
                                                    const RunColumns& columns, const text::CsvLayout& layout);

}  // namespace coilwright::formats
