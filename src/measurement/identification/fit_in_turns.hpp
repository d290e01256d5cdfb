#pragma once

#include <optional>
#include <span>

#include "measurement/identification/fitted_hypothesis.hpp"

namespace coilwright::measurement::identification {

/// A hypothesis to be fitted and the point at which its fit starts. Refers to the fits from which it takes local
/// numbers and derivatives.
struct PlannedFit {
  fit::Hypothesis hypothesis;
  Eigen::VectorXd start{};
  const fit::Fit* local_numbers_from{};  ///< null: from the measurement
  const fit::Fit* derivatives_from{};    ///< as fit::FitRequest has it; null: all are taken where it starts
};
/// Refers to `plan`.
[[nodiscard]] fit::FitRequest fit_request_of(std::span<const replay::PreparedRun> runs, const PlannedFit& plan);

/// Whether derivatives that may be kept from one fit to the next cost much: of declared numbers, or of local numbers
/// that move the model.
[[nodiscard]] bool has_slow_derivatives(std::span<const replay::PreparedRun> runs,
                                        const replay::DeclaredModel& declared);

/// How far the objective would still fall, were it as the derivatives of a fit say where it ended.
[[nodiscard]] double promised_fall(const fit::Fit& fitted);

/// A fit that goes on turn by turn. Where derivatives cost much, they are taken where a turn begins and follow it to
/// its end. With derivatives of another place a fit ends where these see no way down, which is near its optimum only if
/// they have hardly changed: they are taken anew there, and another turn begins as long as they promise more. Where no
/// step goes down although they promise it, the objective has a kink, as where faces begin to touch: the fit leaps to
/// where they promise the least, and comes back where that leads to nothing better. Where they cost little there is one
/// turn.
class FitInTurns {
 public:
  /// Refers to `runs` and to what `plan` refers to.
  FitInTurns(std::span<const replay::PreparedRun> runs, PlannedFit plan, const fit::FitEffort& effort);

  /// One turn more. False if it was the last: no further one promises anything, or the model cannot be simulated.
  bool turn();
  /// All turns that are left.
  void finish();
  /// The fit as far as it has come, with the derivatives of there; null before the first turn, and if there is none.
  [[nodiscard]] const fit::Fit* reached() const { return reached_ ? &*reached_ : nullptr; }
  /// Ends the fit where it is; nothing if the model could not be simulated.
  [[nodiscard]] std::optional<FittedHypothesis> result() &&;

 private:
  bool whole_fit();
  bool turn_with_kept_derivatives();
  bool leap(const Eigen::VectorXd& step);

  std::span<const replay::PreparedRun> runs_;
  PlannedFit plan_;
  fit::FitEffort effort_;
  std::optional<fit::Fit> reached_{};
  std::optional<fit::Fit> behind_kink_{};  // where the next turn begins, if not where the last one ended
  int turns_ = 0;
};

}  // namespace coilwright::measurement::identification
