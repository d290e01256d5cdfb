#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/simulation/commanded_input.hpp"
#include "coilwright/text/csv/csv_table.hpp"

namespace coilwright::formats {

/// Which columns of a transient run command something.
struct InputColumns {
  simulation::Drive drive{};
  simulation::Addressing addressing{};
  std::vector<std::string> quantities;  ///< for CsvTable::column(): "current", or "torque1", "torque2", ...
};

/// The inputs that a file may have, for errors.
inline constexpr std::string_view input_names = "current_A, current1_A.., voltage_V or torque1_Nm..";

/// Asks the header for an input; nothing where it has none. Throws InputError where it has several kinds.
[[nodiscard]] std::optional<InputColumns> find_input(text::CsvHeader& header);

/// Asks the header for the one input it must have, and finishes it: whatever else may stand in the file must have been
/// asked for before. `advice` is CsvHeader::finish()'s. Throws InputError.
[[nodiscard]] InputColumns ask_for_input(text::CsvHeader& header, std::string_view advice = {});

}  // namespace coilwright::formats
