#include <CLI/CLI.hpp>
#include <memory>

#include "cli/options.hpp"
#include "cli/outputs.hpp"
#include "cli/parts/commands.hpp"
#include "cli/parts/merge/parts.hpp"
#include "coilwright/text/input_error.hpp"

namespace coilwright::cli {
namespace {

// By the command whose parts they are.
constexpr std::pair<std::string_view, ExitCode (*)(const MergeOptions&, const Parts&)> merges[] = {
    {"sweep", &merge_sweep},
    {"size", &merge_size},
    {"pareto", &merge_pareto},
    {"yield", &merge_yield},
    {"diagnose", &merge_diagnoses}};

ExitCode run_merge(const MergeOptions& options) {
  const Parts parts = parts_of(options);
  for (const auto& [command, merge] : merges)
    if (command == parts.whole.command) return merge(options, parts);
  throw text::InputError({.file = options.parts.front(), .rule = "is a part of a command that has none"});
}

}  // namespace

void add_merge_command(CLI::App& app, Outcome& outcome) {
  auto options = std::make_shared<MergeOptions>();
  CLI::App* command = add_command(app, "merge");
  command->add_option("OUT", options->out, "Folder for the results; it is created if it does not exist")
      ->required()
      ->check(not_empty());
  command->add_option("PART", options->parts, "Folders of all parts (--part K/N of another command), in any order")
      ->required();
  add_force_option(*command, options->force);
  add_json_option(*command, options->json);
  command->footer(
      "Of sweep and yield it writes and prints what the run on one machine does, byte for byte, but for "
      "archive.sqlite\n"
      "(of a yield result.json has what --json prints). Of size it writes the files of the best seed, of pareto the\n"
      "front of all fronts, of both seeds.json; of diagnose diagnoses.csv, a row a data set. Parts\n"
      "that are missing, double, not finished, of another study, option or program, or made by processors that give\n"
      "other numbers, and files that are not as the part wrote them, are named in one line, and nothing is written.\n"
      "OUT must not be a part, nor lie in one.\n\n"
      "Example:\n"
      "  coilwright sweep configs/studies/configurations.json --part 1/2 --out results/part1\n"
      "  coilwright sweep configs/studies/configurations.json --part 2/2 --out results/part2\n"
      "  coilwright merge results/merged results/part1 results/part2");
  command->callback([options, &outcome] { outcome.code = run_merge(*options); });
}

}  // namespace coilwright::cli
