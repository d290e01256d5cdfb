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

/// A part in its folder.
struct PartFolder {
  std::filesystem::path path{};
  std::string part_sha256{};                 ///< of part.json without the entry of found.json
  std::vector<formats::FileOfPart> files{};  ///< all that it has
};

/// All parts of one run, each once.
struct Parts {
  archive::Contents whole{};                     ///< of the first
  std::vector<PartFolder> folders{};             ///< in the order of the parts
  std::map<std::string, std::string> made_by{};  ///< by figures: which parts, on which machine
};

/// Checks that the folders are the parts of one run, all of them and each once, and that the folder of the result is
/// none of them and in none of them. What it keeps of each is the list of its files. Throws InputError: one line that
/// says which parts are missing, double, not finished or of another run.
[[nodiscard]] Parts parts_of(const MergeOptions& options);

/// Throws std::runtime_error naming the parts that were made by machines with other figures than `here`.
void require_figures_of_parts(const Parts& parts, const formats::Machine& here);

/// Goes through part after part: holds every file of one against its digest, and then calls `take` with the number of
/// the part from 1 and the part. Throws InputError naming a file that is not there, is a link, a pipe or a folder, or
/// is not what the part wrote.
void for_each_part(const Parts& parts, const std::function<void(std::size_t number, const PartFolder& part)>& take);

/// Hands out a file of a part as it is read, block by block. Throws as for_each_part(), also at its end: what came of
/// the blocks must not be committed then.
void read_file_of(const PartFolder& part, std::string_view name, const std::function<void(std::string_view)>& take);
/// A JSON file of a part.
[[nodiscard]] text::Document document_of(const PartFolder& part, std::string_view name);
/// What `read` makes of the results of a part, which only a command with a found.json has.
template <class Read>
[[nodiscard]] auto results_of(const PartFolder& part, const Read& read) {
  const text::Document found = document_of(part, formats::found_name);
  return read(formats::results_in(found, part.part_sha256));
}

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
