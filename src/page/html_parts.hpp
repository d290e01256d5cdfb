#pragma once

#include <string>
#include <string_view>

#include "coilwright/page/page.hpp"

namespace coilwright::page {

/// The bytes of a text in base 64 (RFC 4648, with padding).
[[nodiscard]] std::string base64(std::string_view bytes);

/// The table as HTML, in a region that scrolls by itself where it is wider than the page. Texts are escaped; columns of
/// numbers are set to the right.
[[nodiscard]] std::string table_html(const TableBlock& block);

}  // namespace coilwright::page
