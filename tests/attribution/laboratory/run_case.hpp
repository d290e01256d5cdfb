#pragma once

#include <filesystem>

#include "attribution/laboratory/outcome.hpp"
#include "attribution/laboratory/plan.hpp"

namespace attribution::laboratory {

/// Makes the set, writes it into a temporary folder, has `program` (the command line program coilwright) diagnose it
/// with `threads` threads as a user would, and scores the diagnosis.json that it writes. Throws std::runtime_error with
/// the program's last words where it fails.
[[nodiscard]] Outcome run_case(const Case& asked, const std::filesystem::path& program, int threads);

}  // namespace attribution::laboratory
