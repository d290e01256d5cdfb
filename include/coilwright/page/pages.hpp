#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "coilwright/page/page.hpp"
#include "coilwright/simulation/choice_effects.hpp"
#include "coilwright/simulation/evaluate.hpp"
#include "coilwright/sizing/study/study.hpp"
#include "coilwright/systems/validation/paper_comparison.hpp"

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

/// The page of one design at its operating point: its quantities, the limits of its parts and the assumptions, drawn
/// and simulated as in the page of a `size`. `effects` are simulation::choice_effects of the design there, `name` is
/// the actuator's, `made_by` program and version.
[[nodiscard]] Page evaluation_page(const simulation::EvaluatedDesign& evaluated,
                                   std::span<const simulation::ChoiceEffect> effects, std::string_view name,
                                   std::string_view made_by);

/// The page that compares the model with the figures of the paper: every difference with its band. `made_by` is program
/// and version.
[[nodiscard]] Page comparison_page(std::span<const systems::validation::Comparison> rows, std::string_view made_by);

}  // namespace coilwright::page
