#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>

#include "cli/archive_contents.hpp"
#include "cli/commands.hpp"
#include "cli/folder_lock.hpp"
#include "cli/options.hpp"
#include "cli/outputs.hpp"
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

void run_check(const ArchiveCheckOptions& options) {
  std::size_t dropped = 0;
  if (options.repair) {
    const FolderLock lock(options.folder);
    dropped = archive::drop_damaged_designs(std::filesystem::path(options.folder) / archive_name);
  }
  const archive::Reader archive = opened_archive(options.folder);
  const std::size_t designs = archive.size(), runs = archive.runs().size();
  if (options.json) {
    std::cout << text::Json::object({{"archive", archive.path().string()},
                                     {"designs", designs},
                                     {"runs", runs},
                                     {"has_checksums", archive.has_checksums()},
                                     {"dropped", dropped}})
                     .text();
    return;
  }
  std::cout << fmt::format("{}: {} designs of {} runs{}.\n", printed(archive.path()), designs, runs,
                           archive.has_checksums() ? ", each as it was written" : "");
  if (dropped > 0)
    std::cout << fmt::format("{} damaged designs were taken out; --resume evaluates them anew.\n", dropped);
}

}  // namespace

void add_archive_check(CLI::App& command) {
  auto options = std::make_shared<ArchiveCheckOptions>();
  CLI::App* check = command.add_subcommand("check", "Whether every row of an archive still is what was written");
  add_archive_folder(*check, options->folder);
  add_flag(*check, "--repair", options->repair,
           "Take out the designs that are damaged, so that --resume evaluates them anew");
  add_json_option(*check, options->json, "text");
  check->footer(
      "Each row has a checksum of its bytes, which every command that opens an archive looks at. Where one does not\n"
      "hold, or the file is torn, the exit code is 2.\n\n"
      "Example:\n  coilwright archive check results/fastest_finger");
  check->callback([options] { run_check(*options); });
}

}  // namespace coilwright::cli
