#pragma once

#include <string>
#include <string_view>

#include "text/json/json_value.hpp"

namespace coilwright::text {

/// Parses `text` by the rules of read_json(). Throws InputError naming `file`.
[[nodiscard]] JsonValue parse_json_value(std::string_view text, const std::string& file);

}  // namespace coilwright::text
