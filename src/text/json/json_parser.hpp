#pragma once

#include <string>
#include <string_view>

#include "coilwright/text/json/json.hpp"

namespace coilwright::text {

/// Parses `text` by the rules of read_json(). Throws InputError naming `file`.
[[nodiscard]] Json parse_json_value(std::string_view text, const std::string& file);

}  // namespace coilwright::text
