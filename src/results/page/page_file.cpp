#include "coilwright/results/page/page_file.hpp"

#include <fmt/format.h>

#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "coilwright/formats/study/study_file.hpp"
#include "coilwright/page/page_html.hpp"
#include "coilwright/page/pages.hpp"
#include "coilwright/results/build_info.hpp"
#include "coilwright/results/provenance.hpp"
#include "coilwright/results/sha256.hpp"
#include "coilwright/text/input_error.hpp"

namespace coilwright::results {
namespace {

std::vector<page::Script> scripts() {
  const std::span<const text::PackedFile> libraries = report_libraries();
  std::vector<page::Script> out;
  for (const char* name : {"vega.js", "vega-lite.js", "vega-embed.js"})
    out.push_back({.name = name, .text = text::packed_text(libraries, name), .licence = {}});
  out.front().name = "Vega, Vega-Lite, vega-embed and what they contain";
  out.front().licence = text::packed_text(libraries, "licences.txt");
  for (const char* name : {"theme.js", "page.js", "front.js"})
    out.push_back({.name = name, .text = text::packed_text(page_files(), name), .licence = {}});
  return out;
}

}  // namespace

StudyBehind study_behind(const std::filesystem::path& folder) {
  const std::optional<InputsBehind> inputs = inputs_behind(folder);
  if (!inputs) return {.why = fmt::format("the folder has no {}, which names the study.", provenance_name)};
  if (!inputs->changed.empty())
    return {.why = fmt::format(
                "{}, which these results are of, is not there as it was; make the page where the search was run.",
                inputs->changed)};
  try {
    return {.study = formats::read_study(inputs->files.front(), {.changes = inputs->changes})};
  } catch (const text::InputError& why) {
    return {.why = fmt::format("the study that {} names cannot be read: {}.", (folder / provenance_name).string(),
                               why.what())};
  }
}

namespace {

// Readers say more than a digest of what they cannot read, but may blame the file beside the one that changed.
page::Page read_as_written(const std::filesystem::path& folder, const page::PageInputs& inputs,
                           std::span<const std::filesystem::path> present) {
  try {
    page::Page page = page::page_of(folder, inputs);
    require_as_written(folder, present);
    return page;
  } catch (const text::InputError& read) {
    try {
      if (std::filesystem::is_directory(folder) && read.fault().file != folder.string())
        require_as_written(folder, present);
    } catch (const text::InputError& changed) {
      if (changed.fault().file != read.fault().file) throw;
    }
    throw;
  }
}

}  // namespace

std::string made_by() {
  return "coilwright " + version();
}

page::Page page_of_folder(const std::filesystem::path& folder, std::optional<std::size_t> pictures,
                          std::span<const std::filesystem::path> present) {
  if (const std::string why = why_no_page(); !why.empty())
    throw text::InputError({.file = folder.string(), .rule = why});
  page::PageInputs inputs{.made_by = made_by()};
  for (const char* of_designs : {"front.csv", "best.csv"})
    if (std::filesystem::is_regular_file(folder / of_designs)) {
      StudyBehind found = study_behind(folder);
      inputs.study = std::move(found.study);
      inputs.why_no_study = std::move(found.why);
    }
  if (pictures) inputs.most_pictures = *pictures;
  page::Page page = read_as_written(folder, inputs, present);
  if (const std::string why = why_unchecked(folder); !why.empty())
    page.cautions.insert(page.cautions.begin(), why + ".");
  return page;
}

std::string html_of(const page::Page& page) {
  const std::vector<page::Script> all = scripts();
  return page::to_html(page, {.scripts = all, .style = text::packed_text(page_files(), "page.css")},
                       [](std::string_view bytes) { return sha256(bytes); });
}

}  // namespace coilwright::results
