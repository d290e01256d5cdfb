#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "coilwright/page/page.hpp"
#include "coilwright/page/pages.hpp"
#include "coilwright/sizing/study/yield.hpp"
#include "coilwright/text/json/node.hpp"

// What would change the answer of `size`; `result` is the root of its result.json.

namespace coilwright::page {

/// The page of a folder that `size` has written; `result` is the root of its result.json.
[[nodiscard]] Page sizing_page(const std::filesystem::path& folder, const text::Node& result, std::string_view made_by);

/// What builds make of the answer to a study with a spread; without `built`, why none were made.
[[nodiscard]] Section builds_section(const text::Node& result, const std::optional<sizing::Yield>& built);

/// What one step of each variable and each limit relaxed would bring.
[[nodiscard]] Section sensitivity_section(const text::Node& result);

/// What the answer is under each other modelling choice.
[[nodiscard]] Section assumptions_section(const text::Node& result);

/// The page of a folder that `pareto` has written; `result` is the root of its result.json.
[[nodiscard]] Page front_page(const std::filesystem::path& folder, const text::Node& result, const PageInputs& inputs);

/// The page of a `sweep`: its best designs, what each variable does to each objective, and which limits decide.
/// `result` is the root of its result.json.
[[nodiscard]] Page sweep_page(const std::filesystem::path& folder, const text::Node& result, const PageInputs& inputs);

/// The page of a folder that `diagnose` has written; `diagnosis` is the root of its diagnosis.json.
[[nodiscard]] Page diagnosis_page(const std::filesystem::path& folder, const text::Node& diagnosis,
                                  std::string_view made_by);

/// What the data of a diagnosis cannot tell apart, the run that would, and what each explanation expects of it
/// (next_experiment.csv of the folder, where there is one). `diagnosis` is the root of its diagnosis.json.
[[nodiscard]] Section next_section(const std::filesystem::path& folder, const text::Node& diagnosis);

}  // namespace coilwright::page
