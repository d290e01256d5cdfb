#include "coilwright/report/simulation/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "coilwright/text/one_line.hpp"

namespace coilwright::report {
namespace {

constexpr std::size_t longest_cell = 2000;

}  // namespace

void TextTable::row(std::vector<std::string> cells) {
  for (std::string& cell : cells) cell = text::one_line(cell, longest_cell);  // of a file that anybody may have written
  rows_.push_back(std::move(cells));
}

std::string TextTable::text(std::size_t indent, std::vector<Align> align) const {
  std::vector<std::size_t> widths;
  for (const auto& row : rows_) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  align.resize(widths.size(), Align::right);
  std::string text;
  for (const auto& row : rows_) {
    std::string line(indent, ' ');
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (i > 0) line += "  ";
      line +=
          align[i] == Align::left ? fmt::format("{:<{}}", row[i], widths[i]) : fmt::format("{:>{}}", row[i], widths[i]);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + '\n';
  }
  return text;
}

std::string short_number(double value) {
  return fmt::format("{:.6g}", value);
}

std::string signed_number(double value) {
  return fmt::format("{:+.4g}", value);
}

std::string readable_unit(std::string_view suffix) {
  if (suffix == "pct") return "%";
  std::string text(suffix);
  std::ranges::replace(text, '_', '/');
  return text;
}

}  // namespace coilwright::report
