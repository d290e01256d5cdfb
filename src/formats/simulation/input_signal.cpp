#include "coilwright/formats/simulation/input_signal.hpp"

#include <array>
#include <string>

#include "coilwright/text/csv/csv_table.hpp"
#include "formats/simulation/input_columns.hpp"

namespace coilwright::formats {
namespace {

using namespace text;

// What a transient run may have been measured by; not an input.
constexpr std::array measured_columns = {"bending_angle_deg", "theta#_deg", "omega#_rad_s"};

InputColumns ask(CsvHeader& header) {
  header.require("time_s");
  for (const auto* name : measured_columns) header.ignore(name);
  return ask_for_input(header);
}

InputSignal signal_of(const CsvTable& table, const InputColumns& input) {
  table.require_increasing("time");
  InputSignal signal{.kind = input.kind, .addressing = input.addressing};
  const auto times = table.column("time");
  signal.times.assign(times.begin(), times.end());
  for (const std::string& quantity : input.quantities) {
    const auto values = table.column(quantity);
    signal.values.emplace_back(values.begin(), values.end());
  }
  return signal;
}

}  // namespace

InputSignal read_input_signal(const std::filesystem::path& path) {
  InputColumns input;
  const CsvTable table = read_csv(path, [&](CsvHeader& header) { input = ask(header); });
  return signal_of(table, input);
}

InputSignal parse_input_signal(std::string_view text, std::string_view file) {
  InputColumns input;
  const CsvTable table = parse_csv(text, std::string(file), [&](CsvHeader& header) { input = ask(header); });
  return signal_of(table, input);
}

}  // namespace coilwright::formats
