#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "coilwright/text/csv/csv_table.hpp"
#include "coilwright/text/number.hpp"
#include "coilwright/text/one_line.hpp"
#include "coilwright/text/spelling.hpp"
#include "coilwright/units/unit.hpp"
#include "text/csv/csv_fields.hpp"

namespace coilwright::text {
namespace {

using units::quantity_of;

// "theta1_rad" is the column that "theta1_deg" asks for.
bool answers(std::string_view name, std::string_view asked) {
  if (name == asked) return true;
  const auto present = units::split_unit(name), wanted = units::split_unit(asked);
  return present && wanted && present->quantity == wanted->quantity &&
         present->unit.dimension == wanted->unit.dimension;
}

std::string with_number(std::string_view pattern, std::size_t number) {
  const std::size_t mark = pattern.find('#');
  return fmt::format("{}{}{}", pattern.substr(0, mark), number, pattern.substr(mark + 1));
}

// What a column that is asked for may be called, each with the unit of its numbers.
std::string unknown_unit(std::string_view asked) {
  std::vector<std::string> names;
  if (const auto wanted = units::split_unit(asked))
    for (const units::Unit& unit : units::all_units())
      if (unit.dimension == wanted->unit.dimension)
        names.push_back(in_quotes(fmt::format("{}_{}", wanted->quantity, unit.suffix)));
  if (names.empty()) names.push_back(in_quotes(asked));
  constexpr std::size_t most_units = 4;
  if (names.size() > most_units) {
    names.resize(most_units);
    names.emplace_back("..");
  }
  return fmt::format("unknown unit; may be {}, with the numbers in that unit", fmt::join(names, " or "));
}

}  // namespace

CsvHeader::CsvHeader(std::string file, const CsvForm& form, const CsvLayout& layout)
    : file_(std::move(file)), form_(&form), others_ignored_(layout.ignore_others) {
  for (std::size_t i = 0; i < form.names.size(); ++i) {
    const std::string& name = form.names[i];
    columns_.push_back({.name = name, .label = name.empty() ? fmt::format("#{}", i + 1) : one_line(name), .index = i});
  }
  map_columns(layout);
  add_computed(layout);
  join_clock();
  for (std::size_t i = 0; i < columns_.size(); ++i)
    if (columns_[i].name.empty() && form.is_empty(i)) left_alone_.insert(i);
}

// The column with that name or position; notes where it is absent.
std::optional<std::size_t> CsvHeader::field_of(std::string_view source) {
  const std::vector<std::string>& names = form_->names;
  if (const auto position = position_in(source)) {
    if (*position < names.size()) return position;
  } else if (const auto found = std::ranges::find(names, source); found != names.end()) {
    if (std::find(std::next(found), names.end(), source) != names.end())
      throw error(source, fmt::format("is there twice: name the one that is meant by its position, \"#{}\" or another",
                                      found - names.begin() + 1));
    return static_cast<std::size_t>(found - names.begin());
  }
  absent_.emplace_back(source);
  return std::nullopt;
}

void CsvHeader::map_columns(const CsvLayout& layout) {
  for (const std::string& source : layout.ignore) {
    // A name that is there twice is left alone in both places.
    bool found = false;
    for (std::size_t i = 0; i < form_->names.size(); ++i)
      if (position_in(source) ? *position_in(source) == i : form_->names[i] == source) {
        left_alone_.insert(i);
        found = true;
      }
    if (!found) absent_.push_back(source);
  }
  bool by_position = false;
  for (const CsvColumn& each : layout.columns) {
    const auto index = field_of(each.source);
    if (!index || left_alone_.contains(*index)) continue;
    by_position = by_position || position_in(each.source);
    Column& column = columns_[*index];
    if (each.source != each.name) column.label = fmt::format("{} as {}", in_quotes(each.source), each.name);
    column.name = each.name;
    column.factor = each.factor;
    column.offset = each.offset;
    column.period = each.period;
  }
  // Who names columns by position has seen the others.
  for (std::size_t i = 0; i < columns_.size(); ++i)
    if (columns_[i].name.empty() && by_position) left_alone_.insert(i);
}

void CsvHeader::add_computed(const CsvLayout& layout) {
  for (std::size_t i = 0; i < layout.markers.size(); ++i) {
    const CsvMarkers& each = layout.markers[i];
    std::vector<CsvPoint> points(each.line.begin(), each.line.end());
    if (each.against) points.insert(points.end(), each.against->begin(), each.against->end());
    const std::size_t absent = absent_.size();
    for (const CsvPoint& point : points)
      if (const auto* sources = std::get_if<std::array<std::string, 2>>(&point))
        for (const std::string& source : *sources)
          if (const auto index = field_of(source)) left_alone_.insert(*index);
    if (absent_.size() > absent) continue;
    columns_.push_back({.name = each.name,
                        .label = fmt::format("{} from its markers", each.name),
                        .from = Column::From::markers,
                        .index = i,
                        .factor = each.factor,
                        .offset = each.offset});
  }
  if (!layout.sampling_rate) return;
  for (std::size_t i = 0; i < columns_.size(); ++i)
    if (!left_alone_.contains(i) && quantity_of(columns_[i].name) == "time" && !form_->is_empty(i)) {
      absent_.emplace_back("sampling_rate_Hz");
      return;
    }
  columns_.push_back({.name = "time_s",
                      .label = "time_s by the sampling rate",
                      .from = Column::From::row_number,
                      .factor = 1.0 / *layout.sampling_rate});
}

void CsvHeader::join_clock() {
  std::vector<std::size_t> times;
  for (std::size_t i = 0; i < columns_.size(); ++i)
    if (!left_alone_.contains(i) && columns_[i].from == Column::From::field && columns_[i].name.starts_with("time_") &&
        quantity_of(columns_[i].name) == "time")
      times.push_back(i);
  if (times.size() != 2) return;
  if (columns_[times[1]].name == "time_s") std::swap(times[0], times[1]);
  Column& whole = columns_[times[0]];
  const Column& part = columns_[times[1]];
  const double unit = units::to_si(1.0, units::split_unit(part.name)->unit);
  if (whole.name != "time_s" || unit >= 1.0) return;
  // The same clock in two units is none of two parts.
  for (const auto& row : form_->sample) {
    if (row.size() <= std::max(whole.index, part.index)) return;
    const auto seconds = number_of(row[whole.index], form_->decimal), rest = number_of(row[part.index], form_->decimal);
    if (!seconds || !rest || *seconds != std::floor(*seconds) || *rest < 0.0 || *rest * unit >= 1.0) return;
  }
  whole.part = part.index;
  whole.part_unit = unit;
  whole.label += fmt::format(" with {}", part.label);
  left_alone_.insert(times[1]);
}

std::size_t CsvHeader::index_of(std::string_view name) const {
  std::size_t i = 0;
  while (i < columns_.size() && (left_alone_.contains(i) || !answers(columns_[i].name, name))) ++i;
  return i;
}

bool CsvHeader::find(std::string_view name) {
  legal_.emplace_back(name);
  return ask(name);
}

bool CsvHeader::ask(std::string_view name) {
  asked_for_.emplace_back(name);
  const std::size_t index = index_of(name);
  if (index == columns_.size()) return false;
  for (std::size_t i = index + 1; i < columns_.size(); ++i)
    if (!left_alone_.contains(i) && quantity_of(columns_[i].name) == quantity_of(name))
      throw error(columns_[i].name, "must not be there twice");
  known_.insert(index);
  kept_.insert(index);
  return true;
}

std::vector<std::string> CsvHeader::names() const {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < columns_.size(); ++i)
    if (!left_alone_.contains(i) && (known_.contains(i) || !form_->is_empty(i))) names.push_back(columns_[i].name);
  return names;
}

void CsvHeader::require(std::string_view name) {
  if (find(name)) return;
  if (std::ranges::all_of(columns_, [](const Column& each) { return each.name.empty(); }))
    throw error("must name the columns, and has numbers only: the header is missing");
  const std::vector<std::string> there = names();
  for (const std::string& each : there)
    if (quantity_of(each) == quantity_of(name) || each == quantity_of(name)) throw error(each, unknown_unit(name));
  // "Time_s" for "time_s": every letter counts.
  const std::vector<std::string> like = nearest_words(name, there);
  throw error(name, like.empty() ? std::string("is missing")
                                 : fmt::format("is missing; is {} meant? Every letter of a name counts",
                                               in_quotes(one_line(like.front()))));
}

std::size_t CsvHeader::numbered(std::string_view pattern) {
  legal_.push_back(with_number(pattern, 1) + "..");
  std::size_t count = 0;
  while (ask(with_number(pattern, count + 1))) ++count;
  return count;
}

void CsvHeader::ignore(std::string_view name) {
  const bool many = name.find('#') != std::string_view::npos;
  legal_.push_back(many ? with_number(name, 1) + ".." : std::string(name));
  for (std::size_t number = 1;; ++number) {
    const std::string each = many ? with_number(name, number) : std::string(name);
    asked_for_.push_back(each);
    const std::size_t index = index_of(each);
    if (index == columns_.size()) return;
    known_.insert(index);
    if (!many) return;
  }
}

void CsvHeader::refuse_nameless(std::string_view advice) const {
  for (std::size_t i = 0; i < columns_.size(); ++i)
    if (columns_[i].name.empty() && !left_alone_.contains(i) && !others_ignored_)
      throw InputError(
          {.file = file_,
           .place = fmt::format("line {}: column {}", line(), i + 1),
           .rule = fmt::format("has no name{}{}", i == 0 ? " (a pandas index? write the file with index=False)" : "",
                               advice)});
}

void CsvHeader::finish(std::string_view advice) const {
  std::vector<std::string> missing;
  for (const std::string& asked : asked_for_)
    if (index_of(asked) == columns_.size()) missing.push_back(asked);
  std::vector<std::string> unknown;
  refuse_nameless(advice);
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const std::string& name = columns_[i].name;
    if (known_.contains(i) || left_alone_.contains(i) || others_ignored_) continue;
    for (const std::string& asked : asked_for_)
      if (quantity_of(name) == quantity_of(asked) || name == quantity_of(asked)) throw error(name, unknown_unit(asked));
    const std::string meant = did_you_mean(name, missing);
    if (!meant.empty()) throw error(name, "unknown column" + meant);
    if (!form_->is_empty(i)) unknown.push_back(columns_[i].label);
  }
  if (unknown.empty()) return;
  const bool one = unknown.size() == 1;
  throw InputError(
      {.file = file_,
       .place = fmt::format("line {}: column{} {}", line(), one ? "" : "s", fmt::join(unknown, ", ")),
       .rule = fmt::format("unknown column{}; there may be {}{}", one ? "" : "s", fmt::join(legal_, ", "), advice)});
}

// The line of the names, or where they are missing.
std::size_t CsvHeader::line() const {
  return form_->names_line > 0 ? form_->names_line : form_->rows_line;
}

InputError CsvHeader::error(std::string rule) const {
  return InputError({.file = file_, .place = fmt::format("line {}", line()), .rule = std::move(rule)});
}

InputError CsvHeader::error(std::string_view column, std::string rule) const {
  const auto found = std::ranges::find(columns_, column, &Column::name);
  return InputError(
      {.file = file_,
       .place = fmt::format("line {}: column {}", line(), found == columns_.end() ? one_line(column) : found->label),
       .rule = std::move(rule)});
}

std::optional<std::size_t> position_in(std::string_view source) noexcept {
  if (!source.starts_with('#')) return std::nullopt;
  const auto number = number_in<std::size_t>(source.substr(1));
  return number && *number > 0 ? std::optional(*number - 1) : std::nullopt;
}

}  // namespace coilwright::text
