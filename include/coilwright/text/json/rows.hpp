#pragma once

#include <string>

#include "coilwright/text/json/json.hpp"
#include "coilwright/text/json/object_reader.hpp"
#include "coilwright/text/row.hpp"

namespace coilwright::text {

/// What a file says of a row's number, SI (degC), or the place of a row's word; absent where it says nothing and need
/// not.
[[nodiscard]] std::optional<double> value_of(ObjectReader& in, const RowFacts& row);

/// The schema of a row's number, of which a thing has `usual` by itself.
[[nodiscard]] Json schema_of(const RowFacts& row, const std::optional<double>& usual);

/// A thing with what a file says of its numbers; what it does not say stays as it is in `thing`.
template <class Thing>
[[nodiscard]] Thing read_rows(ObjectReader& in, std::type_identity_t<std::span<const Row<Thing>>> rows, Thing thing) {
  for (const Row<Thing>& row : rows)
    if (const auto value = value_of(in, row)) row.set(thing, *value);
  return thing;
}

/// An object with the thing's numbers, each in the unit of its key: read_rows() of it is the thing again, to rounding.
template <class Thing>
[[nodiscard]] Json rows_json(const Thing& thing, std::type_identity_t<std::span<const Row<Thing>>> rows) {
  Json out = Json::object();
  for (const Row<Thing>& row : rows) {
    const auto value = row.get(thing);
    if (!value) continue;
    if (!row.words.empty())
      out.set(std::string(row.key), row.words[static_cast<std::size_t>(*value)]);
    else if (row.whole)
      out.set(std::string(row.key), static_cast<int>(*value));
    else
      out.set(Json::quantity(std::string(row.key), *value));
  }
  return out;
}

/// The schema of an object with these numbers of a thing, where `usual` is one of which nothing was said; "fixed"
/// beside "required" has the keys that no study varies.
template <class Thing, std::size_t Count>
[[nodiscard]] Json schema_of(std::span<const Row<Thing>, Count> rows, const Thing& usual = {}) {
  Json properties = Json::object();
  Json required = Json::array();
  Json fixed = Json::array();
  for (const Row<Thing>& row : rows) {
    properties.set(std::string(row.key), schema_of(row, row.get(usual)));
    if (row.need == Need::required) required.add(row.key);
    if (row.need == Need::fixed) fixed.add(row.key);
  }
  return Json::object(
      {{"properties", std::move(properties)}, {"required", std::move(required)}, {"fixed", std::move(fixed)}});
}

}  // namespace coilwright::text
