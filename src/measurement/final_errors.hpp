#pragma once

#include <optional>
#include <span>
#include <vector>

#include "coilwright/measurement/data/dataset.hpp"
#include "coilwright/measurement/error_comparison.hpp"
#include "measurement/identification/fitted_hypothesis.hpp"
#include "measurement/replay/prepared_run.hpp"

namespace coilwright::measurement {

/// Three finished models of the same actuator.
struct ThreeModels {
  identification::FittedHypothesis declared;                    ///< as the file declares it
  identification::FittedHypothesis before;                      ///< recalibrated
  identification::FittedHypothesis after;                       ///< with the effects
  double overdispersion{};                                      ///< of the residual of `after`
  std::optional<identification::FittedHypothesis> corrected{};  ///< `after` with a nameless correction of the torque
};

/// The errors of finished models. This class alone can read sealed runs.
class FinalErrors {
 public:
  /// Throws std::invalid_argument naming the run if one does not fit the model: before a diagnosis starts, so that a
  /// set is refused at once. Reveals nothing else about the runs.
  static void require_fits_model(const data::SealedRuns& runs, const replay::DeclaredModel& declared,
                                 const actuator::Model& nominal);
  /// Throws RecordSlip as records::require_no_slip() does of other runs. Reveals nothing else.
  static void require_no_slip(const data::SealedRuns& runs, const replay::DeclaredModel& declared);
  /// What records::unanswered_runs() says of other runs.
  [[nodiscard]] static std::vector<data::Warning> unanswered_runs(const data::SealedRuns& runs,
                                                                  const replay::DeclaredModel& declared);
  /// Sealed runs as finished models take them: with the noise of `still`, errors of their inputs, and outliers set
  /// aside as `after` shows them, whose model error their local numbers are weighed by. They refer to the sealed runs;
  /// only what shows finished models may ask. Throws std::invalid_argument naming the run if one does not fit the
  /// model.
  [[nodiscard]] static std::vector<replay::PreparedRun> prepared(const data::SealedRuns& runs,
                                                                 const replay::DeclaredModel& declared,
                                                                 const actuator::Model& nominal,
                                                                 const identification::FittedHypothesis& after,
                                                                 std::span<const data::Run> still,
                                                                 const replay::SimulationCount& simulations = {});
  /// Errors on the validate runs. Throws std::invalid_argument naming the run if one does not fit the model. A run on
  /// which one of the models cannot be simulated is left out with a warning, and outliers are left out, too. The
  /// clocks, edges and hum of each run are fitted to it for each model, their priors weighed by the model error of the
  /// fit of `after`. `still` are the records of the noise. `simulations` counts what is simulated.
  FinalErrors(const data::SealedRuns& runs, const replay::DeclaredModel& declared, const ThreeModels& models,
              std::span<const data::Run> still, const replay::SimulationCount& simulations = {});
  /// Errors on the fit runs, likewise, without the samples that the fits had set aside, and with the noise that they
  /// weighed them by.
  FinalErrors(std::vector<replay::PreparedRun> runs, const ThreeModels& models);

  [[nodiscard]] const std::vector<ErrorComparison>& errors() const noexcept { return errors_; }
  /// What was left out of them, of each run and channel.
  [[nodiscard]] const std::vector<Outliers>& outliers() const noexcept { return outliers_; }
  [[nodiscard]] const std::vector<Replay>& replays() const noexcept { return replays_; }
  [[nodiscard]] const std::vector<data::Warning>& warnings() const noexcept { return warnings_; }

 private:
  void list_outliers(const replay::PreparedRun& prepared, bool validate);
  void take(std::vector<replay::PreparedRun> runs, const ThreeModels& models, bool validate);

  std::vector<ErrorComparison> errors_;
  std::vector<Replay> replays_;
  std::vector<Outliers> outliers_;
  std::vector<data::Warning> warnings_;
};

}  // namespace coilwright::measurement
