#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "cli/film/commands.hpp"
#include "cli/options.hpp"
#include "cli/outputs.hpp"
#include "coilwright/video/tag_sheet.hpp"

namespace coilwright::cli {
namespace {

struct TagOptions {
  double size = 8.0;  // mm
  std::string out;
  bool force{false};
  bool json{false};
};

void run_tag(const TagOptions& options) {
  text::OutputFile file(options.out);
  file.stream() << video::tag_sheet(options.size * 1e-3);
  keep_other(file, options.force);
  file.commit();
  if (options.json)
    std::cout << written_json({options.out}).text();
  else
    report_stream(options.out) << fmt::format(
        "{}: print it at 100 %, check the ruler; next: coilwright track FILM --out DIR\n", printed(options.out));
}

}  // namespace

void add_tag_command(CLI::App& app, Outcome&) {
  auto options = std::make_shared<TagOptions>();
  CLI::App* command = add_command(app, "tag");
  command->add_option("--out", options->out, "File to write")->required()->check(not_empty());
  add_number(*command, "--size-mm", options->size, text::Rule::between(2, 40),
             "Side of the tags' black square, mm (default 8)");
  add_force_option(*command, options->force);
  add_written_json_option(*command, options->json);
  command->footer(
      "Tags are ArUco's (DICT_4X4_50, 0 to 5). A tag should be 30 px wide in the film, or more.\n\n"
      "Example:\n"
      "  coilwright tag --size-mm 8 --out results/tags.pdf");
  command->callback([options] {
    require_file_for_json(options->json, options->out);
    run_tag(*options);
  });
}

}  // namespace coilwright::cli
