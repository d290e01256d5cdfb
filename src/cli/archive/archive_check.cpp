#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include "cli/archive_contents.hpp"
#include "cli/commands.hpp"
#include "cli/folder_lock.hpp"
#include "cli/options.hpp"
#include "cli/outputs.hpp"
#include "coilwright/archive/recorded_study.hpp"
#include "coilwright/archive/writer.hpp"
#include "coilwright/text/json/json.hpp"
#include "opened_archive.hpp"

namespace coilwright::cli {
namespace {

struct ArchiveCheckOptions {
  std::string folder;
  bool repair{false};
  bool json{false};
};

archive::Repair repaired(const std::string& folder) {
  const FolderLock lock(folder);
  std::optional<sizing::DesignProblem> problem;
  return archive::repair_designs(
      std::filesystem::path(folder) / archive_name,
      [&](const archive::Contents& contents, const archive::Row& row) -> std::optional<sizing::Evaluation> {
        if (!problem) problem.emplace(problem_of(contents));
        if (archive::columns_of(problem->study()) != contents.columns) return std::nullopt;
        return archive::evaluated_again(*problem, contents, row);
      });
}

void run_check(const ArchiveCheckOptions& options) {
  const archive::Repair repair = options.repair ? repaired(options.folder) : archive::Repair{};
  const archive::Reader archive = opened_archive(options.folder);
  const std::size_t designs = archive.size(), runs = archive.runs().size();
  if (options.json) {
    std::cout << text::Json::object({{"archive", archive.path().string()},
                                     {"designs", designs},
                                     {"runs", runs},
                                     {"has_checksums", archive.has_checksums()},
                                     {"mended", repair.mended.size()},
                                     {"dropped", repair.dropped.size()},
                                     {"dropped_rows", text::Json::list(repair.dropped)}})
                     .text();
    return;
  }
  std::cout << fmt::format("{}: {} designs of {} runs{}.\n", printed(archive.path()), designs, runs,
                           archive.has_checksums() ? ", each as it was written" : "");
  if (!repair.mended.empty() || !repair.dropped.empty())
    std::cout << fmt::format(
        "Damaged designs evaluated anew: {} are as they were written again, {} were taken out{}.\n",
        repair.mended.size(), repair.dropped.size(),
        repair.dropped.empty() ? ""
                               : fmt::format(" (rows {}; --resume evaluates them)", fmt::join(repair.dropped, ", ")));
}

}  // namespace

void add_archive_check(CLI::App& command) {
  auto options = std::make_shared<ArchiveCheckOptions>();
  CLI::App* check = command.add_subcommand("check", "Whether every row of an archive still is what was written");
  add_archive_folder(*check, options->folder);
  add_flag(*check, "--repair", options->repair,
           "Evaluate the designs that are damaged anew; where the row is not what was written even so, take it out, so "
           "that --resume evaluates it");
  add_json_option(*check, options->json, "text");
  check->footer(
      "Each row has a checksum of its bytes, which every command that opens an archive looks at. Where one does not\n"
      "hold, or the file is torn, the exit code is 2.\n\n"
      "Example:\n  coilwright archive check results/fastest_finger");
  check->callback([options] { run_check(*options); });
}

}  // namespace coilwright::cli
