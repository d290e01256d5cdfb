#include "coilwright/formats/simulation/commanded_input_file.hpp"

#include <array>
#include <cstddef>
#include <string>

#include "coilwright/text/csv/csv_table.hpp"
#include "coilwright/units/unit.hpp"
#include "formats/simulation/input_columns.hpp"
#include "formats/simulation/plausible_ranges.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using simulation::CommandedInput;

// What a transient run may have been measured by; not an input.
constexpr std::array measured_columns = {"bending_angle_deg", "theta#_deg", "omega#_rad_s"};

InputColumns ask(CsvHeader& header) {
  header.require("time_s");
  for (const auto* name : measured_columns) header.ignore(name);
  return ask_for_input(header);
}

CommandedInput command_of(const CsvTable& table, const InputColumns& input) {
  table.require_increasing("time");
  require_few_samples(table);
  CommandedInput command{.drive = input.drive, .addressing = input.addressing};
  const auto times = table.column("time");
  command.times.assign(times.begin(), times.end());
  command.rows.resize(times.size());
  for (const std::string& quantity : input.quantities) {
    const auto values = table.column(quantity);
    for (std::size_t row = 0; row < values.size(); ++row) {
      if (!level_rule.allows(units::from_memory(values[row], table.name(quantity))))
        throw table.error(quantity, row, level_rule.text());
      command.rows[row].push_back(values[row]);
    }
  }
  return command;
}

}  // namespace

CommandedInput read_commanded_input(const std::filesystem::path& path) {
  InputColumns input;
  const CsvTable table = read_csv(path, [&](CsvHeader& header) { input = ask(header); });
  return command_of(table, input);
}

CommandedInput parse_commanded_input(std::string_view text, std::string_view file) {
  InputColumns input;
  const CsvTable table = parse_csv(text, std::string(file), [&](CsvHeader& header) { input = ask(header); });
  return command_of(table, input);
}

}  // namespace coilwright::formats
