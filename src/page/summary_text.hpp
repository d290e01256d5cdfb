#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace coilwright::page {

/// The lines below a heading of summary.txt in a folder of `diagnose`, up to the next empty one; below its title where
/// `heading` is empty. Throws InputError where there is no such file or heading, and where nothing stands below the
/// title: a page without its verdict or its doubts would say more than is known.
[[nodiscard]] std::vector<std::string> summary_section(const std::filesystem::path& folder, std::string_view heading);

/// The same without what indents them.
[[nodiscard]] std::vector<std::string> summary_lines(const std::filesystem::path& folder, std::string_view heading);

/// Throws InputError where the title of that file is not this data set and verdict: it is the summary of another
/// diagnosis than the diagnosis.json beside it, and a page would show the words of one with the numbers of the other.
void require_summary_of(const std::filesystem::path& folder, const std::string& dataset, const std::string& verdict);

}  // namespace coilwright::page
