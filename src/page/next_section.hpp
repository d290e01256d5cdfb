#pragma once

#include <filesystem>

#include "coilwright/page/page.hpp"
#include "coilwright/text/json/node.hpp"

namespace coilwright::page {

/// What the data of a diagnosis cannot tell apart, the run that would, and what each explanation expects of it
/// (next_experiment.csv of the folder, where there is one). `diagnosis` is the root of its diagnosis.json.
[[nodiscard]] Section next_section(const std::filesystem::path& folder, const text::Node& diagnosis);

}  // namespace coilwright::page
