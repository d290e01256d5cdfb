#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "coilwright/formats/data/dataset_draft.hpp"

namespace coilwright::cli {

/// A dataset.json for these records, from a folder, of the actuator in a file: formats::draft_dataset().
using DraftDataset = std::function<formats::DatasetDraft(
    const std::vector<std::filesystem::path>& files, const std::filesystem::path& folder, const std::string& actuator)>;

/// Adds the command init. Where there is no `draft`, coilwright-records does what --from asks for.
void add_init(CLI::App& app, const Outcome& outcome, const DraftDataset& draft);

}  // namespace coilwright::cli
