#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "cli/options.hpp"
#include "cli/search/archive/opened_archive.hpp"
#include "cli/search/commands.hpp"
#include "coilwright/report/archive_text.hpp"

namespace coilwright::cli {
namespace {

struct ArchiveListOptions {
  std::string folder;
  bool json{false};
};

}  // namespace

void add_archive_list(CLI::App& command) {
  auto options = std::make_shared<ArchiveListOptions>();
  CLI::App* list = command.add_subcommand("list", "What an archive is of, and the runs that wrote to it");
  add_archive_folder(*list, options->folder);
  add_json_option(*list, options->json, "text");
  list->footer("Example:\n  coilwright archive list results/fastest_finger");
  list->callback([options] {
    const archive::Reader archive = opened_archive(options->folder);
    const formats::ArchiveSummary summary{.contents = archive.contents(),
                                          .runs = archive.runs(),
                                          .ok = archive.count("status = 'ok'"),
                                          .infeasible = archive.count("status = 'infeasible'"),
                                          .failed = archive.count("status = 'failed'")};
    std::cout << (options->json ? formats::to_json(summary).text() : report::to_text(summary));
  });
}

}  // namespace coilwright::cli
