#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "coilwright/measurement/data/run.hpp"

namespace coilwright::measurement {
class FinalErrors;
}

namespace coilwright::measurement::data {

/// Runs that no fit and no selection may see. Only `FinalErrors`, which takes the errors of finished models, can read
/// them.
class SealedRuns {
 public:
  SealedRuns() = default;
  /// Seals `runs`.
  explicit SealedRuns(std::vector<Run> runs) : runs_(std::move(runs)) {}
  [[nodiscard]] bool empty() const noexcept { return runs_.empty(); }
  [[nodiscard]] std::size_t count() const noexcept { return runs_.size(); }

 private:
  friend class measurement::FinalErrors;
  std::vector<Run> runs_;
};

/// Something about the data that a reader of the diagnosis should know.
struct Warning {
  std::string run{};   ///< file of the run; empty if the warning concerns the whole set
  std::string text{};  ///< one line
};

/// A set of records of one actuator.
struct Dataset {
  std::string name{};
  std::vector<Run> fit{};    ///< at least one
  SealedRuns validate;       ///< empty only if the set has a single run in all
  std::vector<Run> still{};  ///< records in which nothing moves; never held out
  std::vector<std::string>
      held_out{};                   ///< files that with_runs_held_out() sealed because the set names no validate run
  std::vector<Warning> warnings{};  ///< warnings of the reader about the fit runs
};

}  // namespace coilwright::measurement::data
