#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/page/page.hpp"
#include "coilwright/page/pages.hpp"
#include "coilwright/text/json/node.hpp"

namespace coilwright::page {

/// The page of a folder that `size` has written; `result` is the root of its result.json.
[[nodiscard]] Page sizing_page(const std::filesystem::path& folder, const text::Node& result, std::string_view made_by);

/// The `summary` of a folder's result as a page; `result` is the root of its result.json or diagnosis.json.
[[nodiscard]] Page page_of(const std::filesystem::path& folder, const text::Node& result, std::string_view made_by);

/// The section of a page with that id; a new one at its end where there is none.
[[nodiscard]] Section& section_named(Page& page, std::string_view id, std::string_view title = {});

/// The page of a folder that `pareto` has written; `result` is the root of its result.json.
[[nodiscard]] Page front_page(const std::filesystem::path& folder, const text::Node& result, const PageInputs& inputs);

/// The page of a `sweep`: its best designs, what each variable does to each objective, and which limits decide.
/// `result` is the root of its result.json.
[[nodiscard]] Page sweep_page(const std::filesystem::path& folder, const text::Node& result, const PageInputs& inputs);

/// The page of a folder that `diagnose` has written; `diagnosis` is the root of its diagnosis.json.
[[nodiscard]] Page diagnosis_page(const std::filesystem::path& folder, const text::Node& diagnosis,
                                  std::string_view made_by);

/// Adds the run that would separate explanations, and what each of them expects of it (next_experiment.csv of the
/// folder, where there is one). `diagnosis` is the root of its diagnosis.json.
void add_next_experiment(Page& page, const std::filesystem::path& folder, const text::Node& diagnosis);

}  // namespace coilwright::page
