#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <utility>

#include "coilwright/text/csv/csv_table.hpp"
#include "coilwright/text/one_line.hpp"
#include "coilwright/text/spelling.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::text {
namespace {

// The closed list of measured-data/1. A unit that JSON keys may carry is unknown here when it is not in it.
constexpr std::array<std::string_view, 14> column_units = {"s",   "ms",  "A",     "V",     "N",    "Nm", "Nmm",
                                                           "deg", "rad", "deg_s", "rad_s", "degC", "m",  "mm"};

bool is_column_unit(const units::Unit& unit) {
  return std::find(column_units.begin(), column_units.end(), unit.suffix) != column_units.end();
}

// "theta1_rad" is the column that "theta1_deg" asks for.
bool answers(std::string_view name, std::string_view asked) {
  if (name == asked) return true;
  const auto present = units::split_unit(name), wanted = units::split_unit(asked);
  return present && wanted && present->quantity == wanted->quantity &&
         present->unit.dimension == wanted->unit.dimension && is_column_unit(present->unit);
}

std::string with_number(std::string_view pattern, std::size_t number) {
  const std::size_t mark = pattern.find('#');
  return fmt::format("{}{}{}", pattern.substr(0, mark), number, pattern.substr(mark + 1));
}

std::string_view quantity_of(std::string_view name) {
  const auto split = units::split_unit(name);
  return split ? split->quantity : name;
}

// What a column that is asked for may be called, each with the unit of its numbers.
std::string unknown_unit(std::string_view asked) {
  std::vector<std::string> names;
  if (const auto wanted = units::split_unit(asked))
    for (const std::string_view suffix : column_units)
      if (const std::string name = fmt::format("{}_{}", wanted->quantity, suffix); answers(name, asked))
        names.push_back(in_quotes(name));
  if (names.empty()) names.push_back(in_quotes(asked));
  return fmt::format("unknown unit; may be {}, with the numbers in that unit", fmt::join(names, " or "));
}

}  // namespace

CsvHeader::CsvHeader(std::string file, std::size_t line, std::vector<std::string> names)
    : file_(std::move(file)), line_(line), names_(std::move(names)) {
  if (names_.size() == 1 && names_.front().find_first_of(";\t|") != std::string::npos)
    throw error("must separate its columns by commas; got " + in_quotes(one_line(names_.front())));
  std::set<std::string_view> seen;
  for (const std::string& name : names_) {
    if (name.empty()) throw error("must name every column");
    if (!seen.insert(quantity_of(name)).second) throw error(name, "must not be there twice");
  }
}

std::size_t CsvHeader::index_of(std::string_view name) const {
  std::size_t i = 0;
  while (i < names_.size() && (left_alone_.contains(i) || !answers(names_[i], name))) ++i;
  return i;
}

bool CsvHeader::find(std::string_view name) {
  legal_.emplace_back(name);
  return ask(name);
}

bool CsvHeader::ask(std::string_view name) {
  asked_for_.emplace_back(name);
  const std::size_t index = index_of(name);
  if (index == names_.size()) return false;
  known_.insert(index);
  kept_.insert(index);
  return true;
}

void CsvHeader::require(std::string_view name) {
  if (find(name)) return;
  for (std::size_t i = 0; i < names_.size(); ++i) {
    if (left_alone_.contains(i)) continue;
    const std::string& each = names_[i];
    if (quantity_of(each) == quantity_of(name) || each == quantity_of(name)) {
      throw error(each, unknown_unit(name));
    }
  }
  // A name of a column ends in its unit.
  if (std::none_of(names_.begin(), names_.end(), [](const std::string& each) { return units::split_unit(each); }))
    throw error(name, fmt::format("is missing; this line must name the columns, and begins with {} (a # in front of it "
                                  "makes it a comment)",
                                  in_quotes(one_line(names_.front()))));
  // "Time_s" for "time_s": every letter counts.
  const std::vector<std::string> like = nearest_words(name, names_);
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

bool CsvHeader::leave_alone(std::string_view name) {
  const auto found = std::find(names_.begin(), names_.end(), name);
  if (found == names_.end()) return false;
  left_alone_.insert(static_cast<std::size_t>(found - names_.begin()));
  return true;
}

void CsvHeader::ignore(std::string_view name) {
  const bool many = name.find('#') != std::string_view::npos;
  legal_.push_back(many ? with_number(name, 1) + ".." : std::string(name));
  for (std::size_t number = 1;; ++number) {
    const std::string each = many ? with_number(name, number) : std::string(name);
    asked_for_.push_back(each);
    const std::size_t index = index_of(each);
    if (index == names_.size()) return;
    known_.insert(index);
    if (!many) return;
  }
}

void CsvHeader::finish(std::string_view advice) const {
  std::vector<std::string> absent;
  for (const std::string& asked : asked_for_)
    if (index_of(asked) == names_.size()) absent.push_back(asked);
  std::vector<std::string> unknown;
  for (std::size_t i = 0; i < names_.size(); ++i) {
    if (known_.contains(i) || left_alone_.contains(i)) continue;
    for (const std::string& asked : asked_for_) {
      const bool same_quantity = quantity_of(names_[i]) == quantity_of(asked) || names_[i] == quantity_of(asked);
      if (same_quantity) throw error(names_[i], unknown_unit(asked));
    }
    const std::string meant = did_you_mean(names_[i], absent);
    if (!meant.empty()) throw error(names_[i], "unknown column" + meant);
    unknown.push_back(one_line(names_[i]));
  }
  if (unknown.empty()) return;
  const bool one = unknown.size() == 1;
  throw InputError(
      {.file = file_,
       .place = fmt::format("line {}: column{} {}", line_, one ? "" : "s", fmt::join(unknown, ", ")),
       .rule = fmt::format("unknown column{}; there may be {}{}", one ? "" : "s", fmt::join(legal_, ", "), advice)});
}

InputError CsvHeader::error(std::string rule) const {
  return InputError({.file = file_, .place = fmt::format("line {}", line_), .rule = std::move(rule)});
}

InputError CsvHeader::error(std::string_view column, std::string rule) const {
  return InputError(
      {.file = file_, .place = fmt::format("line {}: column {}", line_, one_line(column)), .rule = std::move(rule)});
}

}  // namespace coilwright::text
