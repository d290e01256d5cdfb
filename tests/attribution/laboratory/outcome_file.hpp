#pragma once

#include <filesystem>
#include <vector>

#include "attribution/laboratory/outcome.hpp"

namespace attribution::laboratory {

/// Writes an outcome as JSON, in one step: a file that is there is complete.
void write_outcome(const Outcome& outcome, const std::filesystem::path& file);

/// Throws std::runtime_error naming the file if it is not what write_outcome writes.
[[nodiscard]] Outcome read_outcome(const std::filesystem::path& file);

/// All outcomes of a folder, in the order of their numbers.
[[nodiscard]] std::vector<Outcome> read_outcomes(const std::filesystem::path& folder);

}  // namespace attribution::laboratory
