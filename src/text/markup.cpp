#include "coilwright/text/markup.hpp"

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

std::string_view class_of_column(const std::vector<std::vector<std::string>>& rows, std::size_t column) {
  bool numbers = false;
  for (const std::vector<std::string>& row : rows) {
    const std::string& cell = row.at(column);
    if (cell.find_first_not_of("0123456789.-+e") != std::string::npos) return "";
    numbers = numbers || !cell.empty();
  }
  return numbers ? " class=\"number\"" : "";
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
