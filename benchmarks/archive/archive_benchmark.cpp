// What it costs that every evaluation is recorded: the same designs evaluated, evaluated and recorded, and answered
// from the record. Run it where the program is started: it reads configs/studies/speed_against_grip.json.
#include <benchmark/benchmark.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <random>
#include <vector>

#include "coilwright/archive/recorded_study.hpp"
#include "coilwright/formats/study/study_file.hpp"
#include "coilwright/sizing/problem/problem.hpp"

namespace coilwright::archive {
namespace {

constexpr std::size_t designs = 2000;

const sizing::DesignProblem& problem() {
  static const sizing::DesignProblem made(formats::read_study("configs/studies/speed_against_grip.json"));
  return made;
}

// Random designs of the study, the same in every run.
const std::vector<std::vector<double>>& points() {
  static const std::vector<std::vector<double>> made = [] {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    std::vector<std::vector<double>> out(designs);
    for (std::vector<double>& point : out)
      for (const sizing::Variable& variable : problem().problem().variables) {
        const double step = variable.kind == sizing::VariableKind::continuous ? variable.step : 1.0;
        const double away = share(random) * (variable.upper - variable.lower);
        point.push_back(variable.lower + (step > 0.0 ? step * std::floor(away / step) : away));
      }
    return out;
  }();
  return made;
}

// An archive in a folder of its own, and the study through it.
class Run {
 public:
  Run() : folder_(std::filesystem::temp_directory_path() / ("coilwright_benchmark_" + std::to_string(::getpid()))) {
    std::filesystem::create_directories(folder_);
    create(path(), {.command = "pareto", .study = "benchmark", .columns = columns_of(problem().study())});
    open({});
  }
  ~Run() {
    study_.reset();
    std::error_code none;
    std::filesystem::remove_all(folder_, none);
  }
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  void open(std::shared_ptr<const Reader> known) {
    study_.reset();
    study_ = std::make_unique<RecordedStudy>(
        problem(), RecordedStudy::Sources{.writer = std::make_shared<Writer>(path(), designs, Writer::OnRefusal{}),
                                          .known = std::move(known),
                                          .others = {}});
  }
  [[nodiscard]] std::filesystem::path path() const { return folder_ / "archive.sqlite"; }
  [[nodiscard]] RecordedStudy& study() { return *study_; }

 private:
  std::filesystem::path folder_;
  std::unique_ptr<RecordedStudy> study_;
};

void evaluated(benchmark::State& state) {
  for (auto _ : state)
    for (const std::vector<double>& point : points())
      benchmark::DoNotOptimize(problem().assess(problem().evaluate(point)));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(designs));
}
BENCHMARK(evaluated)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

// Until the last one is on the disk.
void evaluated_and_recorded(benchmark::State& state) {
  for (auto _ : state) {
    Run run;
    for (const std::vector<double>& point : points()) benchmark::DoNotOptimize(run.study().evaluate(point));
    run.study().number(run.path(), {});
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(designs));
}
BENCHMARK(evaluated_and_recorded)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

void answered_from_the_record(benchmark::State& state) {
  Run run;
  for (const std::vector<double>& point : points()) benchmark::DoNotOptimize(run.study().evaluate(point));
  run.study().number(run.path(), {});
  for (auto _ : state) {
    run.open(std::make_shared<const Reader>(run.path()));
    for (const std::vector<double>& point : points()) benchmark::DoNotOptimize(run.study().evaluate(point));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(designs));
}
BENCHMARK(answered_from_the_record)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

}  // namespace
}  // namespace coilwright::archive
