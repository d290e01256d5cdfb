// Diagnoses the sets of a laboratory, whose answers are known, with the command line program, and counts how often it
// is right. Each outcome is a file of its own in --out: a run that was stopped goes on where it was, and several runs
// may share the work. summary.txt has no times: the same bytes for any number of threads.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "attribution/laboratory/outcome_file.hpp"
#include "attribution/laboratory/run_case.hpp"
#include "attribution/laboratory/summary.hpp"
#include "attribution/laboratory/visible_strength.hpp"
#include "coilwright/exports/workflow.hpp"
#include "run_program.hpp"
#include "truth/laboratory/laboratory_set.hpp"

namespace {

namespace laboratory = attribution::laboratory;

struct Settings {
  laboratory::PlanName plan = laboratory::PlanName::development;
  std::string program{};
  std::string out{};
  std::string values{};
  std::string sets{};
  std::uint64_t seed = 0;
  bool plans = false;
  int first = 0;
  int count = 1000000;
  int jobs = 2;
  int threads = 1;
  std::string workflow{};
};

std::filesystem::path file_of(const Settings& settings, const laboratory::Case& asked) {
  return std::filesystem::path(settings.out) / "outcomes" / fmt::format("{:04}.json", asked.number);
}

laboratory::Case at_wanted_strength(laboratory::Case asked, const Settings& settings) {
  if (!settings.plans || asked.category != laboratory::Category::one || asked.request.at_bound) return asked;
  if (const auto value = laboratory::five_times_visible(asked, settings.program, settings.threads))
    asked.request.values = {*value};
  return asked;
}

// Every job has one diagnosis at a time. Returns the number of failures.
int run_all(const std::vector<laboratory::Case>& cases, const Settings& settings) {
  std::atomic<std::size_t> next{0};
  std::atomic<int> failures{0};
  std::mutex printing;
  const auto work = [&] {
    for (std::size_t i = next++; i < cases.size(); i = next++) {
      if (std::filesystem::exists(file_of(settings, cases[i]))) continue;
      try {
        const laboratory::Outcome outcome =
            laboratory::run_case(at_wanted_strength(cases[i], settings), settings.program, settings.threads);
        laboratory::write_outcome(outcome, file_of(settings, cases[i]));
        const std::lock_guard lock(printing);
        fmt::print("{}  ({:.1f} s)\n", laboratory::set_line(outcome), outcome.seconds);
        std::fflush(stdout);
      } catch (const std::exception& error) {
        ++failures;
        const std::lock_guard lock(printing);
        fmt::print("set {} could not be diagnosed: {}\n", cases[i].number, error.what());
        std::fflush(stdout);
      }
    }
  };
  std::vector<std::thread> workers;
  for (int t = 0; t < settings.jobs; ++t) workers.emplace_back(work);
  for (std::thread& worker : workers) worker.join();
  return failures;
}

void write_sets(const std::vector<laboratory::Case>& cases, const Settings& settings) {
  const std::filesystem::path folder = settings.sets;
  for (const laboratory::Case& each : cases) {
    const auto set = truth::laboratory::make_laboratory_set(at_wanted_strength(each, settings).request);
    truth::laboratory::write_laboratory_set(set, folder / fmt::format("{:04}", each.number));
    truth::laboratory::write_experiment(set, folder / fmt::format("{:04}_experiment", each.number));
    truth::laboratory::write_answer(set, folder / fmt::format("{:04}_answer.json", each.number));
  }
}

// A part a set, as `coilwright distribute` divides a study. Every part and the merging get the arguments of this call
// but --workflow, so that sets and strengths are the same; an outcome is a file of its own, and the last step finds
// all.
void write_workflow(const std::vector<laboratory::Case>& cases, const Settings& settings,
                    const std::vector<std::string>& shared) {
  const std::filesystem::path folder = settings.workflow;
  std::filesystem::create_directories(folder);
  std::filesystem::copy_file(settings.program, folder / "coilwright", std::filesystem::copy_options::update_existing);
  std::filesystem::copy_file("/proc/self/exe", folder / "laboratory_benchmark",
                             std::filesystem::copy_options::update_existing);
  const std::string common = fmt::format("--program ./coilwright --jobs 1 {}", fmt::join(shared, " "));
  coilwright::exports::Workflow workflow{
      .program = "laboratory_benchmark",
      .inputs = {"coilwright"},
      .merge = fmt::format("mkdir -p result/outcomes && cp parts/*/outcomes/*.json result/outcomes && "
                           "./laboratory_benchmark {} --first {} --sets {} --out result",
                           common, settings.first, settings.count),
      .result = "result/summary.txt"};
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const std::string out = "parts/" + coilwright::exports::part_folder(i + 1);
    workflow.arguments.push_back(fmt::format("{} --first {} --sets 1 --out {}", common, cases[i].number, out));
    workflow.outputs.push_back({fmt::format("{}/outcomes/{:04}.json", out, cases[i].number)});
  }
  for (const auto& [name, text] : coilwright::exports::workflow_files(workflow))
    std::ofstream(folder / name, std::ios::binary) << text;
}

// Those that decide which sets there are and what they hide, as they were given.
std::vector<std::string> shared_arguments(int argc, char** argv) {
  std::vector<std::string> out;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    const bool is_whole = argument.starts_with("--plan=") || argument.starts_with("--seed=");
    if (argument == "--five-times-visible" || is_whole) out.push_back(argument);
    if (argument == "--plan" || argument == "--seed") out.insert(out.end(), {argument, argv[++i]});
  }
  return out;
}

int run(int argc, char** argv) {
  CLI::App app("Measures whether diagnose stays true on records as laboratories make them", "laboratory_benchmark");
  Settings settings;
  app.add_option("--plan", settings.plan, "development, kept for the end, or each effect alone")
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, laboratory::PlanName>{{"development", laboratory::PlanName::development},
                                                      {"kept", laboratory::PlanName::kept},
                                                      {"each_effect", laboratory::PlanName::each_effect}}));
  app.add_option("--seed", settings.seed,
                 "Draws other sets of the same plan, which nobody has seen (default 0: its own)")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--program", settings.program, "The program coilwright")->check(CLI::ExistingFile);
  app.add_option("--out", settings.out, "Folder of the outcomes and of summary.txt");
  app.add_option(
      "--values", settings.values,
      "JSON object: by the number of a set of one effect the value to hide, in the unit of its first number");
  app.add_flag("--five-times-visible", settings.plans,
               "Hide single effects at five times what the program's plan of each experiment says could be seen");
  app.add_option("--write-sets", settings.sets, "Only write the sets, their experiments and answers into this folder");
  app.add_option("--first", settings.first, "Number of the first set")->check(CLI::NonNegativeNumber);
  app.add_option("--sets", settings.count, "Number of sets (default all)")->check(CLI::PositiveNumber);
  app.add_option("--jobs", settings.jobs, "Diagnoses at once")->check(CLI::PositiveNumber)->capture_default_str();
  app.add_option("--threads", settings.threads, "Threads of each")->check(CLI::PositiveNumber)->capture_default_str();
  app.add_option("--workflow", settings.workflow,
                 "Only write a workflow of these diagnoses for other machines into this folder (Makeflow, Slurm, GNU "
                 "parallel), which have the packages of scripts/setup.sh");
  CLI11_PARSE(app, argc, argv);

  laboratory::Values values;
  if (!settings.values.empty()) {
    std::ifstream in(settings.values);
    const nlohmann::json parsed = nlohmann::json::parse(in);  // named: items() only refers to it
    for (const auto& [number, value] : parsed.items()) values[std::stoi(number)] = value;
  }
  std::vector<laboratory::Case> cases;
  for (laboratory::Case& each : laboratory::plan(settings.plan, values, settings.seed))
    if (each.number >= settings.first && each.number - settings.first < settings.count)
      cases.push_back(std::move(each));
  const bool distributes = !settings.workflow.empty(), writes_only = !settings.sets.empty();
  if ((!writes_only && (settings.program.empty() || (settings.out.empty() && !distributes))) ||
      (settings.plans && settings.program.empty())) {
    fmt::print(stderr, "laboratory_benchmark: --program{} needed\n", writes_only ? " is" : " and --out are");
    return 2;
  }
  if (writes_only) {
    write_sets(cases, settings);
    return 0;
  }
  if (distributes && !settings.values.empty()) {
    fmt::print(stderr, "laboratory_benchmark: --values is a file of this machine: leave it out with --workflow\n");
    return 2;
  }
  if (distributes) {
    write_workflow(cases, settings, shared_arguments(argc, argv));
    return 0;
  }
  const std::filesystem::path outcomes = std::filesystem::path(settings.out) / "outcomes";
  std::filesystem::create_directories(outcomes);
  const int failures = run_all(cases, settings);

  const std::vector<laboratory::Outcome> all = laboratory::read_outcomes(outcomes);
  const std::string text = laboratory::summary(all);
  std::ofstream(std::filesystem::path(settings.out) / "summary.txt", std::ios::binary) << text;
  fmt::print("\n{}\n{}", text, laboratory::times(all));
  if (failures > 0) fmt::print(stderr, "laboratory_benchmark: {} sets could not be diagnosed\n", failures);
  return failures > 0 ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("laboratory_benchmark", [&] { return run(argc, argv); });
}
