#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include "cli/options.hpp"
#include "cli/outputs.hpp"
#include "cli/progress_line.hpp"
#include "cli/runs/archive_contents.hpp"
#include "cli/runs/study_run.hpp"
#include "cli/search/archive/opened_archive.hpp"
#include "cli/search/commands.hpp"
#include "coilwright/archive/recorded_study.hpp"
#include "coilwright/archive/writer.hpp"
#include "coilwright/text/json/json.hpp"
#include "coilwright/text/output/folder_lock.hpp"

namespace coilwright::cli {
namespace {

struct ArchiveCheckOptions {
  std::string folder;
  bool repair{false};
  bool json{false};
};

archive::Repair repaired(const std::string& folder, const Interruption& interruption) {
  const text::FolderLock lock(folder);
  std::optional<sizing::DesignProblem> problem;
  std::atomic<std::size_t> looked_at = 0, damaged = 0;
  const ProgressLine::Place place = progress_place(false);
  const ProgressLine line(std::cerr, place, progress_interval(place), [&] {
    return fmt::format("{} of {} damaged designs evaluated anew", looked_at.load(), damaged.load());
  });
  return archive::repair_designs(
      std::filesystem::path(folder) / archive_name,
      [&](const archive::Contents& contents, const archive::Row& row) -> std::optional<sizing::Evaluation> {
        if (!problem) problem.emplace(problem_of(contents));
        if (archive::columns_of(problem->study()) != contents.columns) return std::nullopt;
        return archive::evaluated_again(*problem, contents, row);
      },
      [&](std::size_t done, std::size_t of) {
        looked_at = done;
        damaged = of;
        return !interruption.requested();
      });
}

std::string text_of(const archive::Repair& repair) {
  std::string text;
  if (repair.looked_at() > 0)
    text += fmt::format("Damaged designs evaluated anew: {} are as they were written again, {} were taken out{}.\n",
                        repair.mended, repair.dropped.size() + repair.dropped_choices,
                        repair.dropped.empty()
                            ? ""
                            : fmt::format(" (rows {}; --resume evaluates them)", fmt::join(repair.dropped, ", ")));
  if (repair.gone > 0)
    text += fmt::format("{} designs that were written are gone; --resume evaluates them.\n", repair.gone);
  return text;
}

ExitCode run_check(const ArchiveCheckOptions& options) {
  const Interruption interruption;
  const archive::Repair repair = options.repair ? repaired(options.folder, interruption) : archive::Repair{};
  if (repair.left > 0) {
    std::cout << text_of(repair);
    std::cerr << fmt::format("coilwright: interrupted: {} damaged designs are left; the same command goes on\n",
                             repair.left);
    return ExitCode::interrupted;
  }
  const archive::Reader archive = opened_archive(options.folder);
  const std::size_t designs = archive.size(), runs = archive.runs().size();
  if (options.json) {
    std::cout << text::Json::object({{"archive", archive.path().string()},
                                     {"designs", designs},
                                     {"runs", runs},
                                     {"has_checksums", archive.has_checksums()},
                                     {"mended", repair.mended},
                                     {"dropped", repair.dropped.size() + repair.dropped_choices},
                                     {"dropped_rows", text::Json::list(repair.dropped)},
                                     {"gone", repair.gone}})
                     .text();
    return ExitCode::done;
  }
  std::cout << fmt::format("{}: {} designs of {} runs{}.\n", printed(archive.path()), designs, runs,
                           archive.has_checksums() ? ", each as it was written" : "");
  std::cout << text_of(repair);
  return ExitCode::done;
}

}  // namespace

void add_archive_check(CLI::App& command, Outcome& outcome) {
  auto options = std::make_shared<ArchiveCheckOptions>();
  CLI::App* check = command.add_subcommand("check", "Whether every row of an archive still is what was written");
  add_archive_folder(*check, options->folder);
  add_flag(*check, "--repair", options->repair,
           "Evaluate the designs that are damaged anew; where the row is not what was written even so, take it out, so "
           "that --resume evaluates it");
  add_json_option(*check, options->json, "text");
  check->footer(
      "Each row has a checksum of its bytes, and each table a count of its rows, which every command that opens an\n"
      "archive looks at. Where one does not hold, or the file is torn, the exit code is 2. A repair that is "
      "interrupted\n"
      "keeps what it has mended; the exit code is then 130.\n\n"
      "Example:\n  coilwright archive check results/fastest_finger");
  check->callback([options, &outcome] { outcome.code = run_check(*options); });
}

}  // namespace coilwright::cli
