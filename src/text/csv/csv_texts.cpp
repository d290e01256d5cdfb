#include "coilwright/text/csv/csv_texts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "coilwright/text/csv/csv_table.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/text/one_line.hpp"
#include "text/csv/csv_parser.hpp"
#include "text/input_file.hpp"

namespace coilwright::text {
namespace {

using Keep = std::function<bool(std::string_view name)>;
using OnRow = std::function<void(std::span<const std::string_view> fields, std::size_t line)>;

std::string place_of(std::size_t line, std::string_view column) {
  return fmt::format("line {}: column {}", line, column);
}

constexpr std::size_t streamed_size_limit = 64'000'000'000;  // bytes of text, of which a row at a time is held

// Names of the columns kept.
std::vector<std::string> read_rows(const std::filesystem::path& path, std::size_t size_limit, const Keep& keep,
                                   const OnRow& on_row) {
  InputFile file(path, size_limit);
  std::vector<std::string> names;
  std::vector<std::size_t> kept;
  std::vector<std::string_view> row;
  std::size_t width = 0;
  CsvParser parser(file.name(), [&](std::span<const std::string_view> fields, std::size_t line) {
    if (width == 0) {
      width = fields.size();
      for (std::size_t i = 0; i < width; ++i) {
        if (!keep(fields[i])) continue;
        kept.push_back(i);
        names.emplace_back(fields[i]);
      }
      return;
    }
    if (fields.size() != width)
      throw InputError({.file = file.name(),
                        .place = fmt::format("line {}", line),
                        .rule = fmt::format("must have as many fields as the header, {}", width),
                        .value = fmt::format("{}", fields.size())});
    row.clear();
    for (const std::size_t i : kept) row.push_back(fields[i]);
    on_row(row, line);
  });
  std::array<char, 1 << 16> buffer{};
  char last = '\n';
  while (true) {
    const std::span<char> read = file.read(buffer);
    if (!read.empty()) last = read.back();
    parser.feed({read.data(), read.size()});
    if (read.size() < buffer.size()) break;
  }
  parser.finish();
  if (width == 0) throw InputError({.file = file.name(), .rule = "is empty: it must have a header"});
  if (last != '\n') throw InputError({.file = file.name(), .rule = "must end with a whole line: it was cut"});
  return names;
}

}  // namespace

bool CsvTexts::has(std::string_view name) const {
  return index_of(name).has_value();
}

std::optional<std::size_t> CsvTexts::index_of(std::string_view name) const {
  const auto found = std::ranges::find(names_, name);
  if (found == names_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - names_.begin());
}

const std::vector<std::string>& CsvTexts::column(std::string_view name) const {
  const std::optional<std::size_t> index = index_of(name);
  if (!index) throw error(fmt::format("must have the column {}", name));
  return columns_[*index];
}

std::optional<double> CsvTexts::number(std::string_view name, std::size_t row) const {
  return number_or_nothing(column(name).at(row), file_, lines_.at(row), name);
}

double CsvTexts::required_number(std::string_view name, std::size_t row) const {
  if (const std::optional<double> value = number(name, row)) return *value;
  throw error(name, row, "must be a number");
}

InputError CsvTexts::error(std::string rule) const {
  return InputError({.file = file_, .rule = std::move(rule)});
}

InputError CsvTexts::error(std::string_view name, std::size_t row, std::string rule) const {
  return InputError({.file = file_,
                     .place = place_of(lines_.at(row), name),
                     .rule = std::move(rule),
                     .value = in_quotes(column(name).at(row))});
}

std::optional<double> number_or_nothing(std::string_view field, const std::string& file, std::size_t line,
                                        std::string_view column) {
  if (field.empty()) return std::nullopt;
  if (const std::optional<double> value = number_in(field)) return value;
  throw InputError(
      {.file = file, .place = place_of(line, column), .rule = "must be a number", .value = in_quotes(field)});
}

std::vector<std::string> for_each_csv_row(const std::filesystem::path& path, const Keep& keep, const OnRow& on_row) {
  return read_rows(path, streamed_size_limit, keep, on_row);
}

CsvTexts read_csv_texts(const std::filesystem::path& path, const Keep& keep) {
  CsvTexts out;
  out.file_ = path.string();
  out.names_ = read_rows(path, csv_size_limit, keep, [&](std::span<const std::string_view> fields, std::size_t line) {
    out.columns_.resize(fields.size());
    for (std::size_t i = 0; i < fields.size(); ++i) out.columns_[i].emplace_back(fields[i]);
    out.lines_.push_back(static_cast<std::uint32_t>(line));
  });
  out.columns_.resize(out.names_.size());
  return out;
}

}  // namespace coilwright::text
