#pragma once

namespace coilwright::measurement::compare {

/// The constants that decide which effects are reported. They trade false effects against missed ones.
struct DecisionThresholds {
  /// A smaller gain of the quasi-BIC decides nothing: odds of 20 to 1 (Kass and Raftery 1995, "strong").
  double decisive_gain = 6.0;
  /// If structure remains: the fraction of the chi-square above the noise that the first effect and each later one must
  /// remove. With enough samples every flexible term is significant; a term that does not halve the remainder of a
  /// model that is known to be incomplete takes the shape of what is missing.
  double least_explained = 0.2;
  double least_explained_later = 0.5;
  /// The same where only one run was fitted: none that is left out in turn can contradict it, so it must leave half as
  /// much. On a real axis a stop at one end took away 50 % of what friction leaves, made the run that no fit has seen 6
  /// % worse, and moved the friction away from what is published.
  double least_explained_of_one_run = 0.75;
  /// Where the run that shows an effect is the only one to tell its numbers, it may make the others worse by this
  /// fraction of what they have above the noise (or of the noise's standard deviation, where they have next to
  /// nothing).
  double chance_on_runs_left_out = 0.05;
  /// If what remains passes as noise: the fraction of the whole chi-square that one more effect must promise to remove.
  /// Less changes the rms residual by under 3 %, which is what a model's own errors do (another law of friction, say).
  double least_of_noise = 0.05;
  /// Declared numbers that so few of the rigs built to their tolerances would have are off.
  double least_probability = 0.01;
};
inline constexpr DecisionThresholds decision_thresholds{};

}  // namespace coilwright::measurement::compare
