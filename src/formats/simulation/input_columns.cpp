#include "formats/simulation/input_columns.hpp"

#include <array>
#include <optional>
#include <string_view>

namespace coilwright::formats {
namespace {

using namespace text;
using simulation::Addressing;
using simulation::Drive;

struct Known {
  std::string_view name;  // "#" stands for the number of the coil or joint
  Drive drive;
  Addressing addressing;
};

constexpr std::array known_inputs = {
    Known{"current_A", Drive::current, Addressing::common},
    Known{"current#_A", Drive::current, Addressing::each},
    Known{"voltage_V", Drive::voltage, Addressing::common},
    Known{"torque#_Nm", Drive::torque, Addressing::each},
};

std::vector<std::string> quantities(CsvHeader& header, const Known& input) {
  const std::string_view name = input.name;
  if (input.addressing == Addressing::common) {
    if (!header.find(name)) return {};
    return {std::string(name.substr(0, name.rfind('_')))};
  }
  std::vector<std::string> all;
  const std::size_t count = header.numbered(name);
  for (std::size_t number = 1; number <= count; ++number)
    all.push_back(std::string(name.substr(0, name.find('#'))) + std::to_string(number));
  return all;
}

}  // namespace

std::optional<InputColumns> find_input(CsvHeader& header) {
  std::optional<InputColumns> chosen;
  for (const Known& input : known_inputs) {
    std::vector<std::string> found = quantities(header, input);
    if (found.empty()) continue;
    if (chosen)
      throw header.error("must have one kind of input only (current_A, current1_A.., voltage_V, torque1_Nm..)");
    chosen = InputColumns{.drive = input.drive, .addressing = input.addressing, .quantities = std::move(found)};
  }
  return chosen;
}

InputColumns ask_for_input(CsvHeader& header, std::string_view advice) {
  const std::optional<InputColumns> chosen = find_input(header);
  header.finish(advice);  // a misspelt input is named as such before it is missed
  if (!chosen) throw header.error("must have an input column: " + std::string(input_names));
  return *chosen;
}

}  // namespace coilwright::formats
