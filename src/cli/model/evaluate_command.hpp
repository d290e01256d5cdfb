#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "coilwright/report/simulation/document.hpp"
#include "coilwright/simulation/evaluate.hpp"

namespace coilwright::cli {

/// Writes the page of an evaluation of the actuator of this name to a file; `force` replaces one that is no page.
using WriteEvaluationPage =
    std::function<void(const simulation::EvaluatedDesign& evaluated, const report::Document& document,
                       const std::string& name, const std::filesystem::path& file, bool force)>;

/// Adds the command evaluate. Where there is no `write_page`, coilwright-page does what --report asks for.
void add_evaluate(CLI::App& app, const Outcome& outcome, const WriteEvaluationPage& write_page);

}  // namespace coilwright::cli
