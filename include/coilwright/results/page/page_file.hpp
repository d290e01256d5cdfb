#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "coilwright/page/page.hpp"
#include "coilwright/text/packed_file.hpp"

namespace coilwright::results {

/// Program and version, as the first lines of a page have them.
[[nodiscard]] std::string made_by();

/// The page of a folder of results; a front shows its designs where its provenance.json leads to an unchanged study.
/// `pictures`: designs of a front that are drawn at most; `present`: what lies there under names of results, whatever
/// wrote it. Throws text::InputError where the folder has no results, no page can be made, or a result is not as it was
/// written; where nothing tells that, the page says so.
[[nodiscard]] page::Page page_of_folder(const std::filesystem::path& folder,
                                        std::optional<std::size_t> pictures = std::nullopt,
                                        std::span<const std::filesystem::path> present = {});

/// A page as one HTML file, with all that it needs packed in. Throws text::InputError where none can be made.
[[nodiscard]] std::string html_of(const page::Page& page);

/// Our own scripts and style of a page: theme.js, page.js, front.js, page.css, and figures.cjs for Node.
[[nodiscard]] std::span<const text::PackedFile> page_files();

/// Vega, Vega-Lite and vega-embed in the order in which they run, and licences.txt; none where they were not built in.
[[nodiscard]] std::span<const text::PackedFile> report_libraries();

}  // namespace coilwright::results
