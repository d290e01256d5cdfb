#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/page/page.hpp"
#include "coilwright/simulation/evaluate.hpp"
#include "coilwright/sizing/study/study.hpp"

namespace coilwright::page {

/// The inputs of a page beside the files of its folder.
struct PageInputs {
  std::string made_by{};                 ///< program and version, for the first lines
  std::optional<sizing::Study> study{};  ///< the study of the results; a front shows its designs only with it
  std::string why_no_study{};            ///< reason why there is none, as a sentence
  std::size_t most_pictures = 200;       ///< designs of a front that are drawn and simulated
};

/// The page of a folder of results, from its files: of `size` (result.json, actuator.json, evaluations.csv,
/// convergence.csv), of `pareto` (result.json, front.csv, evaluations.csv, convergence.csv), of `sweep` (result.json,
/// best.csv, designs.csv) or of `diagnose` (diagnosis.json, residuals.csv, and next_experiment.csv if it exists).
/// Throws InputError if the folder has no results of a kind that has a page, or if one of its files cannot be read.
[[nodiscard]] Page page_of(const std::filesystem::path& folder, const PageInputs& inputs);

/// The page of one design at its operating point: `document`, what `evaluate` says of it (report::document_of), and the
/// design drawn and simulated as in the page of a `size`. `name` is the actuator's, `made_by` program and version.
[[nodiscard]] Page evaluation_page(const simulation::EvaluatedDesign& evaluated, const report::Document& document,
                                   std::string_view name, std::string_view made_by);

/// What a document says, as a page that says where it is from: `origin`, and the files that it is made of.
[[nodiscard]] Page page_of(const report::Document& document, std::string origin, std::vector<std::string> inputs = {});

}  // namespace coilwright::page
