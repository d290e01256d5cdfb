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

}  // namespace coilwright::formats
