#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/text/json/node.hpp"

namespace coilwright::text {

/// `token` as a part of a JSON pointer, with its leading slash (RFC 6901: ~ becomes ~0, / becomes ~1).
[[nodiscard]] std::string pointer_step(std::string_view token);

/// The steps of a JSON pointer (RFC 6901), unescaped: "/links/0/mass_kg" has three. Absent if it is no pointer.
[[nodiscard]] std::optional<std::vector<std::string>> pointer_steps(std::string_view pointer);

/// The array index that a step stands for: digits without a leading zero. Absent if it stands for none.
[[nodiscard]] std::optional<std::size_t> array_index(std::string_view step);

/// The value to which `steps` lead from `node`; absent if they lead nowhere.
[[nodiscard]] std::optional<Node> follow(Node node, std::span<const std::string> steps);

}  // namespace coilwright::text
