#pragma once

#include <vector>

#include "coilwright/measurement/data/dataset.hpp"
#include "coilwright/measurement/error_comparison.hpp"
#include "measurement/compare/fitted_hypothesis.hpp"

namespace coilwright::measurement {

/// Three finished models on the same runs.
struct ThreeModels {
  compare::Scored declared;  ///< as written
  compare::Scored before;    ///< recalibrated
  compare::Scored after;     ///< with the effects
  double unit{};             ///< chi^2 of `after` that counts as one
};

/// Takes the errors of finished models: the only place in which sealed runs are opened.
class FinalErrors {
 public:
  /// Throws std::invalid_argument naming the run where one does not fit the model: before a diagnosis starts, so that
  /// nobody waits for a refusal. Tells nothing of what the runs hold.
  static void check(const data::SealedRuns& runs, const replay::DeclaredModel& declared,
                    const actuator::Model& nominal);
  /// Of the validate runs. Throws std::invalid_argument naming the run where one does not fit the model. A run that one
  /// of the models cannot be simulated on is left out with a warning.
  FinalErrors(const data::SealedRuns& runs, const replay::DeclaredModel& declared, const ThreeModels& models);
  /// Of runs that were fitted.
  FinalErrors(const std::vector<data::Run>& runs, const replay::DeclaredModel& declared, const ThreeModels& models);

  [[nodiscard]] const std::vector<ErrorComparison>& errors() const noexcept { return errors_; }
  [[nodiscard]] const std::vector<Replay>& replays() const noexcept { return replays_; }
  [[nodiscard]] const std::vector<data::Warning>& warnings() const noexcept { return warnings_; }

 private:
  void take(const std::vector<data::Run>& runs, const replay::DeclaredModel& declared, const ThreeModels& models,
            bool validate);

  std::vector<ErrorComparison> errors_;
  std::vector<Replay> replays_;
  std::vector<data::Warning> warnings_;
};

}  // namespace coilwright::measurement
