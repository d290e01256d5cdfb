#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "coilwright/actuator/design/value_limits.hpp"
#include "coilwright/text/json/object_reader.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::formats {

/// The rule of a part's length in the unit of its key, "gap_mm" or "gap_m".
[[nodiscard]] inline text::Rule part_length(std::string_view key) {
  return text::Rule::between(units::from_memory(actuator::shortest_length, key),
                             units::from_memory(actuator::longest_length, key));
}

/// A number of a part as a file writes it: shared by the reader and by the names of numbers that may be calibrated.
template <class Part>
struct PartKey {
  std::string_view key;  ///< its unit at its end, if it has one
  text::Rule rule;       ///< in that unit
  double Part::*member{};
  std::optional<double> otherwise{};  ///< SI, where the key may be absent
};

/// The part whose numbers are `keys`.
template <class Part, std::size_t Count>
[[nodiscard]] Part read_numbers(text::ObjectReader& in, const std::array<PartKey<Part>, Count>& keys, Part part = {}) {
  for (const PartKey<Part>& each : keys) {
    const bool has_unit = units::split_unit(each.key).has_value();
    if (each.otherwise)
      part.*each.member = has_unit ? in.quantity_or(each.key, *each.otherwise, each.rule)
                                   : in.number_or(each.key, *each.otherwise, each.rule);
    else
      part.*each.member = has_unit ? in.quantity(each.key, each.rule) : in.number(each.key, each.rule);
  }
  return part;
}

/// An object with the part's numbers, each in the unit of its key: read_numbers() of it is the part again, to rounding.
template <class Part, std::size_t Count>
[[nodiscard]] text::Json numbers_json(const Part& part, const std::array<PartKey<Part>, Count>& keys) {
  text::Json out = text::Json::object();
  for (const PartKey<Part>& each : keys) out.set(text::Json::quantity(std::string(each.key), part.*each.member));
  return out;
}

}  // namespace coilwright::formats
