#include "coilwright/formats/data/expected_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/text/csv/csv_writer.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::formats {
namespace {

using measurement::experiment::ExpectedReading;
using measurement::experiment::NextExperiment;
using text::CsvCell;

void check(const NextExperiment& next) {
  for (const ExpectedReading& each : next.expected) {
    bool whole = each.values.size() == next.explanations.size();
    for (const std::vector<double>& values : each.values) whole = whole && values.size() == each.at.size();
    if (!whole)
      throw std::invalid_argument(fmt::format("readings of {} in {}: each of {} explanations must have {} values",
                                              each.channel, each.run, next.explanations.size(), each.at.size()));
  }
}

std::vector<std::string> names_of(const std::vector<std::vector<std::string>>& explanations) {
  std::vector<std::string> names;
  std::map<std::string, int> seen;
  for (const std::vector<std::string>& ids : explanations) {
    const std::string name = ids.empty() ? "no effect" : fmt::format("{}", fmt::join(ids, "+"));
    const int again = ++seen[name];
    names.push_back(again == 1 ? name : fmt::format("{} ({})", name, again));
  }
  return names;
}

CsvCell cell(double value, std::string_view column) {
  return units::from_si(value, units::difference_unit(column)) + 0.0;  // no -0
}

}  // namespace

void write_expected_readings(std::ostream& out, const NextExperiment& next) {
  check(next);
  std::vector<std::string> columns{"run", "channel", "time_s", "angle_deg", "noise"};
  for (std::string& name : names_of(next.explanations)) columns.push_back(std::move(name));
  text::CsvWriter csv(out, columns);
  for (const ExpectedReading& each : next.expected) {
    const bool bench = each.kind == measurement::data::ChannelKind::torque;
    for (std::size_t i = 0; i < each.at.size(); ++i) {
      std::vector<CsvCell> row{each.run, each.channel, bench ? CsvCell() : cell(each.at[i], "time_s"),
                               bench ? cell(each.at[i], "angle_deg") : CsvCell(), cell(each.noise, each.channel)};
      for (const std::vector<double>& values : each.values) row.push_back(cell(values[i], each.channel));
      csv.row(row);
    }
  }
}

}  // namespace coilwright::formats
