#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "cli/outputs.hpp"
#include "cli/parts/commands.hpp"
#include "cli/parts/copied_program.hpp"
#include "cli/parts/part_trial.hpp"
#include "cli/runs/part_run.hpp"
#include "cli/runs/run_files.hpp"
#include "cli/search/sweep_answer.hpp"
#include "cli/search/yield_study.hpp"
#include "coilwright/exports/workflow.hpp"
#include "coilwright/formats/data/dataset_file.hpp"
#include "coilwright/formats/study/study_file.hpp"
#include "coilwright/sizing/study/sweep.hpp"
#include "coilwright/text/argument.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/text/json/document.hpp"
#include "coilwright/text/number.hpp"
#include "coilwright/text/output/output_folder.hpp"

namespace coilwright::cli {
namespace {

namespace fs = std::filesystem;

struct DistributeOptions {
  std::vector<std::string> inputs;
  std::string command = "sweep";
  std::optional<std::size_t> parts;
  std::string out;
  std::vector<std::string> changes;
  std::string options;
  std::string slurm;
  bool force{false};
  bool json{false};
};

// A command whose runs have parts.
struct DividedCommand {
  std::string_view name;
  std::string_view outputs;  // of a part, all but its archive; empty: its folder, which has no archive when it ends
  std::string_view result;   // the last file of the whole
  std::string_view again;    // what makes a part that was begun go on
};
constexpr std::array divided_commands{
    DividedCommand{"sweep", "part.json found.json designs.csv", "result.json", " --resume"},
    DividedCommand{"size",
                   "part.json found.json result.json actuator.json evaluations.csv convergence.csv provenance.json",
                   "seeds.json", " --resume"},
    DividedCommand{"pareto",
                   "part.json found.json result.json front.csv evaluations.csv convergence.csv provenance.json",
                   "seeds.json", " --resume"},
    DividedCommand{"yield", "part.json found.json builds.csv", "result.json", ""},
    DividedCommand{"diagnose", "", "diagnoses.csv", ""}};

// Of makeflow.sh and its workers.
constexpr const char* password_file = "password";

// What distribute gives each part itself, or would need a folder that is not copied.
constexpr std::array<std::string_view, 13> not_for_parts{"--part",  "--out",   "--head",    "--set",    "--threads",
                                                         "--quiet", "--json",  "--force",   "--resume", "--report",
                                                         "--reuse", "--start", "--actuator"};

std::vector<std::string> blank_separated(std::string_view text) {
  std::vector<std::string> words(1);
  for (const char c : text)
    if (c != ' ')
      words.back() += c;
    else if (!words.back().empty())
      words.emplace_back();
  if (words.back().empty()) words.pop_back();
  return words;
}

// Nothing where there is none: the part that is tried says so.
std::optional<double> number_after(std::string_view name, const std::vector<std::string>& words) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == name && i + 1 < words.size()) return text::number_in(words[i + 1]);
    if (words[i].starts_with(name) && words[i][name.size()] == '=')
      return text::number_in(std::string_view(words[i]).substr(name.size() + 1));
  }
  return std::nullopt;
}

// Every word goes through a shell and, of files, through a line of Makeflow.
void require_plain(std::string_view word) {
  constexpr std::string_view signs = "._/+-=:,@%";
  for (const unsigned char c : word)
    if (std::isalnum(c) == 0 && signs.find(static_cast<char>(c)) == std::string_view::npos)
      throw text::argument_error(word, "must have only letters, digits and any of ._/+-=:,@% to be given to parts");
}

void require_options(const CLI::App& command, const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    require_plain(word);
    if (!word.starts_with("--")) continue;
    const std::string name = word.substr(0, word.find('='));
    if (std::ranges::count(not_for_parts, name) > 0)
      throw text::argument_error("--options",
                                 fmt::format("must not have {}, which distribute sets or parts cannot have", name));
    if (command.get_option_no_throw(name) == nullptr)
      throw text::argument_error("--options", fmt::format("{} has no option {}", command.get_name(), name));
  }
}

// From here on, and not through links: a name stays as it was given.
fs::path from_here(const fs::path& given) {
  return fs::absolute(given).lexically_proximate(fs::current_path());
}

// Where a file is, whatever links lead to its folder; one that is itself a link keeps its name.
fs::path placed(const fs::path& file) {
  return fs::canonical(fs::absolute(file).parent_path()) / file.filename();
}

// A data set lies where its files are, so that what they name from there on is beside them, under the name it was
// given.
fs::path placed_set(const fs::path& folder) {
  const fs::path given = (fs::absolute(folder) / "").lexically_normal().parent_path();
  return fs::canonical(folder).parent_path() / given.filename();
}

// A file that parts need, and where they look for it, as if links were not.
struct NeededFile {
  fs::path from;
  fs::path place;
};

NeededFile needed(const fs::path& file) {
  return {.from = file, .place = placed(file)};
}

// A file that another in `folder` names, which lies in `place` for the parts.
NeededFile needed(const fs::path& file, const fs::path& folder, const fs::path& place) {
  return {.from = file, .place = (place / file.lexically_relative(folder)).lexically_normal()};
}

// Files that parts need, copied to one tree in which each finds the others as before.
class CopiedInputs {
 public:
  CopiedInputs(const std::vector<NeededFile>& files, const std::vector<fs::path>& subjects)
      : root_(subjects.front().parent_path()) {
    for (const NeededFile& file : files) {
      while (*file.place.lexically_relative(root_).begin() == "..") root_ = root_.parent_path();
      const auto [known, is_new] = files_.try_emplace(file.place, file.from);
      if (!is_new && !fs::equivalent(known->second, file.from))
        throw text::InputError({.file = file.from.string(),
                                .rule = fmt::format("would be copied to one place with {}: give sets other names",
                                                    known->second.string())});
    }
  }

  [[nodiscard]] std::string name_of(const fs::path& place) const {
    return (fs::path("inputs") / place.lexically_relative(root_)).string();
  }

  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> out;
    for (const auto& [place, from] : files_) out.push_back(name_of(place));
    return out;
  }

  void copy_to(const fs::path& folder) const {
    for (const auto& [place, from] : files_) copy_whole(from, folder / name_of(place));
  }

 private:
  std::map<fs::path, fs::path> files_;  // by their place
  fs::path root_;
};

// What is to be given away.
struct Distribution {
  const DividedCommand& command;
  std::vector<NeededFile> files{};
  std::vector<fs::path> subjects{};  // places; of each part, or of all: a study with perhaps an actuator, or a data set
  std::size_t parts{};
  formats::Machine head{};
  std::string said{};  // of what a part is
};

// Of a file whose own path is relative: a name that is not would lead nowhere from where the files are copied to.
void require_relative(const fs::path& named, const fs::path& by, std::string_view place) {
  if (named.is_absolute())
    throw text::InputError({.file = by.string(),
                            .place = std::string(place),
                            .rule = "must be a path from the folder of this file on, as the files are copied",
                            .value = named.string()});
}

// Of one design on one core of this machine, s.
double seconds_of_a_design(const sizing::DesignProblem& problem) {
  const auto points = sizing::sampled_points(problem, {.drawn = 3, .seed = 2});
  const auto begin = std::chrono::steady_clock::now();
  for (const std::vector<double>& point : points) (void)problem.assess(problem.evaluate(point));
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() /
         static_cast<double>(points.size());
}

std::string share_of_a_sweep(const DistributeOptions& options, const sizing::DesignProblem& problem,
                             std::size_t parts) {
  if (options.options.find("--sample") != std::string::npos) return "";
  require_grid(problem, options.inputs.front());
  const std::size_t share = (problem.point_count() + parts - 1) / parts;
  return fmt::format(", {} designs each, about {:.2g} s on one core like this", share,
                     static_cast<double>(share) * seconds_of_a_design(problem));
}

Distribution distribution_of_a_study(const DistributeOptions& options, const DividedCommand& command) {
  const std::size_t wanted = command.name == "yield" ? 2 : 1;
  if (options.inputs.size() != wanted)
    throw text::argument_error("--as " + std::string(command.name),
                               wanted == 2 ? "needs STUDY.json and ACTUATOR.json" : "needs one STUDY.json");
  if (!options.parts) throw text::argument_error("--parts", "must be given: how many parts the study has");
  const fs::path study = from_here(options.inputs.front());
  const text::InputText file = text::read_text(study, text::json_size_limit);
  const formats::StudyFile read = formats::parse_study_file(
      file.text, file.file, {.changes = wanted == 1 ? options.changes : formats::StudyChanges{}});
  require_relative(read.actuator, study, "/actuator");
  const fs::path folder = study.parent_path(), place = placed(study).parent_path();
  Distribution out{.command = command,
                   .files = {needed(study), needed(read.actuator, folder, place)},
                   .subjects = {placed(study)},
                   .parts = *options.parts};
  if (read.posterior) {
    require_relative(*read.posterior, study, "/spread/posterior");
    out.files.push_back(needed(*read.posterior, folder, place));
  }
  const sizing::DesignProblem problem(read.study);
  if (wanted == 2) {
    out.files.push_back(needed(options.inputs.back()));
    out.subjects.push_back(out.files.back().place);
    out.head = this_machine(sizing::DesignProblem(
        study_of_one({.study = file,
                      .actuator = text::read_text(from_here(options.inputs.back()), text::json_size_limit),
                      .changes = options.changes,
                      .current = number_after("--current-A", blank_separated(options.options))})));
  } else {
    out.head = this_machine(problem);
  }
  out.said = fmt::format("{} parts of {} {}", out.parts, command.name, read.study.name);
  if (command.name == "sweep") out.said += share_of_a_sweep(options, problem, out.parts);
  return out;
}

Distribution distribution_of_sets(const DistributeOptions& options, const DividedCommand& command) {
  if (options.parts) throw text::argument_error("--parts", "must not be given: each data set is a part");
  if (!options.changes.empty()) throw text::argument_error("--set", "must not be given: a diagnosis has none");
  Distribution out{.command = command, .parts = options.inputs.size(), .head = this_machine()};
  for (const std::string& given : options.inputs) {
    const formats::DatasetFile set = formats::read_dataset(from_here(given));
    if (!set.actuator || !fs::exists(*set.actuator))
      throw text::InputError({.file = set.file, .place = "/actuator", .rule = "must name a file that is there"});
    require_relative(*set.actuator, set.file, "/actuator");
    const fs::path folder = fs::path(set.file).parent_path(), place = placed_set(fs::absolute(folder));
    out.subjects.push_back(place);
    for (const fs::path& file : {fs::path(set.file), *set.actuator}) out.files.push_back(needed(file, folder, place));
    for (const fs::path& file : set.run_files) out.files.push_back(needed(file, folder, place));
  }
  out.said = fmt::format("{} data sets to diagnose", out.parts);
  return out;
}

std::vector<std::string> outputs_of(const Distribution& distribution, const std::vector<std::string>& options,
                                    const std::string& folder) {
  if (distribution.command.outputs.empty()) return {folder};
  const auto keep = std::ranges::find(options, "--keep");
  const bool rows_come_last =
      keep != options.end() && keep + 1 != options.end() && keep[1] != "all" && keep[1] != "feasible";
  std::vector<std::string> out;
  for (const std::string& name : blank_separated(distribution.command.outputs))
    if (name != rows_name || !rows_come_last) out.push_back(fmt::format("{}/{}", folder, name));
  return out;
}

exports::Workflow workflow_of(const DistributeOptions& options, const Distribution& distribution,
                              const CopiedInputs& inputs) {
  const std::vector<std::string> words = blank_separated(options.options);
  const DividedCommand& command = distribution.command;
  const bool has_head = !distribution.head.figures.empty();
  exports::Workflow out{.program = "coilwright",
                        .inputs = inputs.names(),
                        .merge = "./coilwright merge result parts/* --force",
                        .result = fmt::format("result/{}", command.result)};
  if (has_head) out.inputs.emplace_back("head.json");
  std::vector<std::string> subjects;
  for (const fs::path& each : distribution.subjects) subjects.push_back(inputs.name_of(each));
  for (const std::string& each : subjects) require_plain(each);
  for (std::size_t number = 1; number <= distribution.parts; ++number) {
    const std::string folder = "parts/" + exports::part_folder(number);
    std::string line = std::string(command.name) + " ";
    line += command.name == "diagnose" ? subjects[number - 1] : fmt::format("{}", fmt::join(subjects, " "));
    for (const std::string& change : options.changes) line += " --set " + change;
    for (const std::string& word : words) line += " " + word;
    line += fmt::format(" --part {}/{} --out {} --threads 1 --quiet{}{}", number, distribution.parts, folder,
                        has_head ? " --head head.json" : "", command.again);
    out.arguments.push_back(std::move(line));
    out.outputs.push_back(outputs_of(distribution, words, folder));
  }
  return out;
}

// Slurm's own, of which the usual ones are named where another is given.
void require_slurm_options(const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    require_plain(word);
    if (!word.starts_with("--") || (word.find('=') == std::string::npos && word != "--exclusive"))
      throw text::argument_error("--slurm", fmt::format("must have options of sbatch such as --time=2:00:00 --mem=2G "
                                                        "--account=lab --partition=short; got {}",
                                                        word));
  }
}

// A long word that nobody guesses: who connects to the port and knows it can run programs on the workers.
std::string password() {
  std::random_device random;
  std::string out;
  for (int i = 0; i < 4; ++i) out += fmt::format("{:08x}", random());
  return out;
}

void require_new(const DistributeOptions& options) {
  std::error_code error;
  if (!options.force && fs::exists(options.out, error) && !fs::is_empty(options.out, error))
    throw text::OutputError(options.out, "it is not empty; --force writes into it, another --out keeps it",
                            text::OutputError::Stage::preparing);
}

void run_distribute(const DistributeOptions& options, const CLI::App& app) {
  const DividedCommand& command = *std::ranges::find(divided_commands, options.command, &DividedCommand::name);
  require_options(*app.get_subcommand(options.command), blank_separated(options.options));
  for (const std::string& change : options.changes) require_plain(change);
  require_slurm_options(blank_separated(options.slurm));
  require_new(options);
  const Distribution distribution =
      command.name == "diagnose" ? distribution_of_sets(options, command) : distribution_of_a_study(options, command);
  const CopiedInputs inputs(distribution.files, distribution.subjects);
  exports::Workflow workflow = workflow_of(options, distribution, inputs);
  workflow.slurm = blank_separated(options.slurm);
  require_part_runs(blank_separated(workflow.arguments.front()), [&](text::OutputFolder& trial) {
    inputs.copy_to(trial.path());
    if (!distribution.head.figures.empty()) trial.write("head.json", formats::to_json(distribution.head).text());
  });
  std::vector<fs::path> copied;
  for (const NeededFile& file : distribution.files) copied.push_back(file.from);
  keep_inputs(copied, run_files_in(options.out));
  text::OutputFolder folder(options.out);
  folder.lock();
  keep_other_run(
      folder.path(), [](std::string_view name) { return name == "workflow.makeflow"; }, options.force);
  // No earlier workflow may run what is replaced now; of what stays, commit() tells.
  std::error_code stays;
  for (const exports::WorkflowFile& file : exports::workflow_files(workflow))
    fs::remove(folder.path() / file.name, stays);
  inputs.copy_to(options.out);
  for (const std::string& name : copy_program(options.out))
    if (name != workflow.program) workflow.inputs.push_back(name);
  if (!distribution.head.figures.empty()) folder.write("head.json", formats::to_json(distribution.head).text());
  for (const exports::WorkflowFile& file : exports::workflow_files(workflow)) folder.write(file.name, file.text);
  folder.write(password_file, password());
  remove_other_run(folder, "");
  remove_other_archive(folder);
  folder.commit("workflow.makeflow");
  fs::permissions(fs::path(options.out) / password_file, fs::perms::owner_read | fs::perms::owner_write, stays);
  if (options.json) {
    const fs::path out = options.out;
    std::cout << written_json({out / "makeflow.sh", out / "slurm.sh", out / "parallel.sh"}).text();
    return;
  }
  std::cout << fmt::format(
      "{}: {}. In this folder:\n"
      "  idle machines    sh makeflow.sh -T wq -p 9123 -r 3 --password {}\n"
      "                   and on each of them, with that file: work_queue_worker --password {} HOST_OF_THIS_MACHINE "
      "9123\n"
      "  a Slurm cluster  sbatch --wait slurm.sh && sh merge.sh; how far it is: sh progress.sh\n"
      "  this machine     sh parallel.sh\n"
      "The result is then in {}.\n",
      printed(options.out), distribution.said, password_file, password_file, printed(fs::path(options.out) / "result"));
}

}  // namespace

void add_distribute_command(CLI::App& app, Outcome&) {
  auto options = std::make_shared<DistributeOptions>();
  CLI::App* command = add_command(app, "distribute");
  command
      ->add_option(
          "STUDY.json", options->inputs,
          "File of a study (study/1); for yield also ACTUATOR.json; for diagnose folders of data sets, each a part")
      ->required();
  std::vector<std::string> words;
  for (const DividedCommand& each : divided_commands) words.emplace_back(each.name);
  add_word(*command, "--as", options->command, std::move(words), "The command whose parts these are (default sweep)");
  add_whole_number(*command, "--parts", options->parts,
                   text::Rule::between(1, static_cast<double>(sizing::most_parts_of_a_run)),
                   "Number of parts; a minute or more of each keeps machines busy");
  command->add_option("--out", options->out, "Folder for the workflow; it is created if it does not exist")->required();
  command
      ->add_option("--set", options->changes,
                   "NAME=VALUE, for every part, as the command itself takes it; may be repeated")
      ->allow_extra_args(false);
  command->add_option("--options", options->options,
                      "Further options of the command, for every part, as one text: \"--keep feasible --sample 1e6\"");
  command->add_option("--slurm", options->slurm,
                      "Options of sbatch for slurm.sh, as one text: \"--time=2:00:00 --mem=2G --account=lab "
                      "--partition=short\" (default --mem=500M)");
  add_force_option(*command, options->force);
  add_written_json_option(*command, options->json);
  command->footer(
      "The folder gets this program with its libraries, the study's files, and the same workflow for three engines, "
      "of\n"
      "which one must be installed: makeflow.sh (Makeflow with Work Queue; also Slurm, SGE, HTCondor), slurm.sh\n"
      "(a job array) and parallel.sh (GNU parallel). Each goes on after a crash of a machine, and ends with merge. "
      "The\n"
      "first part is tried for three seconds: what no part can run with is refused here.\n\n"
      "Example:\n"
      "  coilwright distribute configs/studies/configurations.json --parts 4 --out results/distributed");
  command->callback([options, &app] { run_distribute(*options, app); });
}

}  // namespace coilwright::cli
