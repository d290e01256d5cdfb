#include "page/front.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "page/result_words.hpp"

namespace coilwright::page {
namespace {

using sizing::StudyVariable;

bool is_margin(std::string_view name) {
  return name.find("_max_margin") != std::string_view::npos || name.find("_min_margin") != std::string_view::npos;
}

std::optional<double> coordinate_of(const StudyVariable& variable, const std::string& field) {
  if (const std::optional<double> number = text::number_in(field)) return sizing::coordinate_of(variable, *number);
  return sizing::coordinate_of(variable, std::string_view(field));
}

// Those of the first of some designs.
std::vector<std::string> variables_of(const text::Node& designs) {
  const std::vector<text::Node> all = designs.elements();
  return all.empty() ? std::vector<std::string>{} : member_of(all.front(), "variables").keys();
}

FrontTable designs_in(const std::filesystem::path& file, const text::Node& result, std::vector<std::string> variables,
                      text::Length objectives) {
  FrontTable designs{.texts = read_table(file),
                     .variables = std::move(variables),
                     .objectives = {},
                     .largest = {},
                     .margins = {},
                     .quantities = {}};
  for (Objective& each : objectives_of(result, objectives)) {
    designs.objectives.push_back(std::move(each.name));
    designs.largest.push_back(each.largest);
  }
  const auto is_among = [](const std::vector<std::string>& names, const std::string& name) {
    return std::ranges::find(names, name) != names.end();
  };
  for (const std::string& name : designs.texts.names()) {
    if (is_margin(name))
      designs.margins.push_back(name);
    else if (!is_among(designs.variables, name) && !is_among(designs.objectives, name))
      designs.quantities.push_back(name);
  }
  return designs;
}

}  // namespace

FrontTable read_front(const std::filesystem::path& folder, const text::Node& result) {
  return designs_in(folder / "front.csv", result, variables_of(member_of(result, "ends")), text::Length::from_to(2, 3));
}

FrontTable read_leaders(const std::filesystem::path& folder, const text::Node& result) {
  return designs_in(folder / "best.csv", result, variables_of(member_of(result, "best")), text::Length::at_least(1));
}

std::vector<std::string> shown_columns(const FrontTable& front) {
  std::vector<std::string> out = front.objectives;
  for (const std::string& name : front.variables)
    if (std::ranges::find(out, name) == out.end()) out.push_back(name);
  return out;
}

std::vector<std::string> shown_fields(const FrontTable& front, std::size_t row, std::span<const std::string> columns) {
  std::vector<std::string> out;
  for (const std::string& name : columns) {
    const std::string& field = front.texts.column(name)[row];
    const std::optional<double> number = text::number_in(field);
    out.push_back(number ? report::short_number(*number) : field);
  }
  return out;
}

text::Json json_of(const std::string& field) {
  if (field.empty()) return {};
  if (const std::optional<double> number = text::number_in(field)) return *number;
  return field;
}

std::optional<std::vector<double>> point_of(const sizing::Study& study, const FrontTable& front, std::size_t row) {
  std::vector<double> point;
  for (const StudyVariable& variable : study.variables) {
    const std::string name = sizing::name_of(variable);
    if (!front.texts.has(name)) return std::nullopt;
    const std::optional<double> coordinate = coordinate_of(variable, front.texts.column(name)[row]);
    if (!coordinate) return std::nullopt;
    point.push_back(*coordinate);
  }
  return point;
}

std::vector<std::size_t> even_choice(std::size_t count, std::size_t most) {
  std::vector<std::size_t> rows;
  if (count <= most) {
    for (std::size_t i = 0; i < count; ++i) rows.push_back(i);
    return rows;
  }
  for (std::size_t i = 0; i < most; ++i) rows.push_back(most == 1 ? 0 : i * (count - 1) / (most - 1));
  return rows;
}

}  // namespace coilwright::page
