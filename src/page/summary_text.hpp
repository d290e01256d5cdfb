#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace coilwright::page {

/// The lines below a heading of summary.txt in a folder of `diagnose`, up to the next empty one, without what indents
/// them; below its title where `heading` is empty. Throws InputError where there is no such file or heading, and
/// where nothing stands below the title: a page without its verdict or its doubts would say more than is known.
[[nodiscard]] std::vector<std::string> summary_lines(const std::filesystem::path& folder, std::string_view heading);

}  // namespace coilwright::page
