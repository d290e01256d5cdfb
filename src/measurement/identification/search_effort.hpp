#pragma once

#include <cstddef>

#include "measurement/fit/fit_request.hpp"

namespace coilwright::measurement::identification {

/// The constants of the search for effects that were chosen by hand. Each trades simulated runs against the chance to
/// miss the best hypothesis.
struct SearchEffort {
  /// A start is scaled to the strength that the linear screening predicts, at most by these factors. A wider range
  /// follows the prediction further; a weaker effect no longer has the shape of the start, a stronger one leaves the
  /// range in which the prediction holds.
  double weakest_start = 0.02;
  double strongest_start = 3.0;
  /// Residual directions count as dependent if the determinant of their normal equations is below this fraction of the
  /// product of their squares. A larger value rejects effects that are hard to separate; a smaller one divides by
  /// noise.
  double smallest_determinant = 1e-6;

  /// Of each discrete choice the best start is fitted, whatever it predicts: a choice that is wrong may predict ten
  /// times the fall of the right one, whose strength the linearisation does not reach. The runner-up with a choice
  /// needs this fraction of what the best with that choice predicts.
  double runner_up = 0.7;
  /// End of a short fit; its tolerance is a fraction of what there is to gain (ends_by_what_is_left). More iterations
  /// rank the effects more reliably, and each costs one simulation per parameter.
  fit::FitEffort short_fit{.iterations = 8, .tolerance = 1e-2};
  /// A fit takes its derivatives anew where it ended, and goes on as long as they promise more than its tolerance and
  /// its last turn has kept such a promise, at most so often.
  int most_turns = 10;
  /// A fit that has stalled leaps over what may be a kink where so much of chi-square is promised there. A
  /// smaller number costs a turn for what decides nothing; a larger one leaves fits of records with faces where they
  /// stall.
  double worth_a_leap = 2.0;
  /// Effects are tried from the declared numbers too where these are less likely than this after the recalibration.
  double numbers_pulled_away = 0.01;
  /// And where structure remains and one that is fitted freely has moved by more than this share of what was declared:
  /// a mount that gives way made the hinges 30 % softer, from where its own optimum was not reached.
  double free_number_pulled_away = 0.15;
  /// Effects of several numbers are tried from their own starts, too, where they explain less than this fraction of
  /// what is above the noise.
  double next_to_nothing = 0.05;
  /// The largest number of such starts of one effect, those of the largest predicted fall of chi-square.
  std::size_t own_starts = 6;
  /// End of a fit from there, whose way is longer; likewise.
  fit::FitEffort own_start_fit{.iterations = 20, .tolerance = 1e-2};
  /// A short fit that fails, or ends worse than the model without the effect, is repeated with this fraction of the
  /// start's strength, of that fraction, and so on, at most so often.
  double retry_strength = 0.05;
  int most_retries = 3;

  /// End of a fit that is continued to convergence: a thousandth of what decides between two hypotheses, at noise
  /// level.
  fit::FitEffort converged{.iterations = 25, .tolerance = 1e-4};
  /// The same for a hypothesis whose numbers are reported.
  fit::FitEffort exact{.iterations = 25, .tolerance = 1e-5};
  /// An effect of which the screening promises less than this fraction of what the best short fit of an effect explains
  /// gets no other starts: the screening falls short of a true effect by factors of up to four.
  double worth_more_runs = 0.1;
  /// Number of hypotheses, and of combinations of each size, whose screening promises most that are fitted at once.
  std::size_t combinations = 6;
  /// How many of the heaviest hypotheses are screened for one effect more: where the heaviest leaves noise, and where
  /// not.
  std::size_t extended_from_noise = 3;
  std::size_t extended = 10;
  /// The weight, over that of the heaviest, of which what promises less is not worth a fit.
  double least_weight = 0.01;
  /// Number of hypotheses after which the search ends.
  std::size_t most_hypotheses = 100;
  /// How many of the heaviest hypotheses start from each other's numbers, and from how many of these places each is
  /// fitted: those where its objective is lowest.
  std::size_t heaviest = 8;
  std::size_t heaviest_of_wrong = 4;  ///< where none leaves noise, and many hold a little weight
  std::size_t settling_starts = 2;
  /// Number of the heaviest hypotheses that are fitted again from other starts: where one leaves noise, or is far from
  /// it, and where not.
  std::size_t restarted = 2;
  std::size_t reconsidered = 4;
  /// Near the noise one is fitted again only if its objective is no further from the least than this: other optima of
  /// an attraction or a stop gained 30 to 80 on records of four short runs.
  double other_optima_gain = 100.0;
  /// Number of hypotheses that were compared on some windows and are judged on all.
  std::size_t judged_on_all = 9;
  /// Numbers of an effect that are scattered for another start are drawn within this factor. More covers a cost
  /// function that is not convex; less stays near what was found.
  double scatter = 3.0;
  /// Strength of the effects, over that of the fit, from which they are fitted again.
  double weaker_restart = 0.3;
  /// Largest number of effects in one hypothesis.
  std::size_t largest_hypothesis = 3;

  /// End of each fit along a profile likelihood.
  fit::FitEffort profile{.iterations = 8, .tolerance = 1e-6};
  /// Where such a fit ends outside the limit it takes its derivatives anew and goes on, at most so often.
  int most_profile_turns = 3;
  /// A model is near the noise where its rms residual is at most so many times it. Further away profiles keep their
  /// derivatives, and an effect's own starts are left out: what they gain there does not make an answer right, and
  /// costs most on long records.
  double near_the_noise = 3.0;
  /// Where the recalibrated model leaves more than so many times the noise, hypotheses are compared with priors that
  /// are weighed by what it leaves. Less, and effects may reach the noise, against which they are to be weighed.
  double weighs_model_error = 10.0;
  /// There the search uses some windows of long records, so that about so many samples of all runs together remain,
  /// and at least so many windows of each run; what it finds is fitted and judged on all of them.
  std::size_t thinned_samples = 4000;
  std::size_t fewest_windows = 6;
  /// If the answer leaves less than this fraction of that, they held too much: the comparison begins anew with its own.
  double much_less_model_error = 0.1;
  /// Fall of chi-square, in units of the overdispersion, that counts as a better optimum than that of the fit; smaller
  /// differences are within the tolerance of fits.
  double better_optimum = 0.2;
  /// An interval with an end nearer to the estimate than this fraction of it may be that of one local optimum among
  /// many: fits start along the number (local_optima_along), up to so many on each side, each so far from the next, as
  /// a fraction, and the best are refined; at a better optimum that is done once more. Towards the effect's absence as
  /// far as so many steps, in larger ones, where all local optima until there fit as well.
  double too_narrow = 0.005;
  int scan_starts = 11;
  int farthest_scan = 76;
  int far_scan_steps = 5;
  double scan_step = 0.04;
  std::size_t refined_optima = 2;
  int optima_searches = 2;
  /// Number of times that the intervals are taken anew at a better optimum.
  int largest_number_of_moves = 8;
};
inline constexpr SearchEffort search_effort{};

}  // namespace coilwright::measurement::identification
