#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "cli/signals.hpp"
#include "coilwright/formats/study/study_file.hpp"
#include "coilwright/results/provenance.hpp"
#include "coilwright/sizing/study/study.hpp"
#include "coilwright/sizing/study/yield.hpp"

namespace coilwright::cli {

/// Options of every command that runs a study.
struct StudyOptions {
  std::string study;
  std::string out;
  std::vector<std::string> changes;  ///< "gap_mm=1.2", "/operating_point/duty=0.5"
  int threads = 0;
  bool quiet{false};
  bool json{false};
  bool resume{false};
  bool force{false};
  std::vector<std::string> reuse;   ///< folders whose archives may answer designs
  std::vector<std::string> starts;  ///< folders whose answers a search starts from
  std::optional<std::uint64_t> seed{};
  std::optional<std::size_t> max_evaluations{};
  std::optional<std::string> algorithm{};
  bool answer_only{false};  ///< of size: nothing behind the search
};

/// STUDY.json, --out, --set, --threads, --quiet and --json.
void add_study_options(CLI::App& command, StudyOptions& options);

/// --seed, --max-evaluations and --algorithm, which override what the study says, and --start.
void add_search_options(CLI::App& command, StudyOptions& options);

/// A study and the files that it is made of.
struct StudyInput {
  sizing::Study study;
  results::Provenance provenance;
  bool builds_a_system{};  ///< a gripper, a crawler or a driver
};

/// The study with what the command line changes, and its options in its `search`. Throws InputError, also when it has
/// another number of objectives. `command` and the seed of the provenance are the caller's, as one draws and another
/// does not.
[[nodiscard]] StudyInput read_study(const StudyOptions& options, const formats::ObjectiveCount& objectives);

/// sizing::yield_of() that tells on standard error, behind `about`, how many builds are done.
[[nodiscard]] std::optional<sizing::Yield> yield_with_progress(const sizing::Study& study,
                                                               const sizing::EvaluatedDesign& design,
                                                               sizing::YieldOptions how, bool quiet,
                                                               std::string_view about = {});

/// While it lives, Ctrl-C, SIGTERM and the end of the terminal ask for a stop instead of ending the program.
class Interruption {
 public:
  Interruption();
  [[nodiscard]] std::stop_token token() const { return source_.get_token(); }
  [[nodiscard]] bool requested() const { return source_.stop_requested(); }

 private:
  StopSignal signal_;
  std::stop_source source_;
  std::jthread watch_;  // last: it uses the others
};

}  // namespace coilwright::cli
