#pragma once

#include <string>
#include <string_view>

#include "json_value.hpp"

namespace coilwright::formats {

/// Parses `text` by the rules of read_json(). Throws InputError naming `file`.
[[nodiscard]] JsonValue parse_json_value(std::string_view text, const std::string& file);

/// `token` as a part of a JSON pointer, with its leading slash (RFC 6901: ~ becomes ~0, / becomes ~1).
[[nodiscard]] std::string pointer_step(std::string_view token);

}  // namespace coilwright::formats
