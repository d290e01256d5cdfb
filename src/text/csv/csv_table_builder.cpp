#include "text/csv/csv_table_builder.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "coilwright/text/one_line.hpp"
#include "text/csv/csv_fields.hpp"

namespace coilwright::text {
namespace {

using From = CsvHeader::Column::From;

constexpr double not_there = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t most_named_lines = 20;  // lines that a person deletes

// Where to look, and what to do, for rows at fault: `what` is what is wrong with the rows that are to go.
std::string cure(const std::vector<std::size_t>& lines, std::size_t rows, bool absent) {
  const std::string of = absent ? "the rows that have none" : "the line if it is damaged";
  if (lines.size() == 1) return fmt::format(" (delete {})", of);
  if (lines.size() > most_named_lines || 4 * lines.size() > rows)
    return fmt::format(" ({} more rows are like it)", lines.size() - 1);
  return fmt::format(" (delete {}, and {} {})", of, lines.size() == 2 ? "line" : "lines",
                     fmt::join(lines.begin() + 1, lines.end(), ", "));
}

}  // namespace

double CsvTableBuilder::Unwrapped::operator()(double value) {
  if (period == 0.0) return value;
  value -= period * std::round((value - before.value_or(0.0)) / period);
  before = value;
  return value;
}

CsvTableBuilder::CsvTableBuilder(std::string file, const CsvForm& form, const CsvLayout& layout,
                                 const std::function<void(CsvHeader&)>& ask)
    : width_(form.names.size()), names_(form.names), decimal_(form.decimal) {
  table_.file_ = std::move(file);
  CsvHeader header(table_.file_, form, layout);
  ask(header);
  header.finish();
  gaps_ = header.gaps_allowed();
  add_markers(form, layout);
  for (std::size_t i = 0; i < header.columns().size(); ++i) {
    const CsvHeader::Column& column = header.columns()[i];
    if (!header.looks_at(i)) continue;
    const auto split = units::split_unit(column.name);
    // Angles from positions turn by any number of turns.
    const double period = column.from == From::markers ? 2.0 * std::numbers::pi : column.period;
    columns_.push_back({.column = column,
                        .unit = split ? split->unit : units::Unit{},
                        .kept = header.keeps(i),
                        .time = split && split->quantity == "time" && column.from == From::field,
                        .unwrapped = {.period = period}});
    if (columns_.back().time) clock_.emplace(column, decimal_);
    if (!header.keeps(i)) continue;
    table_.names_.push_back(column.name);
    table_.labels_.push_back(column.label);
  }
  table_.columns_.resize(table_.names_.size());
}

void CsvTableBuilder::add_markers(const CsvForm& form, const CsvLayout& layout) {
  for (const CsvMarkers& each : layout.markers) {
    Markers markers{.coordinates = {}, .y_is_up = each.y_is_up};
    std::vector<CsvPoint> points(each.line.begin(), each.line.end());
    if (each.against) points.insert(points.end(), each.against->begin(), each.against->end());
    for (const CsvPoint& point : points)
      for (std::size_t axis = 0; axis < 2; ++axis) {
        if (const auto* place = std::get_if<std::array<double, 2>>(&point)) {
          markers.coordinates.push_back({.field = {}, .place = (*place)[axis]});
          continue;
        }
        const std::string& source = std::get<std::array<std::string, 2>>(point)[axis];
        const auto found = std::ranges::find(form.names, source);
        const auto position = position_in(source);
        markers.coordinates.push_back(
            {.field = position ? *position : static_cast<std::size_t>(found - form.names.begin())});
      }
    markers_.push_back(std::move(markers));
  }
}

InputError CsvTableBuilder::at_fault(std::size_t line, const std::string& label, std::string_view field) const {
  return InputError({.file = table_.file_,
                     .place = fmt::format("line {}: column {}", line, label),
                     .rule = "must be a finite number",
                     .value = in_quotes(field)});
}

double CsvTableBuilder::angle(const Markers& markers, std::span<const std::string_view> fields,
                              std::size_t line) const {
  std::vector<double> at;
  for (const Coordinate& each : markers.coordinates) {
    if (!each.field) {
      at.push_back(each.place);
      continue;
    }
    const std::string_view field = fields[*each.field];
    const auto value = number_of(field, decimal_);
    if (!value && is_absent(field) && gaps_) return not_there;
    if (!value) throw at_fault(line, fmt::format("#{}", *each.field + 1), field);
    at.push_back(*value);
  }
  const auto from_down = [&](std::size_t first) {
    const double dx = at[first + 2] - at[first];
    const double dy = (at[first + 3] - at[first + 1]) * (markers.y_is_up ? -1.0 : 1.0);
    if (dx == 0.0 && dy == 0.0)
      throw InputError({.file = table_.file_,
                        .place = fmt::format("line {}", line),
                        .rule = "has both points of a line of \"markers\" in one place: no direction can be told"});
    return std::atan2(dx, dy);
  };
  return from_down(0) - (at.size() > 4 ? from_down(4) : 0.0);
}

std::optional<double> CsvTableBuilder::time_of(const CsvHeader::Column& column,
                                               std::span<const std::string_view> fields) {
  const auto whole = clock_->take(fields[column.index]);
  if (!whole || !column.part) return whole;
  const auto part = number_of(fields[*column.part], decimal_);
  const bool is_part = part && *part >= 0.0 && *part * column.part_unit < 1.0;
  return is_part ? std::optional(*whole + *part * column.part_unit) : std::nullopt;
}

void CsvTableBuilder::fill(Column& each, std::span<const std::string_view> fields, std::size_t line) {
  const CsvHeader::Column& column = each.column;
  if (column.from == From::row_number) {
    each.value = static_cast<double>(rows_) * column.factor;
  } else if (column.from == From::markers) {
    each.value = angle(markers_[column.index], fields, line);
    if (!std::isnan(each.value))
      each.value = column.factor * each.unwrapped(each.value) + units::to_si(column.offset, each.unit);
  } else {
    const std::string_view field = fields[column.index];
    const auto value = each.time ? time_of(column, fields) : number_of(field, decimal_);
    if (each.time && value) {
      each.value = *value;
    } else if (value) {
      each.value = units::to_si(each.unwrapped(column.factor * *value) + column.offset, each.unit);
    } else if (gaps_ && !each.time && is_absent(field)) {
      each.value = not_there;
    } else {
      throw at_fault(line, column.label, field);
    }
  }
}

void CsvTableBuilder::take(std::span<const std::string_view> fields, std::size_t line) {
  // A separator at the end of a row adds nothing.
  while (fields.size() > width_ && fields.back().empty()) fields = fields.first(fields.size() - 1);
  if ((table_.lines_.size() + 1) * table_.columns_.size() > csv_value_limit) {
    throw InputError({.file = table_.file_,
                      .place = fmt::format("line {}", line),
                      .rule = fmt::format("must not hold more than {} numbers", csv_value_limit)});
  }
  try {
    if (fields.size() != width_) {
      const bool decimal_commas = fields.size() > width_ && std::ranges::all_of(fields, [](std::string_view field) {
                                    return number_of(field, '.').has_value();
                                  });
      throw InputError({.file = table_.file_,
                        .place = fmt::format("line {}", line),
                        .rule = fmt::format("must have {} fields, as the header has{}", width_,
                                            decimal_commas ? " (are its decimals written with commas?)" : ""),
                        .value = std::to_string(fields.size())});
    }
    for (Column& column : columns_) fill(column, fields, line);
  } catch (const InputError& error) {
    if (std::ranges::equal(fields, names_)) return;  // a logger that was started again writes its header again
    if (!fault_) fault_ = error.fault();
    fault_lines_.push_back(line);
    return;
  }
  ++rows_;
  std::size_t target = 0;
  for (const Column& column : columns_)
    if (column.kept) table_.columns_[target++].push_back(column.value);
  table_.lines_.push_back(static_cast<std::uint32_t>(line));
}

CsvTable CsvTableBuilder::finish() {
  if (fault_) {
    const bool absent = fault_->value.size() >= 2 && is_absent(fault_->value.substr(1, fault_->value.size() - 2));
    if (!fault_->rule.ends_with(')')) fault_->rule += cure(fault_lines_, rows_, absent);
    throw InputError(*fault_);
  }
  if (table_.lines_.empty()) throw InputError({.file = table_.file_, .rule = "must have a row below its header"});
  if (clock_) table_.clock_origin_ = clock_->origin();
  return std::move(table_);
}

}  // namespace coilwright::text
