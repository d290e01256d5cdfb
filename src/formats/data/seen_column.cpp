#include "formats/data/seen_column.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "coilwright/text/csv/csv_texts.hpp"

namespace coilwright::formats {
namespace {

bool looks_like_stamp(const std::string& field) {
  return std::ranges::count(field, ':') >= 1 && field.find_first_of("0123456789") != std::string::npos;
}

}  // namespace

SeenColumn seen_column(const text::CsvForm& form, std::size_t column) {
  const std::string& name = form.names[column];
  const bool unique = !name.empty() && std::ranges::count(form.names, name) == 1;
  SeenColumn out{.source = unique ? name : fmt::format("#{}", column + 1), .words = words_of(name)};
  std::size_t filled = 0, stamps = 0;
  constexpr std::size_t sparse = 10;  // an instrument's settings stand beside its first rows
  for (const auto& row : form.sample) {
    if (column >= row.size() || row[column].empty()) continue;
    std::string field = row[column];
    ++filled;
    if (form.decimal == ',') std::ranges::replace(field, ',', '.');
    if (field.starts_with('+')) field.erase(0, 1);
    if (field.ends_with(" sec")) field.resize(field.size() - 4);  // a duration of MATLAB
    if (const auto value = text::number_in(field))
      out.values.push_back(*value);
    else if (looks_like_stamp(field))
      ++stamps;
  }
  out.stamps = 2 * stamps > filled;
  out.text = (!out.stamps && 2 * out.values.size() <= filled) || sparse * filled < form.sample.size();
  out.increases = out.values.size() > 1 && std::ranges::is_sorted(out.values) && out.values.front() < out.values.back();
  out.counts = out.ticks = out.values.size() > 2;
  for (std::size_t i = 1; i < out.values.size(); ++i) {
    out.counts = out.counts && out.values[i] == out.values[i - 1] + 1.0;
    out.ticks = out.ticks && out.values[i] > out.values[i - 1] && out.values[i] == std::floor(out.values[i]);
  }
  return out;
}

std::string clock_unit(const std::vector<double>& values) {
  const double first = values.empty() ? 0.0 : values.front();
  if (first > 1e17) return "ns";
  if (first > 1e14) return "us";
  if (first > 1e11) return "ms";
  const double step = values.size() > 1 ? (values.back() - first) / static_cast<double>(values.size() - 1) : 0.0;
  const bool whole = std::ranges::all_of(values, [](double value) { return value == std::floor(value); });
  return whole && step > 100.0 && first < 1e8 ? "us" : whole && step >= 1.0 && first < 1e8 ? "ms" : "s";
}

}  // namespace coilwright::formats
