#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/text/output/output_folder.hpp"

namespace coilwright::cli {

/// A folder has one run. What a command may leave in its folder of results is a row of a table each, with the commands
/// that write it; whatever another run wrote goes first (--force), or the folder is refused.
///@{

/// Whether `command` may leave a file of that name, and whether an archive or a log beside one has it.
[[nodiscard]] bool is_left_by(std::string_view command, std::string_view name);
[[nodiscard]] bool is_of_archive(std::string_view name);

/// Every file of that table in a folder, there or not: none of them may be an input of a run that replaces it.
[[nodiscard]] std::vector<std::filesystem::path> run_files_in(const std::filesystem::path& folder);

/// Those that are there when a part of a run ends: all but part.json and found.json, a page and the archive.
[[nodiscard]] std::vector<std::filesystem::path> files_of_part_in(const std::filesystem::path& folder);

/// Throws text::OutputError naming the first file of another run in the folder, unless `force`: one of the table that
/// is not `own`. Whether forced or not, also where the folder is a data set or a workflow, whose files nobody can list.
void keep_other_run(const std::filesystem::path& folder, const std::function<bool(std::string_view name)>& own,
                    bool force);
/// The same of a run of `command` ("size"), whose own files an earlier one may have left.
void keep_other_run(const std::filesystem::path& folder, std::string_view command, bool force);

/// Removes at commit() every file of the table that is not written again, but the archive, which may be this run's. A
/// page of this program stays where it shows what is written: where `key` is there and does not change.
void remove_other_run(text::OutputFolder& folder, std::string_view key);
/// The archive, too: for a command that has none.
void remove_other_archive(text::OutputFolder& folder);

/// All of this for a command that knows its files when they are written: keep_others(), and nothing of another run.
void take_folder(text::OutputFolder& folder, std::string_view key, bool force);
///@}

}  // namespace coilwright::cli
