#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace coilwright::text {

/// A letter of a text in UTF-8.
struct CodePoint {
  std::uint32_t value{};
  std::size_t bytes{};  ///< 0: what stands there is not UTF-8
};

/// The first letter of a text that is not empty.
[[nodiscard]] CodePoint decode(std::string_view text);

/// Whether a text is the beginning of a letter whose other bytes are missing.
[[nodiscard]] bool is_begun(std::string_view text);

/// The bytes of one letter, or one that is none, as one_line() shows them.
[[nodiscard]] std::string shown_letter(std::string_view bytes);

}  // namespace coilwright::text
