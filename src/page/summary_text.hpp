#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace coilwright::page {

/// The lines below a heading of summary.txt in a folder of `diagnose`, up to the next empty one, without what indents
/// them; below its title where `heading` is empty. Empty where there is no such file or heading. Throws InputError
/// where the file cannot be read.
[[nodiscard]] std::vector<std::string> summary_lines(const std::filesystem::path& folder, std::string_view heading);

}  // namespace coilwright::page
