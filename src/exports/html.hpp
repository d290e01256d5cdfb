#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace coilwright::exports {

/// A table; all cells are texts and are escaped; each row has one for each name of the header.
/// Columns of numbers are set to the right.
[[nodiscard]] std::string html_table(const std::vector<std::string>& header,
                                     const std::vector<std::vector<std::string>>& rows);

/// An ordered list of escaped texts.
[[nodiscard]] std::string html_list(const std::vector<std::string>& items);

/// A complete page for A4 paper, without scripts and without anything from outside. `body` is HTML.
[[nodiscard]] std::string html_page(std::string_view title, std::string_view body);

}  // namespace coilwright::exports
