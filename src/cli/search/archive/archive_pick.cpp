#include <CLI/CLI.hpp>
#include <array>
#include <iostream>
#include <memory>

#include "cli/outputs.hpp"
#include "cli/search/archive/opened_archive.hpp"
#include "cli/search/commands.hpp"
#include "coilwright/formats/study/result_files.hpp"
#include "coilwright/text/output/output_file.hpp"

namespace coilwright::cli {
namespace {

struct ArchivePickOptions {
  std::string folder;
  std::int64_t row{};
  std::string out;
  bool force{false};
  bool json{false};
};

}  // namespace

void add_archive_pick(CLI::App& command) {
  auto options = std::make_shared<ArchivePickOptions>();
  CLI::App* pick = command.add_subcommand("pick", "The design of a row as an actuator file, as size writes its answer");
  add_archive_folder(*pick, options->folder);
  add_row_option(*pick, options->row);
  pick->add_option("--out", options->out, "File for the actuator (actuator/1); - is standard output")->required();
  add_force_option(*pick, options->force);
  add_written_json_option(*pick, options->json);
  pick->footer("Example:\n  coilwright archive pick results/fastest_finger --row 17 --out design_17.json");
  pick->callback([options] {
    const archive::Reader archive = opened_archive(options->folder);
    keep_inputs({archive.path()}, {options->out});
    const archive::Row row = row_of(archive, options->row);
    const sizing::DesignProblem problem = problem_of(archive.contents());
    const std::vector<double> point = point_of(problem, archive, row);
    text::OutputFile file(options->out);
    const std::string& study = archive.contents().study;
    file.stream() << formats::design_text(problem, point, problem.evaluate(point),
                                          sizing::is_feasible(row.evaluation) ? study : study + " (infeasible)");
    keep_other(file, options->force);
    file.commit();
    // Standard output has the actuator itself, which is JSON.
    if (options->json && options->out != "-") std::cout << written_json({options->out}).text();
  });
}

}  // namespace coilwright::cli
