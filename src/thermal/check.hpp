#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "coilwright/thermal/network.hpp"

namespace coilwright::thermal {

/// Name of a value in an error text; put together only when there is one to report.
struct Field {
  std::string_view name;               ///< "angle", or what stands before the index: "nodes"
  std::optional<std::size_t> index{};  ///< of an element of a list
  std::string_view member{};           ///< of that element

  [[nodiscard]] std::string text() const {
    if (!index) return std::string(name);
    return member.empty() ? fmt::format("{}[{}]", name, *index) : fmt::format("{}[{}].{}", name, *index, member);
  }
};

/// Throws std::invalid_argument "field: must be rule; got value".
[[noreturn]] inline void reject(const Field& field, std::string_view rule, double value) {
  throw std::invalid_argument(fmt::format("{}: must be {}; got {}", field.text(), rule, value));
}

/// Rejects unless `holds`.
inline void require(bool holds, const Field& field, std::string_view rule, double value) {
  if (!holds) reject(field, rule, value);
}

inline void require_positive(const Field& field, double value) {
  require(std::isfinite(value) && value > 0.0, field, "finite and > 0", value);
}

inline void require_not_negative(const Field& field, double value) {
  require(std::isfinite(value) && value >= 0.0, field, "finite and >= 0", value);
}

/// A list has between `least` and `most` entries.
inline void require_count(const Field& field, std::size_t count, std::size_t least, std::size_t most) {
  if (count >= least && count <= most) return;
  const auto rule = least == most ? fmt::format("{} in number", least) : fmt::format("{} to {} in number", least, most);
  reject(field, rule, static_cast<double>(count));
}

/// A vector has one value a node.
void require_one_each(const Network& network, std::string_view field, const NodeVector& values);

/// Mean square currents fit the network: a value a node, none negative, none in a magnet.
void require_load(const Network& network, const NodeVector& mean_square_currents);

/// Throws std::invalid_argument unless the network has a node of this kind.
void require_any(const Network& network, NodeKind kind);

}  // namespace coilwright::thermal
