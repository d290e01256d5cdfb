#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "coilwright/report/simulation/document.hpp"
#include "coilwright/simulation/choice_effects.hpp"
#include "coilwright/simulation/evaluate.hpp"
#include "coilwright/text/json/json.hpp"

namespace coilwright::cli {

/// Writes the page of an evaluation of the actuator of this name to a file; `force` replaces one that is no page.
using WriteEvaluationPage =
    std::function<void(const simulation::EvaluatedDesign& evaluated, const report::Document& document,
                       const std::string& name, const std::filesystem::path& file, bool force)>;

/// What `evaluate --json` prints of a design. Without `effects` it says nothing of assumptions.
[[nodiscard]] text::Json evaluation_json(const simulation::DesignView& view,
                                         std::span<const simulation::ChoiceEffect> effects);

/// Adds the command evaluate. Where there is no `write_page`, coilwright-page does what --report asks for.
void add_evaluate(CLI::App& app, const Outcome& outcome, const WriteEvaluationPage& write_page);

}  // namespace coilwright::cli
