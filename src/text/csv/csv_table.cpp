#include "coilwright/text/csv/csv_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include <charconv>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include "coilwright/text/one_line.hpp"
#include "coilwright/units/unit.hpp"
#include "text/csv/csv_parser.hpp"
#include "text/input_file.hpp"

namespace coilwright::text {
namespace {

// std::from_chars: no locale, no hexadecimal, no leading blanks. It reads "nan" and "inf", and takes no plus sign.
// What programs write where there was no reading.
bool is_absent(std::string_view field) {
  constexpr std::array<std::string_view, 7> words = {"", "nan", "NaN", "NAN", "NA", "null", "-"};
  return std::ranges::find(words, field) != words.end();
}

std::optional<double> finite_number(std::string_view field) {
  if (field.starts_with('+') && !field.starts_with("+-")) field.remove_prefix(1);
  double value{};
  const char* end = field.data() + field.size();
  const auto [stop, status] = std::from_chars(field.data(), end, value);
  if (status != std::errc() || stop != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

units::Unit unit_of(std::string_view name) {
  const auto split = units::split_unit(name);
  return split ? split->unit : units::Unit{};
}

}  // namespace

/// Fills a CsvTable row by row.
class CsvTableBuilder {
 public:
  CsvTableBuilder(std::string file, const std::function<void(CsvHeader&)>& ask) : ask_(ask) {
    table_.file_ = std::move(file);
  }

  void take(std::span<const std::string_view> fields, std::size_t line) {
    if (width_ == 0) {
      take_header(fields, line);
    } else {
      take_row(fields, line);
    }
  }

  [[nodiscard]] CsvTable finish() {
    if (width_ == 0) throw InputError({.file = table_.file_, .rule = "is empty: it must have a header"});
    if (table_.lines_.empty()) throw InputError({.file = table_.file_, .rule = "must have a row below its header"});
    return std::move(table_);
  }

 private:
  struct Column {
    std::string name;
    units::Unit unit;
    bool kept;
    bool left_alone;
  };

  void take_header(std::span<const std::string_view> fields, std::size_t line) {
    if (std::ranges::all_of(fields, [](std::string_view field) { return finite_number(field).has_value(); }))
      throw InputError({.file = table_.file_,
                        .place = fmt::format("line {}", line),
                        .rule = "must name the columns, and has numbers only: the header is missing"});
    CsvHeader header(table_.file_, line, {fields.begin(), fields.end()});
    ask_(header);
    header.finish();
    width_ = fields.size();
    for (std::size_t i = 0; i < width_; ++i) {
      source_.push_back({.name = header.names()[i],
                         .unit = unit_of(header.names()[i]),
                         .kept = header.keeps(i),
                         .left_alone = header.leaves_alone(i)});
      if (header.keeps(i)) table_.names_.push_back(header.names()[i]);
    }
    table_.columns_.resize(table_.names_.size());
  }

  void take_row(std::span<const std::string_view> fields, std::size_t line) {
    if (fields.size() != width_) {
      const bool decimal_commas = fields.size() > width_ && std::ranges::all_of(fields, [](std::string_view field) {
                                    return finite_number(field).has_value();
                                  });
      throw InputError({.file = table_.file_,
                        .place = fmt::format("line {}", line),
                        .rule = fmt::format("must have {} fields, as the header has{}", width_,
                                            decimal_commas ? " (are its decimals written with commas?)" : ""),
                        .value = std::to_string(fields.size())});
    }
    if ((table_.lines_.size() + 1) * table_.columns_.size() > csv_value_limit) {
      throw InputError({.file = table_.file_,
                        .place = fmt::format("line {}", line),
                        .rule = fmt::format("must not hold more than {} numbers", csv_value_limit)});
    }
    std::size_t target = 0;
    for (std::size_t i = 0; i < width_; ++i) {
      if (source_[i].left_alone) continue;
      const auto value = finite_number(fields[i]);
      if (!value) {
        throw InputError({.file = table_.file_,
                          .place = fmt::format("line {}: column {}", line, source_[i].name),
                          .rule = is_absent(fields[i]) ? "must be a finite number (delete the rows that have none)"
                                                       : "must be a finite number",
                          .value = in_quotes(fields[i])});
      }
      if (source_[i].kept) table_.columns_[target++].push_back(units::to_si(*value, source_[i].unit));
    }
    table_.lines_.push_back(static_cast<std::uint32_t>(line));
  }

  const std::function<void(CsvHeader&)>& ask_;
  std::vector<Column> source_;
  std::size_t width_{0};
  CsvTable table_;
};

std::size_t CsvTable::index_of(std::string_view quantity) const {
  for (std::size_t i = 0; i < names_.size(); ++i) {
    const auto split = units::split_unit(names_[i]);
    if ((split ? split->quantity : std::string_view(names_[i])) == quantity) return i;
  }
  throw std::out_of_range(fmt::format("quantity must be a column that was asked for; got {}", quantity));
}

std::span<const double> CsvTable::column(std::string_view quantity) const {
  return columns_[index_of(quantity)];
}

void CsvTable::require_increasing(std::string_view quantity) const {
  const auto values = column(quantity);
  for (std::size_t row = 1; row < values.size(); ++row) {
    if (values[row] > values[row - 1]) continue;
    const double before = units::from_si(values[row - 1], unit_of(names_[index_of(quantity)]));
    throw error(quantity, row, fmt::format("must exceed the value before it ({})", before));
  }
}

InputError CsvTable::error(std::string_view quantity, std::size_t row, std::string rule) const {
  const std::size_t index = index_of(quantity);
  return InputError({.file = file_,
                     .place = fmt::format("line {}: column {}", lines_.at(row), names_[index]),
                     .rule = std::move(rule),
                     .value = fmt::format("{}", units::from_si(columns_[index].at(row), unit_of(names_[index])))});
}

CsvTable parse_csv(std::string_view text, std::string file, const std::function<void(CsvHeader&)>& ask) {
  CsvTableBuilder builder(file, ask);
  CsvParser parser(std::move(file), [&](auto fields, std::size_t line) { builder.take(fields, line); });
  parser.feed(text);
  parser.finish();
  return builder.finish();
}

CsvTable read_csv(const std::filesystem::path& path, const std::function<void(CsvHeader&)>& ask) {
  InputFile file(path, csv_size_limit);
  CsvTableBuilder builder(file.name(), ask);
  CsvParser parser(file.name(), [&](auto fields, std::size_t line) { builder.take(fields, line); });
  std::vector<char> block(1 << 16);
  for (auto filled = file.read(block); !filled.empty(); filled = file.read(block)) {
    parser.feed({filled.data(), filled.size()});
  }
  parser.finish();
  return builder.finish();
}

}  // namespace coilwright::text
