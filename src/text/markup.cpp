#include "coilwright/text/markup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace coilwright::text {

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

std::string escaped_lines(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    std::size_t end = std::min(text.find_first_of("\n\t"), text.size());
    out += escaped(text.substr(0, end));
    if (end < text.size()) out += text[end++];
    text.remove_prefix(end);
  }
  return out;
}

namespace {

std::string_view class_of_column(const std::vector<std::vector<std::string>>& rows, std::size_t column) {
  bool numbers = false;
  for (const std::vector<std::string>& row : rows) {
    const std::string& cell = row.at(column);
    if (cell.find_first_not_of("0123456789.-+e") != std::string::npos) return "";
    numbers = numbers || !cell.empty();
  }
  return numbers ? " class=\"number\"" : "";
}

// Names of quantities are one long word to a browser.
std::string breakable(std::string_view name) {
  std::string out;
  for (const char letter : escaped(name)) {
    out += letter;
    if (letter == '_') out += "<wbr>";
  }
  return out;
}

// Three columns have room on the narrowest screen.
constexpr std::size_t wide = 3;

std::string table_tag(std::size_t columns, std::size_t rows) {
  constexpr std::size_t tall = 20;
  const std::string_view stack = columns > wide ? "stack" : "", lengthy = rows > tall ? "long" : "";
  if (stack.empty() && lengthy.empty()) return "<table>\n";
  return fmt::format("<table class=\"{}{}{}\">\n", stack, !stack.empty() && !lengthy.empty() ? " " : "", lengthy);
}

}  // namespace

std::string html_table(const std::vector<std::string>& header, const std::vector<std::vector<std::string>>& rows,
                       std::string_view caption) {
  std::string out = table_tag(header.size(), rows.size());
  if (!caption.empty()) out += fmt::format("<caption>{}</caption>\n", escaped(caption));
  out += "<thead><tr>";
  std::vector<std::string_view> classes;
  std::vector<std::string> labels;
  for (std::size_t i = 0; i < header.size(); ++i) {
    classes.push_back(class_of_column(rows, i));
    out += fmt::format("<th scope=\"col\"{}>{}</th>", classes.back(), breakable(header[i]));
    labels.push_back(header.size() > wide ? fmt::format(" data-label=\"{}\"", escaped(header[i])) : std::string());
  }
  out += "</tr></thead>\n<tbody>\n";
  for (const std::vector<std::string>& row : rows) {
    out += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i)
      out += fmt::format("<td{}{}>{}</td>", classes.at(i), labels[i], breakable(row[i]));
    out += "</tr>\n";
  }
  return out + "</tbody>\n</table>\n";
}

std::string script_json(std::string_view json) {
  std::string out;
  out.reserve(json.size());
  bool indented = false;
  for (const char letter : json) {
    if (letter == '\n') {
      indented = true;
    } else if (letter == '<') {
      out += "\\u003c";
    } else if (letter != ' ' || !indented) {
      indented = false;
      out += letter;
    }
  }
  return out;
}

}  // namespace coilwright::text
