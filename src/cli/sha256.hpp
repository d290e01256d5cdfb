#pragma once

#include <string>
#include <string_view>

namespace coilwright::cli {

/// The SHA-256 digest of some bytes (FIPS 180-4) in 64 hexadecimal digits: what `sha256sum` prints of them.
[[nodiscard]] std::string sha256(std::string_view bytes);

}  // namespace coilwright::cli
