#include "coilwright/formats/input_signal.hpp"

#include <array>
#include <optional>
#include <string>

#include "coilwright/formats/csv_table.hpp"

namespace coilwright::formats {
namespace {

struct InputColumns {
  std::string_view name;  // "#" stands for the number of the coil or joint
  InputKind kind;
  InputAddressing addressing;
};

constexpr std::array input_columns = {
    InputColumns{"current_A", InputKind::current, InputAddressing::common},
    InputColumns{"current#_A", InputKind::current, InputAddressing::each},
    InputColumns{"voltage_V", InputKind::voltage, InputAddressing::common},
    InputColumns{"torque#_Nm", InputKind::torque, InputAddressing::each},
};

// What a transient run may have been measured by; not an input.
constexpr std::array measured_columns = {"bending_angle_deg", "theta#_deg", "omega#_rad_s"};

struct Chosen {
  InputColumns input{};
  std::size_t count{0};
};

std::size_t count_of(CsvHeader& header, const InputColumns& input) {
  if (input.addressing == InputAddressing::each) return header.numbered(input.name);
  return header.find(input.name) ? 1 : 0;
}

Chosen choose(CsvHeader& header) {
  header.require("time_s");
  for (const auto* name : measured_columns) header.ignore(name);
  std::optional<Chosen> chosen;
  for (const InputColumns& input : input_columns) {
    const std::size_t count = count_of(header, input);
    if (count == 0) continue;
    if (chosen)
      throw header.error("must have one kind of input only (current_A, current1_A.., voltage_V, torque1_Nm..)");
    chosen = Chosen{.input = input, .count = count};
  }
  header.finish();  // a misspelt input is named as such before it is missed
  if (!chosen) throw header.error("must have an input column: current_A, current1_A.., voltage_V or torque1_Nm..");
  return *chosen;
}

std::string quantity(const Chosen& chosen, std::size_t number) {
  const std::string_view name = chosen.input.name;
  if (chosen.input.addressing == InputAddressing::common) return std::string(name.substr(0, name.rfind('_')));
  return std::string(name.substr(0, name.find('#'))) + std::to_string(number);
}

InputSignal signal_of(const CsvTable& table, const Chosen& chosen) {
  table.require_increasing("time");
  InputSignal signal{.kind = chosen.input.kind, .addressing = chosen.input.addressing};
  const auto times = table.column("time");
  signal.times.assign(times.begin(), times.end());
  for (std::size_t number = 1; number <= chosen.count; ++number) {
    const auto values = table.column(quantity(chosen, number));
    signal.values.emplace_back(values.begin(), values.end());
  }
  return signal;
}

}  // namespace

InputSignal read_input_signal(const std::filesystem::path& path) {
  Chosen chosen;
  const CsvTable table = read_csv(path, [&](CsvHeader& header) { chosen = choose(header); });
  return signal_of(table, chosen);
}

InputSignal parse_input_signal(std::string_view text, std::string_view file) {
  Chosen chosen;
  const CsvTable table = parse_csv(text, std::string(file), [&](CsvHeader& header) { chosen = choose(header); });
  return signal_of(table, chosen);
}

}  // namespace coilwright::formats
