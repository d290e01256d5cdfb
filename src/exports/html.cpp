#include "exports/html.hpp"

#include <fmt/format.h>

#include "coilwright/text/markup.hpp"

namespace coilwright::exports {
namespace {

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
@media screen and (max-width: 44rem) {
  table.stack, .stack tbody, .stack tr, .stack td { display: block; }
  .stack thead { display: none; }
  .stack tr { border-bottom: 0.4mm solid #1c2733; padding: 1mm 0; }
  .stack td { border: 0; padding: 0.3mm 0; overflow-wrap: anywhere; text-align: left; }
  td.number { white-space: normal; }
  .stack td:empty { display: none; }
  .stack td::before { content: attr(data-label) ": "; color: #55626f; }
  td, th { overflow-wrap: anywhere; }
  th:first-child:not(.number) { min-width: 0; }
}
@media print { body { padding: 0; } }
)";

}  // namespace

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
