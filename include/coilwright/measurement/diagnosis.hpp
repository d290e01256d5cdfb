#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/actuator/effect.hpp"
#include "coilwright/measurement/dataset.hpp"
#include "coilwright/measurement/declared_model.hpp"

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

/// A fitted number.
struct Estimate {
  std::string key{};         ///< with its unit, as the report writes it
  double denominator = 1.0;  ///< SI value = value in the key's unit / denominator
  double value{};            ///< SI
  double lower{};            ///< of the 95 % interval, SI; -infinity where the data set no bound
  double upper{};
  bool determined = true;  ///< false: the interval reaches a physical bound on both sides, or there is none
  bool chosen = false;     ///< one of a few choices: each was tried, and the interval is the value alone
};

/// How much an effect explains, on the fit runs.
struct Evidence {
  double chi_square_before{};  ///< sum of squared residuals over the noise variance, without it
  double chi_square_after{};   ///< with it, everything fitted anew
  double criterion_gain{};     ///< fall of the criterion (chi^2 over correlation time, plus the charge for parameters)
  double cross_validated_gain{};  ///< share of the held-out squared residual above the noise that it removes; NaN if
                                  ///< the set has a single fit run
  double correlation_time{};      ///< samples of the residual that count as one
};

/// An effect that was added.
struct AddedEffect {
  const actuator::EffectKind* kind{};
  std::vector<Estimate> parameters{};
  Evidence evidence{};
};

/// One of the hypotheses that were compared, best first.
struct Candidate {
  std::vector<const actuator::EffectKind*> effects{};
  std::optional<Evidence> evidence{};  ///< nothing where it was ruled out without a fit
  std::string
      remark{};  ///< why it is out: "interval includes absent", "does not fit this rig: ..."; empty if it is not
};

/// How much of the residual torque's variance one variable explains by itself (binned means, against chance).
struct Dependence {
  std::string variable{};          ///< "angle", "rate", "sign of rate", "current", "current history", "time", ...
  double explained{};              ///< 0 to 1, on samples that the bins were not made from
  std::vector<double> at{};        ///< centres of the bins, SI
  std::vector<double> residual{};  ///< mean residual torque there, N m
};

/// What is left over by the model, as a generalised torque over the measured motion.
struct ResidualTorque {
  double rms{};                           ///< N m
  double smallest_visible{};              ///< what noise alone gives, N m
  std::vector<Dependence> dependences{};  ///< strongest first
  std::optional<double> frequency{};      ///< of the strongest line in its spectrum, Hz
};

/// Whether a residual is noise.
struct Adequacy {
  double level{};       ///< rms residual over noise
  double structure{};   ///< statistic of the test for whiteness over its limit; above 1: not white
  std::string where{};  ///< run and scale at which it is worst
  [[nodiscard]] bool noise_only() const { return structure <= 1.0; }
};

/// The run that would separate what these data cannot.
struct NextExperiment {
  std::string kind{};   ///< from the menu: "release", "hot_hold", ...
  std::string input{};  ///< what to command, with numbers
  std::string why{};
  double separation{};  ///< rms difference of the rivals' predictions over the noise
};

/// Of one quantity, SI.
struct Errors {
  double mae{};
  double rmse{};
  double max{};
};

/// Errors of the three models on the same runs.
struct ErrorComparison {
  Quantity quantity{};
  std::size_t samples{};
  Errors declared{}, before{}, after{};
  double noise_floor_rmse{};
  /// Of `after`: what the uncertainty of its fitted numbers leaves open on these runs (one standard deviation, to first
  /// order, rms over the samples).
  double uncertainty_rmse{};
};

/// One channel of one run with the three predictions, SI: for residuals.csv and pictures.
struct Replay {
  std::string run{};
  bool validate{};
  Quantity quantity{};
  std::string channel{};
  std::vector<double> at{};  ///< s, or rad or A on a bench without time
  std::vector<double> measured{}, declared{}, before{}, after{};
};

/// The noise of one channel of a run.
struct NoiseLevel {
  std::string run{};
  std::string channel{};
  double sigma{};        ///< SI
  bool given{};          ///< by the set, not estimated
  std::string source{};  ///< "given", or how it was estimated
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
  std::vector<Estimate> calibration{};
  std::vector<Candidate> candidates{};
  Adequacy before{}, after{};
  std::optional<ResidualTorque> residual{};  ///< of `after`; nothing where no run has a motion
  std::optional<NextExperiment> next_experiment{};
  std::vector<ErrorComparison> fit_errors{}, validate_errors{};
  std::vector<Replay> replays{};
  std::vector<NoiseLevel> noise{};
  std::vector<Warning> warnings{};
  std::vector<Phase> phases{};
};

/// How to go about it.
struct DiagnosisOptions {
  int threads = 0;         ///< 0: as many as the machine has; the answer is the same for any number
  std::uint64_t seed = 1;  ///< of the starts that are drawn beside those that effects propose
  std::function<void(const std::string&)> progress{};  ///< called with one line, from one thread at a time
};

/// Finds what `declared` lacks to explain the fit runs of `data`, and reads the validate runs once, at the end, for the
/// errors. Throws std::invalid_argument naming the run where the data do not fit the model (number of coils or joints,
/// a voltage without a resistance), std::runtime_error where the declared model cannot be simulated.
[[nodiscard]] Diagnosis diagnose(const Dataset& data, const DeclaredModel& declared,
                                 const DiagnosisOptions& options = {});

}  // namespace coilwright::measurement
