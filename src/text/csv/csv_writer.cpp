#include "coilwright/text/csv/csv_writer.hpp"

#include <csv.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <ostream>
#include <set>
#include <stdexcept>
#include <utility>

#include "text/csv/csv_fields.hpp"

namespace coilwright::text {
namespace {

// RFC 4180: quotes only around what would otherwise be misread.
void append_text(std::string& line, std::string_view content) {
  std::string guarded;
  if (begins_a_formula(content)) guarded.append(1, '\'').append(content);
  const std::string_view text = guarded.empty() ? content : guarded;
  const bool plain = text.find_first_of(",\"\r\n") == std::string_view::npos && !text.starts_with(' ') &&
                     !text.ends_with(' ') && !text.starts_with('\t') && !text.ends_with('\t');
  if (plain) {
    line += text;
    return;
  }
  const std::size_t start = line.size();
  line.resize(start + 2 * text.size() + 2);  // each character may be a quote, which is doubled
  line.resize(start + csv_write(line.data() + start, line.size() - start, text.data(), text.size()));
}

}  // namespace

CsvWriter::CsvWriter(std::ostream& out, std::vector<std::string> columns) : out_(&out), columns_(std::move(columns)) {
  if (columns_.empty()) throw std::invalid_argument("columns must not be empty");
  std::set<std::string_view> seen;
  for (const std::string& name : columns_) {
    if (name.empty()) throw std::invalid_argument("a column must have a name");
    if (!seen.insert(name).second) throw std::invalid_argument(fmt::format("column {} must not be there twice", name));
    if (!line_.empty()) line_ += ',';
    append_text(line_, name);
  }
  write_line();
}

void CsvWriter::row(std::span<const CsvCell> cells) {
  if (cells.size() != columns_.size()) {
    throw std::invalid_argument(
        fmt::format("a row must have {} cells, one a column; got {}", columns_.size(), cells.size()));
  }
  line_.clear();
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i > 0) line_ += ',';
    append(cells[i], i);
  }
  write_line();
}

void CsvWriter::row(std::span<const double> values) {
  const std::vector<CsvCell> cells(values.begin(), values.end());
  row(cells);
}

void CsvWriter::append(const CsvCell& cell, std::size_t column) {
  if (const auto* number = std::get_if<double>(&cell.content_)) {
    if (!std::isfinite(*number)) {
      throw std::invalid_argument(fmt::format("column {} must be finite; got {}", columns_[column], *number));
    }
    fmt::format_to(std::back_inserter(line_), "{}", *number);
  } else if (const auto* integer = std::get_if<std::int64_t>(&cell.content_)) {
    fmt::format_to(std::back_inserter(line_), "{}", *integer);
  } else if (const auto* text = std::get_if<std::string_view>(&cell.content_)) {
    append_text(line_, *text);
  }
}

void CsvWriter::write_line() {
  line_ += '\n';
  out_->write(line_.data(), static_cast<std::streamsize>(line_.size()));
}

}  // namespace coilwright::text
