#include "text/csv/csv_fields.hpp"

#include <csv.h>

#include <algorithm>
#include <array>
#include <new>

#include "coilwright/text/number.hpp"
#include "text/csv/csv_clock.hpp"

namespace coilwright::text {
namespace {

constexpr std::string_view blanks = " \t";

void take_field(void* field, std::size_t size, void* fields) {
  static_cast<std::vector<std::string>*>(fields)->emplace_back(without_guard({static_cast<const char*>(field), size}));
}

}  // namespace

std::string cut_at_blanks(std::string_view line) {
  std::string cut;
  bool quoted = false;
  bool pending = false;
  for (const char letter : line) {
    if (letter == '"') quoted = !quoted;
    const bool blank = !quoted && blanks.find(letter) != std::string_view::npos;
    const bool end = letter == '\n' || letter == '\r';
    if (!blank && !end && pending && !cut.empty()) cut += blank_cut;
    pending = blank;
    if (!blank) cut += letter;
  }
  return cut;
}

std::string without_arrow(std::string_view line, char separator) {
  constexpr std::string_view arrow = " -> ";
  std::string out(line);
  const std::size_t at = line.find(arrow);
  if (at != std::string_view::npos && stamp_in(line.substr(0, at))) out.replace(at, arrow.size(), 1, separator);
  return out;
}

std::vector<std::string> fields_of(std::string_view line, char separator) {
  std::vector<std::string> fields;
  csv_parser parser{};
  if (csv_init(&parser, 0) != 0) throw std::bad_alloc();
  const bool blank = separator == ' ';
  const std::string plain = without_arrow(line, separator);
  const std::string cut = blank ? cut_at_blanks(plain) : plain;
  csv_set_delim(&parser, static_cast<unsigned char>(blank ? blank_cut : separator));
  csv_parse(&parser, cut.data(), cut.size(), take_field, nullptr, &fields);
  csv_fini(&parser, take_field, nullptr, &fields);
  const bool has_memory = csv_error(&parser) != CSV_ENOMEM;
  csv_free(&parser);
  if (!has_memory) throw std::bad_alloc();
  return fields;
}

bool begins_a_formula(std::string_view text) noexcept {
  const std::size_t first = text.find_first_not_of('\'');
  return first != std::string_view::npos && std::string_view("=+-@\t\r\n").find(text[first]) != std::string_view::npos;
}

std::string_view without_guard(std::string_view field) noexcept {
  if (field.starts_with('\'') && begins_a_formula(field)) field.remove_prefix(1);
  return field;
}

bool is_absent(std::string_view field) noexcept {
  constexpr std::array<std::string_view, 9> words = {"", "nan", "NaN", "NAN", "NA", "N/A", "#N/A", "null", "-"};
  return std::ranges::find(words, field) != words.end();
}

std::optional<double> number_of(std::string_view field, char decimal) noexcept {
  if (field.starts_with('+') && !field.starts_with("+-")) field.remove_prefix(1);
  std::array<char, 64> rewritten{};
  constexpr std::string_view minus_sign = "\xe2\x88\x92";  // as editors of text write it
  const bool negative = field.starts_with(minus_sign);
  if (negative) field.remove_prefix(minus_sign.size() - 1);
  const std::size_t comma = decimal == '.' ? std::string_view::npos : field.find(decimal);
  const std::size_t exponent = field.find('D');
  if (negative || comma != std::string_view::npos || exponent != std::string_view::npos) {
    if (field.size() > rewritten.size()) return std::nullopt;
    if (comma != std::string_view::npos && field.find('.') != std::string_view::npos) return std::nullopt;
    std::ranges::copy(field, rewritten.begin());
    if (negative) rewritten[0] = '-';
    if (comma != std::string_view::npos) rewritten[comma] = '.';
    if (exponent != std::string_view::npos) rewritten[exponent] = 'E';
    field = {rewritten.data(), field.size()};
  }
  return number_in(field);
}

}  // namespace coilwright::text
