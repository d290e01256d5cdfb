#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "coilwright/formats/study/part_file.hpp"
#include "coilwright/results/provenance.hpp"

namespace coilwright::cli {

struct MergeOptions {
  std::string out;
  std::vector<std::string> parts;
  bool force{false};
  bool json{false};
};

/// All parts of one run, each once.
struct Parts {
  archive::Contents whole{};                     ///< of the first
  std::vector<std::filesystem::path> folders{};  ///< in the order of the parts
  std::map<std::string, std::string> made_by{};  ///< by figures: which parts, on which machine
};

/// Checks that the folders are the parts of one run, all of them and each once. What it keeps of each is its name.
/// Throws InputError: one line that says which parts are missing, double, not finished or of another run.
[[nodiscard]] Parts parts_of(const MergeOptions& options);

/// Throws std::runtime_error naming the parts that were made by machines with other figures than `here`.
void require_figures_of_parts(const Parts& parts, const formats::Machine& here);

/// Reads part after part, and calls `take` with its number from 1, its folder and its results.
void for_each_part(const Parts& parts, const std::function<void(std::size_t number, const std::filesystem::path& folder,
                                                                const text::Node& results)>& take);

/// Throws InputError where a file of a part has another SHA-256 than the part says.
void require_written(const std::filesystem::path& file, const std::string& sha256);

/// Where the whole comes from, as the run on one machine says it.
[[nodiscard]] results::Provenance provenance_of_whole(const archive::Contents& whole);

/// "2, 5 to 7".
[[nodiscard]] std::string ranges_text(const std::vector<std::size_t>& ascending);

/// Each makes the results of the whole run of one command from its parts: of size the files of the best seed, of pareto
/// the front of all fronts, of diagnoses a table of the sets and their verdicts.
///@{
ExitCode merge_sweep(const MergeOptions& options, const Parts& parts);
ExitCode merge_size(const MergeOptions& options, const Parts& parts);
ExitCode merge_pareto(const MergeOptions& options, const Parts& parts);
ExitCode merge_yield(const MergeOptions& options, const Parts& parts);
ExitCode merge_diagnoses(const MergeOptions& options, const Parts& parts);
///@}

}  // namespace coilwright::cli
