#include "coilwright/text/one_line.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "text/code_point.hpp"

namespace coilwright::text {

// RFC 3629, with its exclusion of overlong forms, surrogates and what lies beyond U+10FFFF.
CodePoint decode(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  if (first < 0x80) return {first, 1};
  const std::size_t bytes = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || text.size() < bytes) return {};
  std::uint32_t value = first & (0xFFu >> (bytes + 1));
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xC0u) != 0x80u) return {};
    value = (value << 6) | (byte(i) & 0x3Fu);
  }
  constexpr std::uint32_t smallest[] = {0x80, 0x800, 0x10000};
  const bool surrogate = value >= 0xD800 && value <= 0xDFFF;
  if (value < smallest[bytes - 2] || value > 0x10FFFF || surrogate) return {};
  return {value, bytes};
}

bool is_begun(std::string_view text) {
  const auto first = static_cast<unsigned char>(text.front());
  const std::size_t whole = first < 0xC2 || first > 0xF4 ? 1 : first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  return text.size() < whole &&
         std::ranges::all_of(text.substr(1), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; });
}

std::string shown_letter(std::string_view bytes) {
  const CodePoint point = decode(bytes);
  if (point.bytes == 0) return fmt::format("\\x{:02x}", static_cast<unsigned char>(bytes.front()));
  switch (point.value) {
    case '\n':
      return "\\n";
    case '\r':
      return "\\r";
    case '\t':
      return "\\t";
    default:
      break;
  }
  const bool control = point.value < 0x20 || (point.value >= 0x7F && point.value < 0xA0);
  // Line and paragraph separator, and the marks that turn the reading direction.
  const bool breaks_line = point.value == 0x2028 || point.value == 0x2029;
  const bool turns =
      (point.value >= 0x202A && point.value <= 0x202E) || (point.value >= 0x2066 && point.value <= 0x2069);
  if (control) return fmt::format("\\x{:02x}", point.value);
  if (breaks_line || turns) return fmt::format("\\u{:04x}", point.value);
  return std::string(bytes);
}

std::string one_line(std::string_view text, std::size_t longest) {
  constexpr std::string_view cut_mark = "...";
  std::string line;
  std::size_t cut = 0;  // the last place between letters that leaves room for the mark
  while (!text.empty() && line.size() <= longest) {
    if (line.size() + cut_mark.size() <= longest) cut = line.size();
    const std::size_t taken = std::max<std::size_t>(1, decode(text).bytes);
    line += shown_letter(text.substr(0, taken));
    text.remove_prefix(taken);
  }
  return line.size() <= longest ? line : line.substr(0, cut).append(cut_mark);
}

std::string in_quotes(std::string_view text, std::size_t longest) {
  return '"' + one_line(text, longest) + '"';
}

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> out;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    out.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out;
}

}  // namespace coilwright::text
