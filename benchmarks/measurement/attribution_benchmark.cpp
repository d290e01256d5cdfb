// Diagnoses random sets whose answers are known, prints one line per set and, at the end, which aims are reached. With
// --out it writes the same without times to confusion.csv, sets.csv and summary.txt: equal for the same sets and seed
// on any number of threads.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "attribution/run_case.hpp"
#include "attribution/summary.hpp"
#include "run_program.hpp"

namespace {

struct Settings {
  int sets = 120;
  int first = 0;
  std::uint64_t seed = 1;
  int threads = 2;
  std::string out{};
};

struct Results {
  std::vector<std::optional<attribution::CaseRun>> runs;
  std::vector<std::string> failures;
};

// One set per thread, so that the times are those of a diagnosis with one thread.
Results run_all(const std::vector<attribution::Case>& cases, int threads) {
  Results results;
  results.runs.resize(cases.size());
  std::atomic<std::size_t> next{0};
  std::mutex printing;
  const auto work = [&] {
    for (std::size_t i = next++; i < cases.size(); i = next++) {
      try {
        attribution::CaseRun run = attribution::run_case(cases[i], 1);
        const std::lock_guard lock(printing);
        fmt::print("{}  ({:.1f} s)\n", attribution::set_line(run.outcome), run.seconds_diagnosed);
        std::fflush(stdout);
        results.runs[i] = std::move(run);
      } catch (const std::exception& error) {
        const std::lock_guard lock(printing);
        results.failures.push_back(fmt::format("set {}: {}", cases[i].number, error.what()));
        fmt::print("{}\n", results.failures.back());
      }
    }
  };
  std::vector<std::thread> workers;
  for (int t = 0; t < threads; ++t) workers.emplace_back(work);
  for (std::thread& worker : workers) worker.join();
  return results;
}

void print_times(const Results& results) {
  std::vector<double> diagnosed;
  double made = 0.0;
  std::map<std::string, double> phases;
  for (const auto& run : results.runs) {
    if (!run) continue;
    diagnosed.push_back(run->seconds_diagnosed);
    made = std::max(made, run->seconds_made);
    for (const auto& phase : run->phases) phases[phase.name] += phase.seconds;
  }
  if (diagnosed.empty()) return;
  std::sort(diagnosed.begin(), diagnosed.end());
  double all = 0.0;
  for (const double seconds : diagnosed) all += seconds;
  fmt::print(
      "\ntime of a diagnosis, one thread: median {:.1f} s, longest {:.1f} s; of making a set: at most {:.1f} s\n",
      diagnosed[diagnosed.size() / 2], diagnosed.back(), made);
  for (const auto& [name, seconds] : phases) fmt::print("  {:<24} {:>5.1f} %\n", name, 100.0 * seconds / all);
}

void write(const std::filesystem::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  if (!out.flush()) throw std::runtime_error(fmt::format("{}: cannot be written", file.string()));
}

int run(int argc, char** argv) {
  CLI::App app("Measures whether diagnose finds effects that are hidden in data", "attribution_benchmark");
  Settings settings;
  app.add_option("--sets", settings.sets, "Number of sets")->check(CLI::PositiveNumber)->capture_default_str();
  app.add_option("--first", settings.first, "Number of the first set")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app.add_option("--seed", settings.seed, "Random seed")->capture_default_str();
  app.add_option("--threads", settings.threads, "Number of sets that are diagnosed at once")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--out", settings.out, "Folder for confusion.csv, sets.csv, summary.txt");
  CLI11_PARSE(app, argc, argv);

  const Results results = run_all(attribution::plan(settings.first, settings.sets, settings.seed), settings.threads);
  std::vector<attribution::Outcome> outcomes;
  for (const auto& done : results.runs)
    if (done) outcomes.push_back(done->outcome);
  const std::string summary = attribution::summary(outcomes);
  fmt::print("\n{}", summary);
  print_times(results);
  if (!results.failures.empty()) {
    fmt::print(stderr, "attribution_benchmark: {} of {} sets could not be diagnosed; nothing is written\n",
               results.failures.size(), settings.sets);
    return 1;
  }
  if (!settings.out.empty()) {
    const std::filesystem::path out(settings.out);
    std::filesystem::create_directories(out);
    write(out / "confusion.csv", attribution::confusion_csv(outcomes));
    write(out / "sets.csv", attribution::sets_csv(outcomes));
    write(out / "summary.txt", summary);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("attribution_benchmark", [&] { return run(argc, argv); });
}
