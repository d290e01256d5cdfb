#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <optional>
#include <vector>

#include "cli/options.hpp"
#include "cli/runs/archive_contents.hpp"
#include "cli/search/archive/opened_archive.hpp"
#include "cli/search/commands.hpp"
#include "coilwright/formats/study/archive_results.hpp"
#include "coilwright/report/archive_text.hpp"

namespace coilwright::cli {
namespace {

struct ArchiveReplayOptions {
  std::string folder;
  std::int64_t row{};
  bool json{false};
};

ExitCode run_replay(const ArchiveReplayOptions& options) {
  const archive::Reader archive = opened_archive(options.folder);
  const archive::Row row = row_of(archive, options.row);
  const sizing::DesignProblem problem = problem_of(archive.contents());
  const sizing::Evaluation again = problem.assess(problem.evaluate(point_of(problem, archive, row)));
  const formats::Replay replay{.row = row.id,
                               .recorded = row.evaluation,
                               .again = again,
                               .contents = archive.contents(),
                               .program = this_program()};
  std::cout << (options.json ? formats::to_json(replay).text() : report::to_text(replay));
  return row.evaluation == again ? ExitCode::done : ExitCode::failure;
}

}  // namespace

void add_archive_replay(CLI::App& command, Outcome& outcome) {
  auto options = std::make_shared<ArchiveReplayOptions>();
  CLI::App* replay =
      command.add_subcommand("replay", "Evaluate the design of a row again, and say whether its numbers are the same");
  add_archive_folder(*replay, options->folder);
  add_row_option(*replay, options->row);
  add_json_option(*replay, options->json, "text");
  replay->footer(
      "The same means to the last bit. Where a number differs, the exit code is 1, and both programs are named.\n\n"
      "Example:\n  coilwright archive replay results/fastest_finger --row 17");
  replay->callback([options, &outcome] { outcome.code = run_replay(*options); });
}

}  // namespace coilwright::cli
