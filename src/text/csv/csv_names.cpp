
#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <utility>

#include "coilwright/text/one_line.hpp"
#include "coilwright/text/spelling.hpp"
#include "text/csv/csv_clock.hpp"
#include "text/csv/csv_fields.hpp"

namespace coilwright::text {
namespace {

bool is_blank_row(std::string_view line) {
  return line.find_first_not_of(" \t\r\n\v\f,;") == std::string_view::npos;
}

// Without the sign of a comment, and the blanks after it.
std::string_view uncommented(std::string_view line) {
  const std::size_t start = line.find_first_not_of("#%");
  if (start == std::string_view::npos) return {};
  line.remove_prefix(start);
  return line.substr(std::min(line.find_first_not_of(" \t"), line.size()));
}

bool is_comment(std::string_view line) {
  return line.starts_with('#') || line.starts_with('%');
}

// Names that hold blanks stand two or more apart, where blanks separate.
std::vector<std::string> fields_far_apart(std::string_view line) {
  std::vector<std::string> fields;
  for (std::size_t at = 0; at < line.size();) {
    const std::size_t end = std::min({line.find("  ", at), line.find('\t', at), line.size()});
    if (end > at) fields.emplace_back(line.substr(at, end - at));
    at = std::min(line.find_first_not_of(" \t", end), line.size());
  }
  return fields;
}

std::vector<std::string> names_in(std::string_view line, std::size_t width, char separator) {
  if (is_comment(line)) line = uncommented(line);
  std::vector<std::string> names = fields_of(line, separator);
  if (separator == ' ' && names.size() != width)
    if (auto apart = fields_far_apart(line); apart.size() == width) names = std::move(apart);
  for (std::string& name : names) {
    name = in_utf8(name);
    std::ranges::replace(name, '\n', ' ');  // two lines in a cell of a spreadsheet
    if (stamp_in(name)) name.clear();       // a terminal's, in front of the names
  }
  return names;
}

// Whether the text is a unit as instruments write it below a name: "(ms)", "Volt", "s".
bool is_unit_row_word(std::string word) {
  std::erase_if(word, [](char letter) { return std::string_view("()[]{} ").find(letter) != std::string_view::npos; });
  for (char& letter : word) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  constexpr std::string_view words =
      "s|sec|secs|second|seconds|ms|us|\xc2\xb5s|\xce\xbcs|ns|v|mv|volt|volts|a|ma|amp|amps|ampere|deg|\xc2\xb0|degree|"
      "degrees|rad|n|nm|nmm|mm|m|px|pixel|sequence|degc|\xc2\xb0"
      "c";
  return is_one_of(word, words);
}

bool is_unit_row(const std::vector<std::string>& fields) {
  std::size_t units = 0;
  for (const std::string& field : fields) {
    if (field.empty() || number_of(field, '.')) continue;
    if (!is_unit_row_word(field)) return false;
    ++units;
  }
  return units > 0;
}

std::string unit_in_brackets(const std::string& unit) {
  const bool has = unit.starts_with('(') || unit.starts_with('[') || unit.starts_with('{');
  return has ? unit : "(" + unit + ")";
}

}  // namespace

std::string in_utf8(std::string_view text) {
  // one_line() writes \x.. for bytes that are no UTF-8, and so tells one from the other.
  const std::string shown = one_line(text, 6 * text.size() + 8);
  const bool high =
      std::ranges::any_of(text, [](char letter) { return (static_cast<unsigned char>(letter) & 0x80U) != 0; });
  if (!high || shown.find("\\x") == std::string::npos) return std::string(text);
  std::string out;
  for (const char letter : text) {
    const auto byte = static_cast<unsigned char>(letter);
    if (byte < 0x80) {
      out += letter;
    } else {
      out += static_cast<char>(0xC0U | (byte >> 6U));
      out += static_cast<char>(0x80U | (byte & 0x3FU));
    }
  }
  return out;
}

ColumnNames find_names(const std::vector<NamesLine>& above, std::size_t width, char separator) {
  std::optional<std::size_t> at;
  for (const bool comments : {false, true}) {
    for (std::size_t i = above.size(); i > 0 && !at; --i)
      if (!is_blank_row(above[i - 1].text) && is_comment(above[i - 1].text) == comments) at = i - 1;
    if (!at) continue;
    const std::vector<std::string> names = names_in(above[*at].text, width, separator);
    // A number among few names is a setting, not a name.
    const bool settings = width == 2 && names.size() == 2 && number_of(names[1], separator == ',' ? '.' : ',');
    const bool enough = width == 1 ? names.size() == 1 : 2 * names.size() >= width && names.size() > 1;
    if (enough && !settings) break;
    at.reset();
  }
  if (!at) return {.names = {}, .line = 0, .first = above.size()};
  ColumnNames out{.names = names_in(above[*at].text, width, separator), .line = above[*at].number, .first = *at};
  const auto row_above = [&](std::size_t i) -> std::optional<std::size_t> {
    while (i > 0 && is_blank_row(above[i - 1].text)) --i;
    return i > 0 ? std::optional(i - 1) : std::nullopt;
  };
  auto upper = row_above(*at);
  if (!upper) return out;
  if (out.names.front() == "coords") {
    for (; upper; upper = row_above(*upper)) {
      const std::vector<std::string> parts = names_in(above[*upper].text, width, separator);
      if (parts.size() != out.names.size()) break;
      out.first = *upper;
      if (parts.front() == "scorer") break;  // the network's name, in all columns
      for (std::size_t i = 1; i < parts.size(); ++i) out.names[i] = parts[i] + " " + out.names[i];
    }
    return out;
  }
  std::vector<std::string> names = names_in(above[*upper].text, width, separator);
  for (std::vector<std::string>* row : {&names, &out.names})
    while (row->size() > width && row->back().empty()) row->pop_back();
  if (is_unit_row(out.names) && names.size() == out.names.size() && !is_unit_row(names)) {
    out.first = *upper;
    for (std::size_t i = 0; i < names.size(); ++i)
      out.names[i] = out.names[i].empty() ? names[i] : names[i] + " " + unit_in_brackets(out.names[i]);
  }
  return out;
}

}  // namespace coilwright::text
