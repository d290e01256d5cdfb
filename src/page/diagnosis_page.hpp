#pragma once

#include <filesystem>
#include <string_view>

#include "coilwright/page/page.hpp"
#include "coilwright/text/json/node.hpp"

namespace coilwright::page {

/// The page of a folder that `diagnose` has written; `diagnosis` is the root of its diagnosis.json.
[[nodiscard]] Page diagnosis_page(const std::filesystem::path& folder, const text::Node& diagnosis,
                                  std::string_view made_by);

}  // namespace coilwright::page
