#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "coilwright/measurement/correction/nameless_correction.hpp"
#include "coilwright/measurement/data/dataset.hpp"
#include "coilwright/measurement/error_comparison.hpp"
#include "coilwright/measurement/identification/estimate.hpp"
#include "coilwright/measurement/identification/hinted_effect.hpp"
#include "coilwright/measurement/identification/number_off.hpp"
#include "coilwright/measurement/identification/posterior.hpp"
#include "coilwright/measurement/identification/verdict.hpp"
#include "coilwright/measurement/localise/residual_torque.hpp"
#include "coilwright/measurement/planning/next_experiment.hpp"
#include "coilwright/measurement/replay/declared_model.hpp"
#include "coilwright/measurement/replay/known_fits.hpp"
#include "coilwright/measurement/signals/noise_level.hpp"
#include "coilwright/measurement/signals/whiteness_test.hpp"

namespace coilwright::measurement {

using identification::name_of;
using identification::Verdict;

/// An effect that the diagnosis adds to the declared model.
struct AddedEffect {
  const actuator::EffectKind* kind{};
  std::vector<identification::Estimate> parameters{};
};

/// A declared number with a tolerance, and where the data move it.
struct MovedNumber {
  identification::Estimate estimate{};
  double declared{};   ///< SI
  double tolerance{};  ///< one standard deviation, SI
  bool named{};        ///< whether the data set names the tolerance; otherwise it is a default
  /// Of a number that changes nothing where it is (the closing angle of faces that touch nowhere in the records): the
  /// value nearest to the declared one at which it still changes nothing, SI. Its interval is open beyond.
  std::optional<double> idle_from{};
};

/// The time that one phase of a diagnosis took.
struct Phase {
  std::string name{};
  double seconds{};
  long simulated_runs{};
};

/// Everything that `diagnose` found.
struct Diagnosis {
  Verdict verdict{};
  std::vector<AddedEffect> effects{};
  identification::Posterior
      odds{};  ///< of the hypotheses that were fitted; of those that were compared, where interrupted
  /// Effects beside those that the data hint at, and whose absence they do not show: intervals have what they would do.
  std::vector<identification::HintedEffect> hinted{};
  /// Sets of effects that these data cannot distinguish.
  std::vector<std::vector<const actuator::EffectKind*>> indistinguishable{};
  std::vector<identification::Estimate> calibration{};
  std::vector<MovedNumber> nominal{};  ///< declared numbers within their tolerances, in the order of the model
  /// What the records leave of the numbers together, SI, (n, n): calibration_of() first, then the numbers of each
  /// effect in turn. Zeros in rows and columns of a choice and of what they do not determine. Its standard deviations
  /// are at least those of the intervals.
  Eigen::MatrixXd covariance{};
  /// The probability that declared numbers lie at least as far from what the data say, in the recalibrated model.
  double probability_of_declared = 1.0;
  /// The declared numbers of which one is off by itself, where no effect is reported and that leaves noise: the best
  /// first, those from which these data do not tell it behind it. Empty where none is.
  std::vector<identification::NumberOff> numbers_off{};
  /// How many times the noise the answer was taken to be wrong when tolerances, and what is known of inputs and starts,
  /// were weighed against it; 1: they were weighed against noise.
  double model_error = 1.0;
  std::vector<std::string> held_exact{};  ///< declared numbers of which nothing was assumed but that they are exact
  std::vector<Outliers> outliers{};       ///< those of the fit runs first
  signals::WhitenessResult before{}, after{};
  std::optional<localise::ResidualTorque> residual{};  ///< of the model with the effects; nothing if no run is a motion
  /// A torque without a name, where structure remains (partly_explained, unexplained) and the data carry one. It
  /// decides nothing: verdict and effects are those without it.
  correction::CorrectionOutcome correction{};
  std::optional<planning::NextExperiment> next_experiment{};
  std::vector<ErrorComparison> fit_errors{}, validate_errors{};
  std::vector<Replay> replays{};
  std::vector<signals::NoiseLevel> noise{};
  std::vector<data::Warning> warnings{};
  /// Of the first run that begins far from where the declared model rests; also among the warnings.
  std::optional<data::Warning> far_first_pose{};
  /// Of each run, fitted or not, in which an angle hardly moves where the declared model moves it far, as without
  /// current; also among the warnings.
  std::vector<data::Warning> unanswered_runs{};
  /// Fitted runs with a stretch in which the camera or the tracker stops; their warnings say where.
  std::vector<std::string> frozen_runs{};
  std::vector<Phase> phases{};
};

/// Options of a diagnosis.
struct DiagnosisOptions {
  int threads = 0;          ///< number of threads; 0: as many as the machine has. The result does not depend on it.
  std::uint64_t seed = 1;   ///< random seed for the additional fit starts
  bool as_written = false;  ///< whether records are fitted also where another unit or sign makes far more of them
  std::function<void(const std::string&)>
      progress{};                                    ///< called with one line at a time, never from two threads at once
  std::function<void(const data::Warning&)> warn{};  ///< called with what is wrong with the records, before the work
  /// Called with what is known so far, the verdict being Verdict::incomplete: once the model is recalibrated, and for
  /// each hypothesis that was compared since; never from two threads at once. Nothing that costs a simulation is in it.
  std::function<void(const Diagnosis&)> known{};
  std::shared_ptr<const replay::KnownFits> known_fits{};  ///< of the same question; null: every fit is made
  std::vector<identification::Belief> beliefs{};          ///< of effects of the catalogue, each at most once
  /// Effects that the declared model may lack; the diagnosis refers to their kinds.
  actuator::EffectCatalogue effects = actuator::standard_effects();
};

/// Finds the effects that `declared` lacks to explain the fit runs of `data`. The validate runs are read once, at the
/// end, for the errors. Throws std::invalid_argument naming the run if the data do not fit the model (number of coils
/// or joints, a voltage without a resistance), RecordSlip where they were written in another unit or with another sign
/// than they say, std::runtime_error if the declared model cannot be simulated.
[[nodiscard]] Diagnosis diagnose(const data::Dataset& data, const replay::DeclaredModel& declared,
                                 const DiagnosisOptions& options = {});

}  // namespace coilwright::measurement
