#include "coilwright/formats/data/run_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "coilwright/text/csv/csv_table.hpp"
#include "coilwright/text/one_line.hpp"
#include "coilwright/units/unit.hpp"
#include "formats/data/run_columns.hpp"
#include "formats/simulation/plausible_ranges.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using measurement::data::Channel;
using measurement::data::ChannelKind;
using measurement::data::Drive;
using measurement::data::Run;
using measurement::data::RunKind;

std::vector<double> values_of(const CsvTable& table, const std::string& quantity) {
  const auto column = table.column(quantity);
  for (std::size_t row = 0; row < column.size(); ++row)
    if (!std::isnan(column[row]) && !measured_rule.allows(column[row]))
      throw table.error(quantity, row, "must be a number that can be measured, at most 1e12");
  return {column.begin(), column.end()};
}

Channel channel_of(const CsvTable& table, const Measured& measured) {
  Channel channel{.name = table.name(measured.quantity),
                  .kind = measured.kind,
                  .joint = measured.joint,
                  .values = values_of(table, measured.quantity)};
  if (channel.kind == ChannelKind::temperature)  // degrees Celsius everywhere but in the table
    for (double& value : channel.values) value = units::from_si(value, "temperature_degC");
  return channel;
}

double median_interval(const std::vector<double>& times) {
  std::vector<double> intervals(times.size() - 1);
  for (std::size_t i = 1; i < times.size(); ++i) intervals[i - 1] = times[i] - times[i - 1];
  const auto middle = intervals.begin() + static_cast<std::ptrdiff_t>(intervals.size() / 2);
  std::ranges::nth_element(intervals, middle);
  return *middle;
}

std::vector<double> read_times(const CsvTable& table, const CsvLayout& layout) {
  std::string source = table.name("time");
  for (const CsvColumn& each : layout.columns)
    if (each.name == source) source = each.source;
  table.require_increasing(
      "time", ", and a run of each in dataset.json",
      fmt::format("; in dataset.json, give that as \"sampling_rate_Hz\", and {} in \"ignore\"", in_quotes(source)));
  if (table.rows() < 2) throw table.error("time", 0, "must be followed by a second sample");
  require_few_samples(table);
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

// In SI, of every column; as many as were given where that is neither one nor one each, which the data set refuses.
measurement::data::InputUncertainty input_uncertainty_of(const RunEntry& entry, const CsvTable& table,
                                                         const InputColumns& input) {
  measurement::data::InputUncertainty out = entry.input_uncertainty;
  if (out.sigma.size() == 1) out.sigma.assign(input.quantities.size(), out.sigma.front());
  for (double& sigma : out.sigma) sigma = units::to_memory(sigma, table.name(input.quantities.front()));
  return out;
}

Run run_of(const CsvTable& table, const RunColumns& columns, const RunEntry& entry) {
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
  if (columns.times) run.times = read_times(table, entry.layout.layout);
  if (columns.angles) run.angles = values_of(table, "angle");
  if (columns.openings) run.openings = not_negative(table, "opening");
  if (columns.heights) run.heights = not_negative(table, "height");
  if (columns.input) {
    run.inputs = read_inputs(table, *columns.input);
    run.input_uncertainty = input_uncertainty_of(entry, table, *columns.input);
  }
  // Without a driver no current is commanded.
  if (run.kind == RunKind::transient && !columns.input && !entry.input_file) run.inputs.assign(table.rows(), {0.0});
  for (const Measured& measured : columns.measured) run.channels.push_back(channel_of(table, measured));
  if (entry.sigma) run.sigma = units::to_memory(*entry.sigma, run.channels.front().name);
  return run;
}

// A time on the clock of the measurement as a row of the input's file has it.
std::string row_time(const CsvTable& input, double seconds, double shift) {
  using Kind = ClockOrigin::Kind;
  const Kind origin = input.clock_origin().kind;
  const double own = seconds - shift;
  if (origin == Kind::day) return fmt::format("{:.6g} s after its first row", own - input.column("time").front());
  const double from = origin == Kind::number ? input.clock_origin().seconds : 0.0;
  return fmt::format("{}", units::from_si(own + from, input.name("time")));
}

void require_covers(const CsvTable& table, const Run& run, double zero) {
  const double first = run.times.front();
  const double last = run.times.back();
  const double shift = 3.0 * (run.clock.offset_sigma + run.clock.rate_sigma * (last - first));
  // Of two clocks in one unit neither lasts so much longer.
  constexpr double much_longer = 20.0;
  const double length = run.input_times.back() - run.input_times.front();
  const bool other_unit = last - first > much_longer * length || length > much_longer * (last - first);
  const auto cure = [&](std::string_view row, double time, std::string_view rows) {
    if (other_unit)
      return fmt::format(
          " (it lasts {:.4g} s, the measurement {:.4g} s: is one of them in another unit? A column is "
          "named by the unit of its numbers)",
          length, last - first);
    return fmt::format(
        "; if the input was held there, repeat its {} row with the time {}, else delete the rows of {} {}", row,
        row_time(table, time, zero), one_line(run.name), rows);
  };
  if (run.input_times.front() > first + shift)
    throw table.error("time", 0,
                      fmt::format("must not begin after the measurement of {} does ({:.6g} s){}", one_line(run.name),
                                  first, cure("first", first, "before it")));
  double longest = 0.0;
  for (std::size_t i = 1; i < run.input_times.size(); ++i)
    longest = std::max(longest, run.input_times[i] - run.input_times[i - 1]);
  if (run.input_times.back() < last - shift - longest)
    throw table.error("time", run.input_times.size() - 1,
                      fmt::format("must reach the end of the measurement of {} ({:.6g} s) to within the longest "
                                  "interval of the input ({:.6g} s){}",
                                  one_line(run.name), last, longest, cure("last", last, "after it")));
}

// By how much the times of the input file are shifted so that both files count from one zero.
double shift_of(const CsvTable& input, const ClockOrigin& measured, const Run& run, const RunEntry& entry) {
  using Kind = ClockOrigin::Kind;
  const ClockOrigin& origin = input.clock_origin();
  if (origin.kind != measured.kind) {
    if (entry.clock_offset) return 0.0;
    throw input.error(
        "time", 0,
        fmt::format("must count from the zero that {} counts from: one of the two has a date or a number "
                    "of many digits, the other has not. With \"clock_offset_s\" in its run, how well their "
                    "first rows agree (s, standard deviation), each counts from its first row",
                    one_line(run.name)));
  }
  if (origin.kind == Kind::day && origin.date != measured.date && !origin.date.empty() && !measured.date.empty())
    throw input.error("time", 0,
                      fmt::format("must be of the day of {}, {}; its date is {}", one_line(run.name),
                                  in_quotes(measured.date), in_quotes(origin.date)));
  return origin.seconds - measured.seconds;
}

void add_input_file(RunFile& file, const RunEntry& entry, const RunColumns& measured, const ClockOrigin& clock) {
  Run& run = file.run;
  const CsvLayout& layout = entry.input_layout ? entry.input_layout->layout : entry.layout.layout;
  InputColumns columns;
  const CsvTable table = read_csv(
      *entry.input_file,
      [&](CsvHeader& header) {
        columns = ask_for_run_input(header, entry, measured, file.used);
        file.used.merge(used_of(layout, header));
      },
      layout);
  run.drive = columns.drive;
  run.input_times = read_times(table, layout);
  const double shift = shift_of(table, clock, run, entry);
  for (double& time : run.input_times) time += shift;
  run.inputs = read_inputs(table, columns);
  run.input_uncertainty = input_uncertainty_of(entry, table, columns);
  if (!entry.clock_offset) run.clock.offset_sigma = median_interval(run.times);
  require_covers(table, run, shift);
}

template <class Read>
RunFile run_file(const RunEntry& entry, Read&& read) {
  RunColumns columns;
  RunFile file;
  const CsvTable table = read([&](CsvHeader& header) {
    columns = ask_for_run(header, entry);
    file.used = used_of(entry.layout.layout, header);
    if (header.form().names_line > 0 && !header.form().preamble.empty()) {
      // Lines that no key names, and that an editor would not show as a part of the table.
      const auto above = std::ranges::count_if(header.form().preamble, [](const std::string& line) {
        return !line.starts_with('#') && line.find_first_not_of(" \t\r,;") != std::string::npos;
      });
      if (above > 0)
        file.warnings.push_back({.run = entry.name,
                                 .text = fmt::format("the columns are named in line {}; what stands above was not read",
                                                     header.form().names_line)});
    }
  });
  RunOfRows rows = with_values_that_are_there(run_of(table, columns, entry), table, columns);
  file.run = std::move(rows.run);
  if (rows.warning) file.warnings.push_back({.run = entry.name, .text = rows.warning->text});
  if (entry.input_file) add_input_file(file, entry, columns, table.clock_origin());
  file.objection = objection_to(file.run, table, columns, entry.layout.layout);
  return file;
}

}  // namespace

RunFile read_run(const std::filesystem::path& path, const RunEntry& entry) {
  return run_file(entry, [&](const auto& ask) { return read_csv(path, ask, entry.layout.layout); });
}

RunFile parse_run(std::string_view text, std::string file, const RunEntry& entry) {
  return run_file(entry, [&](const auto& ask) { return parse_csv(text, std::move(file), ask, entry.layout.layout); });
}

}  // namespace coilwright::formats
