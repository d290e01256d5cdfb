#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "coilwright/text/markup.hpp"

namespace coilwright::exports {

using text::html_table;

/// An ordered list of escaped texts.
[[nodiscard]] std::string html_list(const std::vector<std::string>& items);

/// A complete page for A4 paper, without scripts and without anything from outside. `body` is HTML.
[[nodiscard]] std::string html_page(std::string_view title, std::string_view body);

}  // namespace coilwright::exports
