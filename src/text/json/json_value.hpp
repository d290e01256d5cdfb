#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace coilwright::text {

/// A JSON value as the document keeps it; what a Node looks at.
struct JsonValue {
  using Array = std::vector<JsonValue>;
  using Object = std::vector<std::pair<std::string, JsonValue>>;  // in the order of the file

  std::variant<std::nullptr_t, bool, double, std::string, Array, Object> content{nullptr};
};

}  // namespace coilwright::text
