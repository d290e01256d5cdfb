#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cstddef>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "cli/options.hpp"
#include "cli/outputs.hpp"
#include "cli/page/commands.hpp"
#include "cli/page/page_output.hpp"
#include "cli/report_option.hpp"
#include "cli/runs/run_files.hpp"
#include "coilwright/results/page/page_file.hpp"
#include "coilwright/results/provenance.hpp"

namespace coilwright::cli {
namespace {

struct ReportCommandOptions {
  std::string folder;
  std::optional<std::string> out;
  std::optional<std::size_t> pictures;
  std::optional<std::string> figures;
  bool force{false};
  bool json{false};
};

// All that a page is made of: what a folder of results has beside its pages.
std::vector<std::filesystem::path> results_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> out;
  std::error_code none;  // a folder that is not there is refused where it is read
  for (const std::filesystem::directory_entry& each : std::filesystem::directory_iterator(folder, none))
    if (each.path().extension() != ".html") out.push_back(each.path());
  return out;
}

// What lies there under names of results; of seeds.json, which merge puts beside the files of a seed, no page is made.
std::vector<std::filesystem::path> results_present(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> out = files_of_part_in(folder);
  std::erase(out, folder / "seeds.json");
  return out;
}

void run_report(const ReportCommandOptions& options) {
  const std::filesystem::path folder(options.folder);
  const std::filesystem::path file = options.out ? std::filesystem::path(*options.out) : folder / report_name;
  PageOutput how{.force = options.force};
  keep_inputs(results_in(folder), {file});
  std::error_code none;
  if (std::filesystem::is_directory(folder, none)) require_writable({file});
  std::optional<text::OutputFolder> figures;
  if (options.figures) how.figures = figures.emplace(*options.figures).path();
  write_page(results::page_of_folder(folder, options.pictures, results_present(folder)), file, how);
  if (const std::string why = results::why_unchecked(folder); !why.empty())
    std::cerr << fmt::format("coilwright: {}\n", why);
  if (options.json)
    std::cout << written_json({file}).text();
  else
    std::cout << printed(file) << '\n';
}

}  // namespace

void add_report_command(CLI::App& app, Outcome&) {
  auto options = std::make_shared<ReportCommandOptions>();
  CLI::App* command = add_command(app, "report");
  command->add_option("DIR", options->folder, "Folder that size, sweep, pareto or diagnose has written")->required();
  command->add_option("--out", options->out, "HTML file to write (default DIR/report.html)")
      ->check(page_name_complaint);
  add_force_option(*command, options->force);
  add_written_json_option(*command, options->json);
  add_whole_number(*command, "--pictures", options->pictures, text::Rule::between(1, 1e6),
                   "Number of designs of a front that are drawn and simulated, evenly along it (default 200)");
  command
      ->add_option(
          "--figures", options->figures,
          "Folder for each figure as a file of its own: SVG, and charts as Vega-Lite as well; charts are drawn by\n"
          "Node, where it is installed")
      ->check(not_empty());
  command->footer(
      "Writes one HTML file that works without a network, and prints its name. Of size: verdict, design in section\n"
      "and in motion, limits, sensitivities, assumptions. Of sweep: the best designs, what each variable does, which\n"
      "limits decide. Of pareto: the designs of the front in linked views, each to be saved as an actuator file. Of\n"
      "diagnose: each run as measured and predicted, what is left over, the hypotheses, and the run that would\n"
      "separate them. Sections and motions of pareto and sweep need the study where provenance.json names it. Vega\n"
      "draws it, which the program carries if it was built where npm is.\n\n"
      "Example:\n"
      "  coilwright report results/fastest_finger");
  command->callback([options] { run_report(*options); });
}

}  // namespace coilwright::cli
