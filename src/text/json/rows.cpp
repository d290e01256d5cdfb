#include "coilwright/text/json/rows.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>
#include <vector>

#include "coilwright/units/unit.hpp"

namespace coilwright::text {

std::optional<double> usual_of(const RowFacts& row, const std::optional<double>& in_memory) {
  if (!in_memory || row.need == Need::required) return std::nullopt;
  const double value = row.words.empty() ? units::from_memory(*in_memory, row.key) : *in_memory;
  return row.rule.allows(value) ? std::optional(value) : std::nullopt;
}

std::optional<double> value_of(ObjectReader& in, const RowFacts& row) {
  const auto node = row.need == Need::required ? in.at(row.key, row.words) : in.find(row.key);
  if (!node) return std::nullopt;
  if (!row.words.empty()) {
    std::vector<std::pair<std::string_view, double>> words;
    for (const std::string_view word : row.words) words.emplace_back(word, static_cast<double>(words.size()));
    return node->choice_among<double>(words);
  }
  if (row.whole) return node->integer<int>(row.rule);
  const auto unit = units::split_unit(row.key);
  return unit && unit->unit.offset == 0.0 ? node->quantity(row.rule) : node->number(row.rule);
}

Json schema_of(const RowFacts& row, const std::optional<double>& usual) {
  Json out = Json::object({{"description", fmt::format("{}.", row.meaning)}});
  const auto otherwise = usual_of(row, usual);
  if (!row.words.empty()) {
    out.set("enum", Json::list(row.words));
    if (otherwise) out.set("default", row.words[static_cast<std::size_t>(*otherwise)]);
    return out;
  }
  out.set("type", row.whole ? "integer" : "number");
  const auto bound = [&](double end, const char* inclusive, const char* exclusive) {
    if (std::isfinite(end)) out.set(row.rule.allows(end) ? inclusive : exclusive, end);
  };
  bound(row.rule.lower(), "minimum", "exclusiveMinimum");
  bound(row.rule.upper(), "maximum", "exclusiveMaximum");
  if (otherwise) out.set("default", *otherwise);
  return out;
}

}  // namespace coilwright::text
