#pragma once

#include <filesystem>

#include "coilwright/page/folder_page.hpp"
#include "coilwright/text/json/node.hpp"

namespace coilwright::page {

/// The page of a folder that `pareto` has written; `result` is the root of its result.json.
[[nodiscard]] Page front_page(const std::filesystem::path& folder, const text::Node& result, const PageInputs& inputs);

}  // namespace coilwright::page
