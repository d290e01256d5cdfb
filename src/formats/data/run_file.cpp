#include "coilwright/formats/data/run_file.hpp"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "coilwright/text/csv/csv_table.hpp"
#include "coilwright/units/unit.hpp"
#include "formats/simulation/input_columns.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using measurement::data::Channel;
using measurement::data::ChannelKind;
using measurement::data::Drive;
using measurement::data::Run;
using measurement::data::RunKind;

// Far beyond any record, and near enough that no sum of squares overflows.
constexpr double largest_number = 1e12;
// Segments meet long before: a finger of four joints at 120 degrees each has bent 480. A free pendulum may turn for
// ever; nothing drives one by a coil.
constexpr double largest_finger_angle = 4.0 * std::numbers::pi;

struct Measured {
  std::string quantity;  // for CsvTable::column()
  ChannelKind kind{};
  int joint{};
};

// What a file has, as its header tells.
struct Columns {
  InputColumns input{};
  std::vector<Measured> measured{};  // those whose unit sigma has first
  bool times{};
  bool angles{};
};

void ask_numbered(CsvHeader& header, Columns& columns, const std::string& quantity, const std::string& unit,
                  ChannelKind kind) {
  const std::size_t count = header.numbered(quantity + "#" + unit);
  for (std::size_t number = 1; number <= count; ++number)
    columns.measured.push_back(
        {.quantity = quantity + std::to_string(number), .kind = kind, .joint = static_cast<int>(number) - 1});
}

Columns ask_transient(CsvHeader& header) {
  Columns columns{.times = true};
  header.require("time_s");
  if (header.find("bending_angle_deg"))
    columns.measured.push_back({.quantity = "bending_angle", .kind = ChannelKind::bending_angle});
  ask_numbered(header, columns, "theta", "_deg", ChannelKind::joint_angle);
  ask_numbered(header, columns, "omega", "_rad_s", ChannelKind::joint_rate);
  columns.input = ask_for_input(header);
  if (columns.measured.empty())
    throw header.error("must have a measured column: bending_angle_deg, theta1_deg.. or omega1_rad_s..");
  return columns;
}

Columns ask_bench(CsvHeader& header, RunKind kind) {
  Columns columns;
  columns.times = kind == RunKind::temperature;
  columns.angles = kind == RunKind::static_torque || kind == RunKind::joint_stiffness;
  if (columns.times) header.require("time_s");
  if (columns.angles) header.require("angle_deg");
  if (kind != RunKind::joint_stiffness) {
    header.require("current_A");
    columns.input = {.drive = Drive::current, .addressing = simulation::Addressing::common, .quantities = {"current"}};
  }
  if (columns.angles) {
    header.require("torque_Nmm");
    columns.measured.push_back({.quantity = "torque", .kind = ChannelKind::torque});
  } else if (columns.times) {
    header.require("temperature_degC");
    columns.measured.push_back({.quantity = "temperature", .kind = ChannelKind::temperature});
  } else {
    header.require("force_N");
    columns.measured.push_back({.quantity = "force", .kind = ChannelKind::force});
  }
  return columns;
}

Columns ask(CsvHeader& header, RunKind kind) {
  return kind == RunKind::transient ? ask_transient(header) : ask_bench(header, kind);
}

std::vector<double> values_of(const CsvTable& table, const std::string& quantity) {
  const auto column = table.column(quantity);
  for (std::size_t row = 0; row < column.size(); ++row)
    if (std::abs(column[row]) > largest_number)
      throw table.error(quantity, row, "must be a number that can be measured, at most 1e12");
  return {column.begin(), column.end()};
}

Channel channel_of(const CsvTable& table, const Measured& measured) {
  Channel channel{.name = table.name(measured.quantity),
                  .kind = measured.kind,
                  .joint = measured.joint,
                  .values = values_of(table, measured.quantity)};
  if (channel.kind == ChannelKind::temperature)  // degrees Celsius everywhere but in the table
    for (double& value : channel.values) value = units::from_si(value, channel.name);
  return channel;
}

std::optional<InputError> objection(const CsvTable& table, const Columns& columns) {
  std::vector<std::string> angles;
  if (columns.angles) angles.emplace_back("angle");
  if (columns.input.drive != Drive::torque)
    for (const Measured& measured : columns.measured)
      if (measured.kind == ChannelKind::bending_angle || measured.kind == ChannelKind::joint_angle)
        angles.push_back(measured.quantity);
  for (const std::string& quantity : angles) {
    const auto values = table.column(quantity);
    for (std::size_t row = 0; row < values.size(); ++row)
      if (std::abs(values[row]) > largest_finger_angle)
        return table.error(quantity, row, "must be within two turns, as no finger bends further (is the unit right?)");
  }
  return std::nullopt;
}

RunFile run_of(const CsvTable& table, const Columns& columns, const RunEntry& entry) {
  Run run{.name = entry.name,
          .kind = entry.kind,
          .drive = columns.input.drive,
          .start = entry.start,
          .window = entry.window};
  if (columns.times) {
    table.require_increasing("time");
    run.times = values_of(table, "time");
    if (table.rows() < 2) throw table.error("time", 0, "must be followed by a second sample");
  }
  if (columns.angles) run.angles = values_of(table, "angle");
  run.inputs.assign(columns.input.quantities.empty() ? 0 : table.rows(), {});
  for (const std::string& quantity : columns.input.quantities) {
    const std::vector<double> values = values_of(table, quantity);
    for (std::size_t row = 0; row < values.size(); ++row) run.inputs[row].push_back(values[row]);
  }
  for (const Measured& measured : columns.measured) run.channels.push_back(channel_of(table, measured));
  if (entry.sigma) run.sigma = units::to_memory(*entry.sigma, run.channels.front().name);
  return {.run = std::move(run), .objection = objection(table, columns)};
}

}  // namespace

RunFile read_run(const std::filesystem::path& path, const RunEntry& entry) {
  Columns columns;
  const CsvTable table = read_csv(path, [&](CsvHeader& header) { columns = ask(header, entry.kind); });
  return run_of(table, columns, entry);
}

RunFile parse_run(std::string_view text, std::string file, const RunEntry& entry) {
  Columns columns;
  const CsvTable table =
      parse_csv(text, std::move(file), [&](CsvHeader& header) { columns = ask(header, entry.kind); });
  return run_of(table, columns, entry);
}

}  // namespace coilwright::formats
