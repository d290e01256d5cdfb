#pragma once

#include <filesystem>
#include <string_view>

#include "coilwright/page/page.hpp"
#include "coilwright/text/json/node.hpp"

namespace coilwright::page {

/// The page of a folder that `size` has written; `result` is the root of its result.json.
[[nodiscard]] Page sizing_page(const std::filesystem::path& folder, const text::Node& result, std::string_view made_by);

}  // namespace coilwright::page
