#include "exports/html.hpp"

#include <fmt/format.h>

namespace coilwright::exports {
namespace {

constexpr std::string_view style = R"(
@page { size: A4; margin: 15mm; }
body { font: 10.5pt/1.4 sans-serif; color: #1c2733; max-width: 180mm; margin: 0 auto; padding: 5mm; }
h1 { font-size: 18pt; margin: 0; }
h2 { font-size: 13pt; margin: 7mm 0 2mm; border-bottom: 0.3mm solid #1c2733; break-after: avoid; }
p { margin: 2mm 0; }
.from { color: #55626f; font-size: 9pt; overflow-wrap: anywhere; }
table { border-collapse: collapse; width: 100%; break-inside: avoid; }
table.long { break-inside: auto; }
th, td { text-align: left; vertical-align: top; padding: 0.8mm 2mm; border-bottom: 0.2mm solid #b9c2cb; }
th { background: #eef1f4; }
td.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
li { margin: 1.5mm 0; break-inside: avoid; }
figure { margin: 3mm 0; break-inside: avoid; }
figure svg { max-width: 100%; height: auto; }
section.page { break-before: page; }
@media print { body { padding: 0; } }
)";

bool is_number(std::string_view cell) {
  return !cell.empty() && ((cell.front() >= '0' && cell.front() <= '9') || cell.front() == '-');
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string out;
  for (const char letter : text) {
    switch (letter) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default: {
        const auto code = static_cast<unsigned char>(letter);
        out += code < 0x20 || code == 0x7f ? '?' : letter;
      }
    }
  }
  return out;
}

std::string html_table(const std::vector<std::string>& header, const std::vector<std::vector<std::string>>& rows) {
  std::string out = rows.size() > 20 ? "<table class=\"long\">\n<thead><tr>" : "<table>\n<thead><tr>";
  for (const std::string& name : header) out += fmt::format("<th>{}</th>", escaped(name));
  out += "</tr></thead>\n<tbody>\n";
  for (const std::vector<std::string>& row : rows) {
    out += "<tr>";
    for (const std::string& cell : row)
      out += fmt::format("<td{}>{}</td>", is_number(cell) ? " class=\"number\"" : "", escaped(cell));
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
