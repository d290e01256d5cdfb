#pragma once

#include "coilwright/page/folder_page.hpp"
#include "coilwright/text/json/node.hpp"

namespace coilwright::page {

/// The page of a `sweep`: its best designs, what each variable does to each objective, and which limits decide.
/// `result` is the root of its result.json.
[[nodiscard]] Page sweep_page(const std::filesystem::path& folder, const text::Node& result, const PageInputs& inputs);

}  // namespace coilwright::page
