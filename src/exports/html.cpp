#include "exports/html.hpp"

#include <fmt/format.h>

#include <cstddef>

#include "coilwright/text/markup.hpp"

namespace coilwright::exports {
namespace {

using text::class_of_column;
using text::escaped;

constexpr std::string_view style = R"(
@page { size: A4; margin: 15mm; }
body { font: 9.5pt/1.35 sans-serif; color: #1c2733; max-width: 180mm; margin: 0 auto; padding: 5mm; }
h1 { font-size: 18pt; margin: 0; }
h2 { font-size: 13pt; margin: 5mm 0 1.5mm; border-bottom: 0.3mm solid #1c2733; break-after: avoid; }
p { margin: 2mm 0; }
.from { color: #55626f; font-size: 9pt; overflow-wrap: anywhere; }
table { border-collapse: collapse; width: 100%; break-inside: avoid; }
table.long { break-inside: auto; }
th, td { text-align: left; vertical-align: top; padding: 0.45mm 2mm; border-bottom: 0.2mm solid #b9c2cb; }
th { background: #eef1f4; }
th:first-child:not(.number) { min-width: 28mm; }
.number { text-align: right; font-variant-numeric: tabular-nums; }
td.number { white-space: nowrap; }
li { margin: 1mm 0; break-inside: avoid; }
figure { margin: 3mm 0; break-inside: avoid; }
figure svg { max-width: 100%; height: auto; }
section.page { break-before: page; }
@media print { body { padding: 0; } }
)";

}  // namespace

std::string html_table(const std::vector<std::string>& header, const std::vector<std::vector<std::string>>& rows) {
  std::string out = rows.size() > 20 ? "<table class=\"long\">\n<thead><tr>" : "<table>\n<thead><tr>";
  std::vector<std::string_view> classes;
  for (std::size_t i = 0; i < header.size(); ++i) {
    classes.push_back(class_of_column(rows, i));
    out += fmt::format("<th{}>{}</th>", classes.back(), escaped(header[i]));
  }
  out += "</tr></thead>\n<tbody>\n";
  for (const std::vector<std::string>& row : rows) {
    out += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) out += fmt::format("<td{}>{}</td>", classes[i], escaped(row[i]));
    out += "</tr>\n";
  }
  return out + "</tbody>\n</table>\n";
}

std::string html_list(const std::vector<std::string>& items) {
  std::string out = "<ol>\n";
  for (const std::string& item : items) out += fmt::format("<li>{}</li>\n", escaped(item));
  return out + "</ol>\n";
}

std::string html_page(std::string_view title, std::string_view body) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
      "content=\"width=device-width\">\n<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n{}</body>\n</html>\n",
      escaped(title), style, body);
}

}  // namespace coilwright::exports
