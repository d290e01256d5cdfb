#include "coilwright/text/csv/csv_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "coilwright/text/one_line.hpp"
#include "coilwright/units/unit.hpp"
#include "text/csv/csv_parser.hpp"
#include "text/csv/csv_table_builder.hpp"
#include "text/input_file.hpp"

namespace coilwright::text {
namespace {

constexpr std::size_t few = 20;  // lines that a person deletes

}  // namespace

std::size_t CsvTable::index_of(std::string_view quantity) const {
  for (std::size_t i = 0; i < names_.size(); ++i)
    if (units::quantity_of(names_[i]) == quantity) return i;
  throw std::out_of_range(fmt::format("quantity must be a column that was asked for; got {}", quantity));
}

std::span<const double> CsvTable::column(std::string_view quantity) const {
  return columns_[index_of(quantity)];
}

void CsvTable::require_increasing(std::string_view quantity, std::string_view of_records,
                                  std::string_view of_rate) const {
  const auto values = column(quantity);
  std::vector<std::uint32_t> repeats, restarts;  // lines
  std::size_t first = 0;                         // row at fault
  bool disorder = false;
  double latest = values.empty() ? 0.0 : values.front();
  for (std::size_t row = 1; row < values.size(); ++row) {
    if (values[row] > values[row - 1]) {
      latest = std::max(latest, values[row]);
      continue;
    }
    const bool back = values[row] < values[row - 1];
    if (first == 0 || (back && restarts.empty())) first = row;
    (back ? restarts : repeats).push_back(lines_[row]);
    // Soon beyond what it was: rows out of order, and no new start.
    disorder = disorder || (back && values[std::min(row + 3, values.size() - 1)] > latest);
  }
  if (first == 0) return;
  const std::string& key = name(quantity);
  const std::string rule = fmt::format("must exceed the value before it ({})", units::from_si(values[first - 1], key));
  if (disorder) throw error(quantity, first, rule + "; the rows are out of order: sort them by this column");
  if (values.size() > 2 && restarts.size() + 1 == values.size())
    throw error(
        quantity, first,
        rule + "; the clock runs backwards: sort the rows by this column, or change its sign where that is wrong");
  constexpr double counter = 4294967296.0;  // of a microcontroller's 32 bits
  if (restarts.size() == 1 && units::from_si(values[first - 1], key) > 0.99 * counter &&
      units::from_si(values[first - 1], key) < counter && units::from_si(values[first], key) < 0.01 * counter)
    throw error(quantity, first,
                fmt::format("{}; its counter of 32 bits began again: add {:.0f} to it from here on", rule, counter));
  if (!restarts.empty()) {
    const std::string where = restarts.size() == 1    ? "here"
                              : restarts.size() > few ? fmt::format("{} times", restarts.size())
                                                      : fmt::format("in the lines {}", fmt::join(restarts, ", "));
    throw error(
        quantity, first,
        fmt::format("{}; the clock starts again {}, so the file holds {} records: make a file of each, with the "
                    "line of names{}",
                    rule, where, restarts.size() + 1, of_records));
  }
  if (repeats.size() > few || (repeats.size() > 3 && 5 * repeats.size() > values.size()))
    throw error(
        quantity, first,
        fmt::format("{}; {} of {} rows repeat a time, as the clock is too coarse: if the rows are evenly spaced, "
                    "they are {:.6g} a second by the first and the last{}",
                    rule, repeats.size(), values.size(),
                    static_cast<double>(values.size() - 1) / (values.back() - values.front()), of_rate));
  throw error(quantity, first,
              fmt::format("{}; delete {} {}, which repeat{} the time of the row above", rule,
                          repeats.size() == 1 ? "line" : "the lines", fmt::join(repeats, ", "),
                          repeats.size() == 1 ? "s" : ""));
}

InputError CsvTable::error(std::string_view quantity, std::size_t row, std::string rule) const {
  const std::size_t index = index_of(quantity);
  return InputError({.file = file_,
                     .place = fmt::format("line {}: column {}", lines_.at(row), labels_[index]),
                     .rule = std::move(rule),
                     .value = fmt::format("{}", units::from_si(columns_[index].at(row), names_[index]))});
}

CsvTable parse_csv(std::string_view text, std::string file, const std::function<void(CsvHeader&)>& ask,
                   const CsvLayout& layout) {
  const CsvForm form = find_csv_form(text.substr(0, csv_form_size), text.size() <= csv_form_size, file, layout);
  CsvTableBuilder builder(file, form, layout, ask);
  CsvParser parser(std::move(file), [&](auto fields, std::size_t line) { builder.take(fields, line); },
                   {.separator = form.separator, .first_line = form.rows_line, .arrows = form.arrows});
  if (form.rows_line > 0) parser.feed(text.substr(form.rows_at));
  parser.finish();
  return builder.finish();
}

CsvTable read_csv(const std::filesystem::path& path, const std::function<void(CsvHeader&)>& ask,
                  const CsvLayout& layout) {
  InputFile file(path, csv_size_limit);
  std::vector<char> block(csv_form_size);
  auto filled = file.read(block);
  const CsvForm form = find_csv_form({filled.data(), filled.size()}, filled.size() < block.size(), file.name(), layout);
  CsvTableBuilder builder(file.name(), form, layout, ask);
  CsvParser parser(file.name(), [&](auto fields, std::size_t line) { builder.take(fields, line); },
                   {.separator = form.separator, .first_line = form.rows_line, .arrows = form.arrows});
  if (form.rows_line > 0) parser.feed({filled.data() + form.rows_at, filled.size() - form.rows_at});
  for (filled = file.read(block); !filled.empty(); filled = file.read(block))
    parser.feed({filled.data(), filled.size()});
  parser.finish();
  return builder.finish();
}

}  // namespace coilwright::text
