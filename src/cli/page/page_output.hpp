#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "coilwright/page/page.hpp"
#include "coilwright/report/simulation/document.hpp"
#include "coilwright/simulation/evaluate.hpp"

namespace coilwright::cli {

/// How a page is written.
struct PageOutput {
  std::optional<std::filesystem::path> figures{};  ///< folder for every figure as a file of its own
  bool force{false};                               ///< replace a file that is no page, and figures of other content
};

/// A page written to `file` as a whole or not at all, and each of its figures into a folder, if one is given. Figures
/// that cannot be drawn without Node are named on standard error. Throws OutputError where a file cannot be written.
void write_page(const page::Page& content, const std::filesystem::path& file, const PageOutput& how = {});

/// The page of an evaluation: what WriteEvaluationPage asks for.
void write_evaluation_page(const simulation::EvaluatedDesign& evaluated, const report::Document& document,
                           const std::string& name, const std::filesystem::path& file, bool force);

}  // namespace coilwright::cli
