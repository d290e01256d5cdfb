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

/// Runs that no fit and no choice may see. They go in, and come out again in one place only: `FinalErrors`, which takes
/// the errors of models that are finished.
class SealedRuns {
 public:
  SealedRuns() = default;
  explicit SealedRuns(std::vector<Run> runs) : runs_(std::move(runs)) {}
  [[nodiscard]] bool empty() const noexcept { return runs_.empty(); }
  [[nodiscard]] std::size_t count() const noexcept { return runs_.size(); }

 private:
  friend class measurement::FinalErrors;
  std::vector<Run> runs_;
};

/// Something about the data that a reader of the diagnosis should know.
struct Warning {
  std::string run{};   ///< file of the run; empty: the set
  std::string text{};  ///< one line
};

/// A set of records of one actuator.
struct Dataset {
  std::string name{};
  std::vector<Run> fit{};  ///< at least one
  SealedRuns validate;     ///< empty only where the set has a single run in all
  std::vector<std::string>
      held_out{};                   ///< the files that the tool itself held out, where the set names no validate run
  std::vector<Warning> warnings{};  ///< of the reader, about the fit runs
};

}  // namespace coilwright::measurement::data
