#include "formats/data/run_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "coilwright/units/unit.hpp"
#include "formats/data/layout_format.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using measurement::data::ChannelKind;
using measurement::data::Drive;
using measurement::data::Run;
using measurement::data::RunKind;

// Segments meet long before: a finger of four joints at 120 degrees each has bent 480. A free pendulum may turn for
// ever; nothing drives one by a coil.
constexpr double largest_finger_angle = 4.0 * std::numbers::pi;

// Which of the columns have a value in a row: none, all, or an error at the one that has not.
bool is_there(const CsvTable& table, const std::vector<std::string>& quantities, std::size_t row) {
  const std::string* absent = nullptr;
  std::size_t there = 0;
  for (const std::string& quantity : quantities) {
    if (std::isnan(table.column(quantity)[row]))
      absent = &quantity;
    else
      ++there;
  }
  if (absent && there > 0)
    throw table.error(*absent, row,
                      "must have a value where others of its kind have: measured columns are at the same times, and so "
                      "are inputs. Bring them to one clock, or name all but one of them in \"ignore\" in dataset.json");
  return !absent;
}

template <class Value>
void keep(std::vector<Value>& values, const std::vector<std::size_t>& rows) {
  if (values.empty()) return;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (rows[i] != i) values[i] = std::move(values[rows[i]]);
  values.resize(rows.size());
}

double longest_interval(const std::vector<double>& times) {
  double longest = 0.0;
  for (std::size_t i = 1; i < times.size(); ++i) longest = std::max(longest, times[i] - times[i - 1]);
  return longest;
}

// A sensor that turns from one end of its range to the other between two samples, and else never by so much. A finger
// sampled slowly may come near half a turn: there all other steps must be small.
struct Wrap {
  double period;
  double least_jump;
  double largest_step;
};
constexpr std::array wraps = {Wrap{2.0 * std::numbers::pi, 0.6 * 2.0 * std::numbers::pi, 0.4 * 2.0 * std::numbers::pi},
                              Wrap{std::numbers::pi, 0.75 * std::numbers::pi, 0.125 * std::numbers::pi}};
constexpr std::size_t least_samples = 10;

// The first sample after such a jump.
std::optional<std::size_t> first_wrap(const std::vector<double>& values, const Wrap& wrap) {
  if (values.size() < least_samples) return std::nullopt;
  const auto [lowest, highest] = std::ranges::minmax(values);
  if (highest - lowest > wrap.period * 1.001) return std::nullopt;
  std::optional<std::size_t> first;
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double step = std::abs(values[i] - values[i - 1]);
    if (step >= wrap.least_jump && std::abs(step - wrap.period) <= wrap.largest_step) {
      if (!first) first = i;
    } else if (step > wrap.largest_step) {
      return std::nullopt;
    }
  }
  return first;
}

std::optional<Objection> wrapping(const measurement::data::Channel& channel, const std::string& quantity,
                                  const CsvTable& table, const CsvLayout& layout) {
  for (const Wrap& wrap : wraps) {
    const auto at = first_wrap(channel.values, wrap);
    if (!at) continue;
    // The row of the table with that value: rows without one were left out before.
    const auto column = table.column(quantity);
    std::size_t row = 1;
    while (row + 1 < column.size() &&
           !(column[row] == channel.values[*at] && column[row - 1] == channel.values[*at - 1]))
      ++row;
    CsvColumn told{.source = channel.name, .name = channel.name};
    for (const CsvColumn& each : layout.columns)
      if (each.name == channel.name) told = each;
    told.period = units::from_memory(wrap.period, channel.name);
    InputError error =
        table.error(quantity, row,
                    fmt::format("jumps by {:.0f} deg from {:.6g} within a sample: the reading wraps at {:.0f} deg. To "
                                "have it put together, give "
                                "the column \"wraps_deg\" in dataset.json: {}",
                                (channel.values[*at] - channel.values[*at - 1]) / units::to_memory(1.0, "x_deg"),
                                units::from_memory(channel.values[*at - 1], channel.name),
                                wrap.period / units::to_memory(1.0, "x_deg"), pasted({.columns = {told}})));
    return Objection{.error = std::move(error), .wrapped = told};
  }
  return std::nullopt;
}

}  // namespace

RunOfRows with_values_that_are_there(Run run, const CsvTable& table, const RunColumns& columns) {
  std::vector<std::string> measured;
  for (const Measured& each : columns.measured) measured.push_back(each.quantity);
  const std::vector<std::string> inputs = columns.input ? columns.input->quantities : std::vector<std::string>{};
  std::vector<std::size_t> measured_rows, input_rows;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (is_there(table, measured, row)) measured_rows.push_back(row);
    if (is_there(table, inputs, row)) input_rows.push_back(row);
  }
  if (measured_rows.size() == table.rows() && input_rows.size() == table.rows()) return {.run = std::move(run)};
  if (measured_rows.size() < 2) throw table.error(measured.front(), 0, "must have at least two values in the file");
  if (input_rows.empty()) throw table.error(inputs.front(), 0, "must have a value in the file");
  std::size_t outside = 0;
  if (!inputs.empty() && input_rows != measured_rows) {
    run.input_times = run.times;
    keep(run.input_times, input_rows);
    const double from = run.input_times.front(), to = run.input_times.back() + longest_interval(run.input_times);
    outside =
        std::erase_if(measured_rows, [&](std::size_t row) { return run.times[row] < from || run.times[row] > to; });
    if (measured_rows.size() < 2)
      throw table.error(measured.front(), 0, "must have values where the input has some: the two do not overlap");
  }
  keep(run.inputs, inputs.empty() ? measured_rows : input_rows);
  keep(run.times, measured_rows);
  for (measurement::data::Channel& channel : run.channels) keep(channel.values, measured_rows);
  std::string text = fmt::format("{} of {} rows have measured values", measured_rows.size() + outside, table.rows());
  if (!inputs.empty())
    text += fmt::format(", and {} an input; each is taken at the times that it has", input_rows.size());
  if (outside > 0) text += fmt::format("; {} measured before the first input or after the last are left out", outside);
  return {.run = std::move(run), .warning = measurement::data::Warning{.run = {}, .text = std::move(text)}};
}

std::optional<Objection> objection_to(const Run& run, const CsvTable& table, const RunColumns& columns,
                                      const CsvLayout& layout) {
  const bool may_turn = run.drive == Drive::torque && run.kind == RunKind::transient;
  std::vector<std::string> angles;
  if (columns.angles) angles.emplace_back("angle");
  for (std::size_t i = 0; i < columns.measured.size(); ++i) {
    const Measured& measured = columns.measured[i];
    if (measured.kind != ChannelKind::bending_angle && measured.kind != ChannelKind::joint_angle) continue;
    if (auto wrap = wrapping(run.channels[i], measured.quantity, table, layout)) return wrap;
    if (!may_turn) angles.push_back(measured.quantity);
  }
  for (const std::string& quantity : angles) {
    const auto values = table.column(quantity);
    for (std::size_t row = 0; row < values.size(); ++row)
      if (std::abs(values[row]) > largest_finger_angle)
        return Objection{.error =
                             table.error(quantity, row,
                                         "must be within two turns, as no finger bends further (is the unit right?)")};
  }
  return std::nullopt;
}

}  // namespace coilwright::formats
