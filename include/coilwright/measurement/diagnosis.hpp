#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/actuator/effect_catalogue.hpp"
#include "coilwright/measurement/compare/estimate.hpp"
#include "coilwright/measurement/compare/evidence.hpp"
#include "coilwright/measurement/data/dataset.hpp"
#include "coilwright/measurement/error_comparison.hpp"
#include "coilwright/measurement/experiment/next_experiment.hpp"
#include "coilwright/measurement/localise/residual_torque.hpp"
#include "coilwright/measurement/noise/noise_level.hpp"
#include "coilwright/measurement/replay/declared_model.hpp"
#include "coilwright/measurement/whiteness/whiteness_test.hpp"

namespace coilwright::measurement {

/// What a diagnosis says of a model; see docs/theory/measurement.md for the rules behind each.
enum class Verdict {
  no_missing_effect,  ///< the recalibrated declared model already reaches the noise
  explained,          ///< with the effects the residual is noise
  partly_explained,   ///< an effect helps significantly, structure remains
  unexplained         ///< structure remains and no candidate is supported
};

/// "partly_explained".
[[nodiscard]] std::string_view name_of(Verdict verdict);

/// An effect that was added.
struct AddedEffect {
  const actuator::EffectKind* kind{};
  std::vector<compare::Estimate> parameters{};
  compare::Evidence evidence{};
};

/// Where the time of a diagnosis went.
struct Phase {
  std::string name{};
  double seconds{};
  long simulated_runs{};
};

/// Everything `diagnose` found.
struct Diagnosis {
  Verdict verdict{};
  std::vector<AddedEffect> effects{};  ///< in the order in which they were added
  std::vector<std::vector<const actuator::EffectKind*>>
      indistinguishable{};  ///< sets that these data cannot tell apart
  std::vector<compare::Estimate> calibration{};
  std::vector<compare::Candidate> candidates{};
  whiteness::Adequacy before{}, after{};
  std::optional<localise::ResidualTorque> residual{};  ///< of `after`; nothing where no run has a motion
  std::optional<experiment::NextExperiment> next_experiment{};
  std::vector<ErrorComparison> fit_errors{}, validate_errors{};
  std::vector<Replay> replays{};
  std::vector<noise::NoiseLevel> noise{};
  std::vector<data::Warning> warnings{};
  std::vector<Phase> phases{};
};

/// How to go about it.
struct DiagnosisOptions {
  int threads = 0;         ///< 0: as many as the machine has; the answer is the same for any number
  std::uint64_t seed = 1;  ///< of the starts that are drawn beside those that effects propose
  std::function<void(const std::string&)> progress{};  ///< called with one line, from one thread at a time
  /// Effects that the declared model may lack; the diagnosis refers to their kinds.
  actuator::EffectCatalogue effects = actuator::standard_effects();
};

/// Finds what `declared` lacks to explain the fit runs of `data`, and reads the validate runs once, at the end, for the
/// errors. Throws std::invalid_argument naming the run where the data do not fit the model (number of coils or joints,
/// a voltage without a resistance), std::runtime_error where the declared model cannot be simulated.
[[nodiscard]] Diagnosis diagnose(const data::Dataset& data, const replay::DeclaredModel& declared,
                                 const DiagnosisOptions& options = {});

}  // namespace coilwright::measurement
