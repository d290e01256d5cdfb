#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "coilwright/formats/data/run_file.hpp"
#include "coilwright/text/csv/csv_table.hpp"
#include "formats/simulation/input_columns.hpp"

namespace coilwright::formats {

/// A measured column of a run.
struct Measured {
  std::string quantity;  ///< for CsvTable::column()
  measurement::data::ChannelKind kind{};
  int joint{};
};

/// What the file of a run has, as its header tells.
struct RunColumns {
  std::optional<InputColumns> input{};
  std::vector<Measured> measured{};  ///< those whose unit sigma has first
  bool times{};
  bool angles{};
  bool openings{};
  bool heights{};
  std::vector<std::string> names{};  ///< all that are looked at
};

/// Asks the header of a run's file for its columns. Throws InputError, with the layout that would fit where there is
/// one.
[[nodiscard]] RunColumns ask_for_run(text::CsvHeader& header, const RunEntry& entry);

/// The same of a file that has the input of a run alone; `measured` is what the run's own file has. `used` is what of
/// the layout that file has a use for.
[[nodiscard]] InputColumns ask_for_run_input(text::CsvHeader& header, const RunEntry& entry, const RunColumns& measured,
                                             const std::set<std::string>& used);

/// What of a layout the file of a header has a use for: sources, and "sampling_rate_Hz".
[[nodiscard]] std::set<std::string> used_of(const text::CsvLayout& layout, const text::CsvHeader& header);

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

/// Why a run cannot be used though its file is well formed: an angle that no finger reaches, a reading that wraps at a
/// half or a whole turn.
[[nodiscard]] std::optional<Objection> objection_to(const measurement::data::Run& run, const text::CsvTable& table,
                                                    const RunColumns& columns, const text::CsvLayout& layout);

}  // namespace coilwright::formats
