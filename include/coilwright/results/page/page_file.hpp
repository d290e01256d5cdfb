#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "coilwright/page/page.hpp"
#include "coilwright/sizing/study/study.hpp"
#include "coilwright/text/packed_file.hpp"

namespace coilwright::results {

/// Program and version, as in the first lines of a page.
[[nodiscard]] std::string made_by();

/// The study that the results of a folder are of.
struct StudyBehind {
  std::optional<sizing::Study> study{};  ///< absent: it is not at hand
  std::string why{};                     ///< reason why it is not, as a sentence
};

/// Reads the study that the provenance.json of a folder names. It is absent if that file, or a file that it names, is
/// not there as it was. Throws text::InputError if provenance.json is none.
[[nodiscard]] StudyBehind study_behind(const std::filesystem::path& folder);

/// The page of a folder of results. A front shows its designs if its provenance.json leads to an unchanged study.
/// `pictures` is the largest number of designs of a front that are drawn; `present` are the files that lie there under
/// names of results. Throws text::InputError if the folder has no results, no page can be made, or a result is not as
/// it was written; if that cannot be checked, the page says so.
[[nodiscard]] page::Page page_of_folder(const std::filesystem::path& folder,
                                        std::optional<std::size_t> pictures = std::nullopt,
                                        std::span<const std::filesystem::path> present = {});

/// A page as one HTML file with everything that it needs. Throws text::InputError if this build cannot make pages.
[[nodiscard]] std::string html_of(const page::Page& page);

/// The scripts and the style of our pages: theme.js, page.js, front.js, page.css, and figures.cjs for Node.
[[nodiscard]] std::span<const text::PackedFile> page_files();

/// Vega, Vega-Lite and vega-embed in the order in which they run, and licences.txt; empty if they were not built in.
[[nodiscard]] std::span<const text::PackedFile> report_libraries();

}  // namespace coilwright::results
