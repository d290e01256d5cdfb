#include "coilwright/formats/data/run_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include "coilwright/text/csv/csv_table.hpp"
#include "coilwright/text/one_line.hpp"
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
  std::optional<InputColumns> input{};
  std::vector<Measured> measured{};  // those whose unit sigma has first
  bool times{};
  bool angles{};
  bool openings{};
  bool heights{};
  std::vector<std::string> names{};  // all that are looked at
};

constexpr std::string_view advice = R"(; a column that is to be left alone is named in "ignore" of its run)";

std::string_view quantity_of(std::string_view name) {
  const auto split = units::split_unit(name);
  return split ? split->quantity : name;
}

void ask_numbered(CsvHeader& header, Columns& columns, const std::string& quantity, const std::string& unit,
                  ChannelKind kind) {
  const std::size_t count = header.numbered(quantity + "#" + unit);
  for (std::size_t number = 1; number <= count; ++number)
    columns.measured.push_back(
        {.quantity = quantity + std::to_string(number), .kind = kind, .joint = static_cast<int>(number) - 1});
}

void ask_motion(CsvHeader& header, Columns& columns) {
  columns.times = true;
  header.require("time_s");
  if (header.find("bending_angle_deg"))
    columns.measured.push_back({.quantity = "bending_angle", .kind = ChannelKind::bending_angle});
  ask_numbered(header, columns, "theta", "_deg", ChannelKind::joint_angle);
  ask_numbered(header, columns, "omega", "_rad_s", ChannelKind::joint_rate);
}

Columns ask_transient(CsvHeader& header, const RunEntry& entry) {
  Columns columns;
  ask_motion(header, columns);
  if (entry.input_file) {
    // A column that is an input by its name is told what it is, before it counts as unknown.
    CsvHeader inputs = header;
    if (find_input(inputs))
      throw header.error("must have no input column, because the run's \"input_file\" has the input");
    header.finish(advice);
  } else if (entry.rig.coil == measurement::data::CoilWiring::driven) {
    columns.input = ask_for_input(header, advice);
  } else {
    columns.input = find_input(header);
    header.finish(advice);
  }
  if (columns.measured.empty())
    throw header.error("must have a measured column: bending_angle_deg, theta1_deg.. or omega1_rad_s..");
  return columns;
}

Columns ask_still(CsvHeader& header) {
  Columns columns;
  ask_motion(header, columns);
  for (const char* name : {"current_A", "current#_A", "voltage_V", "torque#_Nm"}) header.ignore(name);
  header.finish(advice);
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
    columns.input =
        InputColumns{.drive = Drive::current, .addressing = simulation::Addressing::common, .quantities = {"current"}};
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
    columns.openings = header.find("opening_deg");
    columns.heights = header.find("height_mm");
  }
  header.finish(advice);
  return columns;
}

// Takes the columns that the run leaves alone out of the header, and notes which of them were there.
std::set<std::string> leave_alone(CsvHeader& header, const RunEntry& entry) {
  std::set<std::string> found;
  for (const std::string& name : entry.ignore)
    if (header.leave_alone(name)) found.insert(name);
  return found;
}

void require_found(const CsvHeader& header, const RunEntry& entry, const std::set<std::string>& found) {
  for (const std::string& name : entry.ignore)
    if (!found.contains(name)) throw header.error(name, R"(is not there, and the run's "ignore" names it)");
}

// The file of a run that also holds its input, or of a bench.
Columns ask(CsvHeader& header, const RunEntry& entry, std::set<std::string>& ignored) {
  ignored = leave_alone(header, entry);
  if (!entry.input_file) require_found(header, entry, ignored);
  Columns columns = entry.kind == RunKind::transient ? ask_transient(header, entry)
                    : entry.kind == RunKind::still   ? ask_still(header)
                                                     : ask_bench(header, entry.kind);
  for (const std::string& name : header.names())
    if (!ignored.contains(name)) columns.names.push_back(name);
  return columns;
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
  if (!columns.input || columns.input->drive != Drive::torque)
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

double median_interval(const std::vector<double>& times) {
  std::vector<double> intervals(times.size() - 1);
  for (std::size_t i = 1; i < times.size(); ++i) intervals[i - 1] = times[i] - times[i - 1];
  const auto middle = intervals.begin() + static_cast<std::ptrdiff_t>(intervals.size() / 2);
  std::ranges::nth_element(intervals, middle);
  return *middle;
}

std::vector<double> read_times(const CsvTable& table) {
  table.require_increasing("time");
  if (table.rows() < 2) throw table.error("time", 0, "must be followed by a second sample");
  return values_of(table, "time");
}

std::vector<std::vector<double>> read_inputs(const CsvTable& table, const InputColumns& input) {
  std::vector<std::vector<double>> rows(table.rows());
  for (const std::string& quantity : input.quantities) {
    const std::vector<double> values = values_of(table, quantity);
    for (std::size_t row = 0; row < values.size(); ++row) rows[row].push_back(values[row]);
  }
  return rows;
}

std::vector<double> not_negative(const CsvTable& table, const std::string& quantity) {
  std::vector<double> values = values_of(table, quantity);
  for (std::size_t row = 0; row < values.size(); ++row)
    if (values[row] < 0.0) throw table.error(quantity, row, "must be >= 0");
  return values;
}

Run run_of(const CsvTable& table, const Columns& columns, const RunEntry& entry) {
  Run run{.name = entry.name,
          .kind = entry.kind,
          .drive = columns.input ? columns.input->drive : Drive::current,
          .start = entry.start,
          .window = entry.window,
          .clock = {.offset_sigma = entry.clock_offset.value_or(0.0),
                    .rate_sigma = entry.clock_rate,
                    .exposure = entry.exposure},
          .hold = entry.hold,
          .rig = entry.rig};
  if (columns.times) run.times = read_times(table);
  if (columns.angles) run.angles = values_of(table, "angle");
  if (columns.openings) run.openings = not_negative(table, "opening");
  if (columns.heights) run.heights = not_negative(table, "height");
  if (columns.input) run.inputs = read_inputs(table, *columns.input);
  // Without a driver no current is commanded.
  if (run.kind == RunKind::transient && !columns.input && !entry.input_file) run.inputs.assign(table.rows(), {0.0});
  for (const Measured& measured : columns.measured) run.channels.push_back(channel_of(table, measured));
  if (entry.sigma) run.sigma = units::to_memory(*entry.sigma, run.channels.front().name);
  return run;
}

// The header of the file that has the input alone.
InputColumns ask_input_file(CsvHeader& header, const RunEntry& entry, const Columns& measured,
                            std::set<std::string> ignored) {
  ignored.merge(leave_alone(header, entry));
  require_found(header, entry, ignored);
  for (const std::string& name : header.names()) {
    if (ignored.contains(name) || quantity_of(name) == "time") continue;
    for (const std::string& other : measured.names)
      if (quantity_of(other) == quantity_of(name))
        throw header.error(name, "is in " + one_line(entry.name) + " too; a column may be in one of the two only");
  }
  header.require("time_s");
  return ask_for_input(header, advice);
}

void require_covers(const CsvTable& table, const Run& run) {
  const double first = run.times.front();
  const double last = run.times.back();
  const double shift = 3.0 * (run.clock.offset_sigma + run.clock.rate_sigma * (last - first));
  if (run.input_times.front() > first + shift)
    throw table.error(
        "time", 0,
        fmt::format("must not begin after the measurement of {} does ({:.6g} s)", one_line(run.name), first));
  double longest = 0.0;
  for (std::size_t i = 1; i < run.input_times.size(); ++i)
    longest = std::max(longest, run.input_times[i] - run.input_times[i - 1]);
  if (run.input_times.back() < last - shift - longest)
    throw table.error(
        "time", run.input_times.size() - 1,
        fmt::format("must reach the end of the measurement of {} ({:.6g} s) to within the longest interval "
                    "of the input ({:.6g} s); an input that is held is repeated there",
                    one_line(run.name), last, longest));
}

void add_input_file(Run& run, const RunEntry& entry, const Columns& measured, const std::set<std::string>& ignored) {
  InputColumns columns;
  const CsvTable table = read_csv(
      *entry.input_file, [&](CsvHeader& header) { columns = ask_input_file(header, entry, measured, ignored); });
  run.drive = columns.drive;
  run.input_times = read_times(table);
  run.inputs = read_inputs(table, columns);
  if (!entry.clock_offset) run.clock.offset_sigma = median_interval(run.times);
  require_covers(table, run);
}

template <class Read>
RunFile run_file(const RunEntry& entry, Read&& read) {
  Columns columns;
  std::set<std::string> ignored;
  const CsvTable table = read([&](CsvHeader& header) { columns = ask(header, entry, ignored); });
  Run run = run_of(table, columns, entry);
  if (entry.input_file) {
    add_input_file(run, entry, columns, ignored);
    columns.input = InputColumns{.drive = run.drive, .addressing = {}, .quantities = {}};
  }
  return {.run = std::move(run), .objection = objection(table, columns)};
}

}  // namespace

RunFile read_run(const std::filesystem::path& path, const RunEntry& entry) {
  return run_file(entry, [&](const auto& ask) { return read_csv(path, ask); });
}

RunFile parse_run(std::string_view text, std::string file, const RunEntry& entry) {
  return run_file(entry, [&](const auto& ask) { return parse_csv(text, std::move(file), ask); });
}

}  // namespace coilwright::formats
