#pragma once

#include <string>

#include "coilwright/page/page.hpp"

namespace coilwright::page {

/// The table as HTML, in a region that scrolls by itself where it is wider than the page. Texts are escaped; columns of
/// numbers are set to the right.
[[nodiscard]] std::string table_html(const TableBlock& block);

}  // namespace coilwright::page
