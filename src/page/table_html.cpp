#include "page/table_html.hpp"

#include <fmt/format.h>

#include "coilwright/text/markup.hpp"

namespace coilwright::page {

std::string table_html(const TableBlock& block) {
  return fmt::format("<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"{}\">\n{}</div>\n",
                     text::escaped(block.caption),
                     text::html_table(block.table.header, block.table.rows, block.caption));
}

}  // namespace coilwright::page
