#pragma once

#include <string>
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

/// Asks the header for the one input it must have, and finishes it: whatever else may stand in the file must have been
/// asked for before. Throws InputError.
[[nodiscard]] InputColumns ask_for_input(text::CsvHeader& header);

}  // namespace coilwright::formats
