#pragma once

#include <string>
#include <string_view>

namespace coilwright::page {

/// The bytes of a text in base 64 (RFC 4648, with padding).
[[nodiscard]] std::string base64(std::string_view bytes);

}  // namespace coilwright::page
