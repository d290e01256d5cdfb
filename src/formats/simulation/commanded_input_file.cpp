#include "coilwright/formats/simulation/commanded_input_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>

#include "coilwright/formats/simulation/motion_table.hpp"
#include "coilwright/text/csv/csv_table.hpp"
#include "coilwright/text/input_error.hpp"
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

// A recorded current a thousand times too large moves the model to no end; no coil carries it. Heat that stays in a
// coil's copper bounds what it survives for a second; where no copper is known, what any rig of this kind has does.
void require_bearable(const CommandedInput& command, const simulation::ModelInput& input,
                      const std::optional<actuator::CoilElectrics>& coil, const std::string& file) {
  constexpr double largest_current = 100.0;      // A
  constexpr double copper_heat = 385.0;          // J/(kg K), CRC Handbook, 25 degC; hotter it is more by up to a fifth
  constexpr double melting_above_room = 1065.0;  // K
  if (command.drive == simulation::Drive::torque) return;
  double largest = 0.0;
  double squares = 0.0;  // A^2 s, of all samples but the last, which lasts no time
  for (std::size_t i = 0; i < input.times.size(); ++i) {
    const double current = input.currents[i].cwiseAbs().maxCoeff();
    largest = std::max(largest, current);
    if (i + 1 < input.times.size()) squares += current * current * (input.times[i + 1] - input.times[i]);
  }
  const double duration = input.times.back() - input.times.front();
  const double in_a_second = squares / std::max(1.0, duration);
  const bool melts = coil && in_a_second * coil->resistance > melting_above_room * copper_heat * coil->copper_mass;
  if (!melts && largest <= largest_current) return;
  const std::string column = columns_of_input(command).front();
  const bool voltage = command.drive == simulation::Drive::voltage;
  throw InputError(
      {.file = file,
       .place = "column " + column,
       .rule = fmt::format("{} {:.4g} A{}: looks like {} (name the column {}); --as-written takes it as it is",
                           voltage ? "drives up to" : "reaches", largest,
                           melts ? ", by which a coil's copper melts within a second" : ", which no such coil carries",
                           voltage ? "millivolts" : "milliamperes",
                           column.substr(0, column.rfind('_')) + (voltage ? "_mV" : "_mA"))});
}

}  // namespace coilwright::formats
