#include "coilwright/text/csv/csv_texts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <span>
#include <stdexcept>
#include <system_error>

#include "coilwright/text/csv/csv_table.hpp"
#include "coilwright/text/input_error.hpp"
#include "text/csv/csv_parser.hpp"
#include "text/input_file.hpp"

namespace coilwright::text {

bool CsvTexts::has(std::string_view name) const {
  return index_of(name).has_value();
}

std::optional<std::size_t> CsvTexts::index_of(std::string_view name) const {
  const auto found = std::ranges::find(names_, name);
  if (found == names_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - names_.begin());
}

const std::vector<std::string>& CsvTexts::column(std::string_view name) const {
  const std::optional<std::size_t> index = index_of(name);
  if (!index) throw std::out_of_range(fmt::format("no column {} was kept", name));
  return columns_[*index];
}

std::optional<double> CsvTexts::number(std::string_view name, std::size_t row) const {
  return number_in(column(name).at(row));
}

std::optional<double> number_in(std::string_view field) noexcept {
  double value{};
  const char* end = field.data() + field.size();
  const auto [stop, status] = std::from_chars(field.data(), end, value);
  if (status != std::errc() || stop != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

CsvTexts read_csv_texts(const std::filesystem::path& path, const std::function<bool(std::string_view name)>& keep) {
  InputFile file(path, csv_size_limit);
  CsvTexts out;
  std::vector<std::size_t> kept;
  std::size_t width = 0;
  CsvParser parser(file.name(), [&](std::span<const std::string_view> fields, std::size_t line) {
    if (width == 0) {
      width = fields.size();
      for (std::size_t i = 0; i < width; ++i) {
        if (!keep(fields[i])) continue;
        kept.push_back(i);
        out.names_.emplace_back(fields[i]);
      }
      out.columns_.resize(kept.size());
      return;
    }
    if (fields.size() != width)
      throw InputError({.file = file.name(),
                        .place = fmt::format("line {}", line),
                        .rule = fmt::format("must have as many fields as the header, {}", width),
                        .value = fmt::format("{}", fields.size())});
    for (std::size_t i = 0; i < kept.size(); ++i) out.columns_[i].emplace_back(fields[kept[i]]);
    ++out.rows_;
  });
  std::array<char, 1 << 16> buffer{};
  while (true) {
    const std::span<char> read = file.read(buffer);
    parser.feed({read.data(), read.size()});
    if (read.size() < buffer.size()) break;
  }
  parser.finish();
  if (width == 0) throw InputError({.file = file.name(), .rule = "is empty: it must have a header"});
  return out;
}

}  // namespace coilwright::text
