#include "page/table_html.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <string_view>
#include <vector>

#include "coilwright/text/markup.hpp"

namespace coilwright::page {
namespace {

using text::escaped;

bool is_number(std::string_view cell) {
  return !cell.empty() && cell.find_first_not_of("0123456789.-+e") == std::string_view::npos;
}

// Columns of numbers, and of nothing else, are set to the right.
std::string_view alignment(const Table& table, std::size_t column) {
  bool numbers = false;
  for (const std::vector<std::string>& row : table.rows) {
    if (is_number(row.at(column)))
      numbers = true;
    else if (!row.at(column).empty())
      return "";
  }
  return numbers ? " class=\"number\"" : "";
}

}  // namespace

std::string table_html(const TableBlock& block) {
  const Table& table = block.table;
  std::string out = fmt::format(
      "<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"{0}\">\n<table>\n"
      "<caption>{0}</caption>\n<thead><tr>",
      escaped(block.caption));
  std::vector<std::string_view> alignments;
  for (std::size_t i = 0; i < table.header.size(); ++i) {
    alignments.push_back(alignment(table, i));
    out += fmt::format("<th scope=\"col\"{}>{}</th>", alignments.back(), escaped(table.header[i]));
  }
  out += "</tr></thead>\n<tbody>\n";
  for (const std::vector<std::string>& row : table.rows) {
    out += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) out += fmt::format("<td{}>{}</td>", alignments.at(i), escaped(row[i]));
    out += "</tr>\n";
  }
  return out + "</tbody>\n</table>\n</div>\n";
}

}  // namespace coilwright::page
