#include "cli/search/list/listing.hpp"

#include <cstddef>
#include <string_view>
#include <utility>

#include "coilwright/report/simulation/text_table.hpp"

namespace coilwright::cli {
namespace {

using report::TextTable;

std::string shown(const Listing::Cell& cell) {
  if (const auto* number = std::get_if<double>(&cell)) return report::short_number(*number);
  const auto* text = std::get_if<std::string>(&cell);
  return text == nullptr || text->empty() ? "-" : *text;
}

text::Json json_of(const Listing::Cell& cell) {
  if (const auto* number = std::get_if<double>(&cell)) return *number;
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  return nullptr;
}

}  // namespace

std::string to_text(const Listing& listing) {
  TextTable table;
  table.row(listing.columns);
  std::vector<TextTable::Align> align(listing.columns.size(), TextTable::Align::right);
  for (const auto& row : listing.rows) {
    std::vector<std::string> cells;
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (std::holds_alternative<std::string>(row[i])) align[i] = TextTable::Align::left;
      cells.push_back(shown(row[i]));
    }
    table.row(std::move(cells));
  }
  return table.text(0, align);
}

text::Json to_json(const Listing& listing) {
  return text::Json::list(listing.rows, [&](const auto& row) {
    text::Json object = text::Json::object();
    for (std::size_t i = 0; i < row.size(); ++i) object.set(listing.columns[i], json_of(row[i]));
    return object;
  });
}

std::string range_in_words(const text::Rule& rule) {
  constexpr std::string_view must_be = "must be ";
  std::string words = rule.text();
  if (words.starts_with(must_be)) words.erase(0, must_be.size());
  return words;
}

}  // namespace coilwright::cli
