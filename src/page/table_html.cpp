#include "page/table_html.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <string_view>
#include <vector>

#include "coilwright/text/markup.hpp"

namespace coilwright::page {
namespace {

using text::class_of_column;
using text::escaped;

}  // namespace

std::string table_html(const TableBlock& block) {
  const Table& table = block.table;
  std::string out = fmt::format(
      "<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"{0}\">\n<table>\n"
      "<caption>{0}</caption>\n<thead><tr>",
      escaped(block.caption));
  std::vector<std::string_view> classes;
  for (std::size_t i = 0; i < table.header.size(); ++i) {
    classes.push_back(class_of_column(table.rows, i));
    out += fmt::format("<th scope=\"col\"{}>{}</th>", classes.back(), escaped(table.header[i]));
  }
  out += "</tr></thead>\n<tbody>\n";
  for (const std::vector<std::string>& row : table.rows) {
    out += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) out += fmt::format("<td{}>{}</td>", classes.at(i), escaped(row[i]));
    out += "</tr>\n";
  }
  return out + "</tbody>\n</table>\n</div>\n";
}

}  // namespace coilwright::page
