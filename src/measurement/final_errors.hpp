#pragma once

#include <vector>

#include "scored.hpp"

namespace coilwright::measurement {

/// Three finished models on the same runs.
struct ThreeModels {
  Scored declared;  ///< as written
  Scored before;    ///< recalibrated
  Scored after;     ///< with the effects
  double unit{};    ///< chi^2 of `after` that counts as one
};

/// Takes the errors of finished models: the only place in which sealed runs are opened.
class FinalErrors {
 public:
  /// Throws std::invalid_argument naming the run where one does not fit the model: before a diagnosis starts, so that
  /// nobody waits for a refusal. Tells nothing of what the runs hold.
  static void check(const SealedRuns& runs, const DeclaredModel& declared, const actuator::Model& nominal);
  /// Of the validate runs. Throws std::invalid_argument naming the run where one does not fit the model. A run that one
  /// of the models cannot be simulated on is left out with a warning.
  FinalErrors(const SealedRuns& runs, const DeclaredModel& declared, const ThreeModels& models);
  /// Of runs that were fitted.
  FinalErrors(const std::vector<Run>& runs, const DeclaredModel& declared, const ThreeModels& models);

  [[nodiscard]] const std::vector<ErrorComparison>& errors() const noexcept { return errors_; }
  [[nodiscard]] const std::vector<Replay>& replays() const noexcept { return replays_; }
  [[nodiscard]] const std::vector<Warning>& warnings() const noexcept { return warnings_; }

 private:
  void take(const std::vector<Run>& runs, const DeclaredModel& declared, const ThreeModels& models, bool validate);

  std::vector<ErrorComparison> errors_;
  std::vector<Replay> replays_;
  std::vector<Warning> warnings_;
};

}  // namespace coilwright::measurement
