#include "measurement/diagnosis_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "coilwright/simulation/equilibrium.hpp"
#include "coilwright/simulation/modes.hpp"
#include "measurement/data/median_interval.hpp"
#include "measurement/fit/hypothesis.hpp"
#include "measurement/replay/if_possible.hpp"
#include "measurement/replay/input_whitener.hpp"

namespace coilwright::measurement {
namespace {

// A residual or an error that exceeds the noise by this factor, or is smaller by it, is reported.
constexpr double notable_ratio = 1.5;
// An error on validate runs is larger than before if it grows by more than this fraction of the noise.
constexpr double notable_growth = 0.1;

// Why the error of a model that explains the fit runs is larger than the noise on others.
std::string reason_for_larger_error(const ErrorComparison& errors) {
  constexpr double deviations = 2.0;
  const double expected = std::hypot(errors.noise_floor_rmse, deviations * errors.uncertainty_rmse);
  return errors.after.rmse <= expected
             ? "no more than the uncertainty of the fitted numbers leaves open there; fit such a run too"
             : "another regime, a start that is not as declared, or another effect";
}

// Fewer pictures a period show ringing badly: what acts on it (damping, friction, drag) and lags look alike.
constexpr double pictures_a_period = 8.0;
// A longer exposure, in periods, blurs ringing: by a tenth at a quarter of one.
constexpr double longest_exposure = 0.25;
// A shorter lag or delay, in intervals between pictures, does not show.
constexpr double shortest_lag = 0.2;

// The motion that is recorded most slowly; nothing if none is recorded.
const data::Run* slowest_record(std::span<const replay::PreparedRun> runs) {
  const data::Run* out = nullptr;
  for (const replay::PreparedRun& prepared : runs)
    if (prepared.is_motion() && prepared.run->times.size() > 1 &&
        (out == nullptr || data::median_interval(*prepared.run) > data::median_interval(*out)))
      out = prepared.run;
  return out;
}

// The model as the diagnosis recalibrated it, without its effects.
actuator::Model recalibrated(const Diagnosis& diagnosis, const replay::DeclaredModel& declared) {
  const fit::Hypothesis hypothesis(declared, {});
  Eigen::VectorXd values = hypothesis.start();
  Eigen::Index i = 0;
  for (const identification::Estimate& each : diagnosis.calibration) values[i++] = each.value;
  for (const MovedNumber& each : diagnosis.nominal) values[i++] = each.estimate.value;
  return hypothesis.model_at(hypothesis.clamped(values));
}

// Frequency in Hz of the slowest ringing about rest without current; nothing if the model does not ring.
std::optional<double> ringing_frequency(const actuator::Model& model) {
  const actuator::CoilCurrents none = actuator::CoilCurrents::Zero(model.coils());
  const auto rest = simulation::find_equilibrium(model, none, mechanics::JointVector::Zero(model.joints()));
  if (!rest) return std::nullopt;
  for (const simulation::Mode& mode : simulation::modes(model, *rest, none))
    if (mode.natural_frequency > 0.0 && mode.damping_ratio < 1.0) return mode.natural_frequency;
  return std::nullopt;
}

void warn_of_ringing(std::vector<data::Warning>& out, const data::Run& slowest, double frequency,
                     std::span<const replay::PreparedRun> runs) {
  const double rate = 1.0 / data::median_interval(slowest);
  if (rate < pictures_a_period * frequency)
    out.push_back({.run = slowest.name,
                   .text = fmt::format("{:.3g} samples a second are {:.2g} a period of the slowest ringing ({:.3g} "
                                       "Hz): damping, friction and lags look alike; from {:.0f} a second they show "
                                       "apart",
                                       rate, rate / frequency, frequency, std::ceil(pictures_a_period * frequency))});
  for (const replay::PreparedRun& prepared : runs)
    if (prepared.is_motion() && prepared.run->clock.exposure * frequency > longest_exposure)
      out.push_back(
          {.run = prepared.run->name,
           .text = fmt::format("an exposure of {:.3g} ms blurs ringing at {:.3g} Hz; at most {:.2g} ms show it",
                               1e3 * prepared.run->clock.exposure, frequency, 1e3 * longest_exposure / frequency)});
}

// A reported lag or delay that is short beside the time between samples.
void warn_of_short_lags(std::vector<data::Warning>& out, const Diagnosis& diagnosis, const data::Run& slowest) {
  const double interval = data::median_interval(slowest);
  for (const AddedEffect& effect : diagnosis.effects) {
    const std::string_view id = effect.kind->id();
    if (id != "measurement_delay" && id != "coil_lag" && id != "tracking_lag") continue;
    for (const identification::Estimate& each : effect.parameters) {
      if (each.key != "delay_ms" && each.key != "time_constant_ms") continue;
      const double size = std::abs(each.value);
      if (size >= shortest_lag * interval || size <= 0.0) continue;
      out.push_back({.run = slowest.name,
                     .text = fmt::format("{} of {:.3g} ms is less than a fifth of the {:.3g} ms between samples, which "
                                         "do not show it; {:.0f} samples a second would",
                                         id, 1e3 * size, 1e3 * interval, std::ceil(shortest_lag / size))});
    }
  }
}

// Noise that is correlated from picture to picture looks like structure of the motion.
void warn_of_unknown_colour(std::vector<data::Warning>& out, const Diagnosis& diagnosis,
                            std::span<const replay::PreparedRun> runs) {
  const bool structured = diagnosis.verdict == Verdict::partly_explained || diagnosis.verdict == Verdict::unexplained;
  if (!structured && diagnosis.after.is_white()) return;
  // Only noise whose size the set gives is taken for coloured (identification::weighed).
  const auto is_meant = [&](const signals::NoiseLevel& level) {
    return level.colour_unknown && (structured || level.given);
  };
  if (std::ranges::none_of(runs, [&](const replay::PreparedRun& prepared) {
        return prepared.is_motion() && std::ranges::any_of(prepared.noise, is_meant);
      }))
    return;
  out.push_back(
      {.run = "",
       .text = fmt::format(
           "what is left is not white, and no still run tells how the noise is coloured: {}; ten seconds of a still "
           "finger, recorded as the motions were, would tell (kind still)",
           structured ? "a filter in the camera or the tracker, or hum, cannot be told from a missing effect"
                      : "as it is no larger than the noise that the set gives, it is taken for that noise, filtered by "
                        "the camera or the tracker")});
}

// Along a motion that the errors of the input have led elsewhere, what more of them does is no longer linear. A
// pendulum whose torque moved it by 7 degrees had a right damping outside of its interval in 6 of 18 sets.
void warn_of_far_input_errors(std::vector<data::Warning>& out, std::span<const replay::PreparedRun> runs) {
  constexpr double farthest = 0.05;  // rad
  for (const replay::PreparedRun& prepared : runs) {
    double moved = 0.0;
    for (const replay::Window& window : prepared.windows)
      if (window.input_whitener != nullptr) moved = std::max(moved, window.input_whitener->deviations().maxCoeff());
    if (!(moved > farthest)) continue;
    out.push_back(
        {.run = prepared.run->name,
         .text = fmt::format("the errors of the input (input_sigma) move the motion by up to {:.3g} deg, which "
                             "is weighed to first order: intervals are too narrow, and weak effects may be "
                             "chance; start the run anew in pieces (window_s) in which it is less than 3 deg",
                             moved / (std::numbers::pi / 180.0))});
  }
}

}  // namespace

std::optional<data::Warning> support_in_one_run(std::span<const replay::PreparedRun> runs, const fit::Fit& without,
                                                const fit::Fit& with) {
  constexpr std::size_t fewest_runs = 3;
  constexpr double nearly_all = 0.9;
  if (runs.size() < fewest_runs) return std::nullopt;
  std::vector<double> explained;
  Eigen::Index row = 0;
  std::size_t window = 0;
  for (const replay::PreparedRun& run : runs) {
    explained.push_back(0.0);
    for (std::size_t k = 0; k < run.sample_ranges().size(); ++k) {
      const Eigen::Index rows = without.parameter_columns[window++].rows();
      explained.back() += without.stacked_residuals.segment(row, rows).squaredNorm() -
                          with.stacked_residuals.segment(row, rows).squaredNorm();
      row += rows;
    }
  }
  const auto most = std::ranges::max_element(explained);
  const double all = std::accumulate(explained.begin(), explained.end(), 0.0);
  if (!(*most > 0.0) || *most < nearly_all * all) return std::nullopt;
  return data::Warning{
      .run = runs[static_cast<std::size_t>(most - explained.begin())].run->name,
      .text = fmt::format("{:.0f} % of what the effects explain is in this run alone: an input, a clock or a pose that "
                          "is not this run's looks like that; check them, and repeat the run before you build on it",
                          all > *most ? 100.0 * *most / all : 100.0)};
}

std::vector<data::Warning> warnings_of(const Diagnosis& diagnosis, std::span<const replay::PreparedRun> runs,
                                       const replay::DeclaredModel& declared) {
  std::vector<data::Warning> out;
  const auto warn = [&](std::string text) { out.push_back({.run = "", .text = std::move(text)}); };
  const double level = diagnosis.after.level;
  const bool given =
      replay::weighs_input_errors(runs) ||
      std::ranges::any_of(runs, [](const replay::PreparedRun& prepared) { return prepared.run->sigma.has_value(); });
  if (given && level > notable_ratio)
    warn(fmt::format("what is left is {:.3g} times the noise that the set gives", level));
  if (given && level < 1.0 / notable_ratio)
    warn(
        fmt::format("what is left is only {:.3g} times the noise that the set gives: an effect may hide in it", level));
  if (diagnosis.verdict != Verdict::no_missing_effect)
    for (const std::string& number : declared.uncalibrated_effect_numbers)
      warn(fmt::format("{} stays as declared; it is fitted anew if calibrate names it", number));
  for (const ErrorComparison& errors : diagnosis.validate_errors)
    if (errors.after.rmse > errors.before.rmse + notable_growth * errors.noise_floor_rmse)
      warn("on the runs that no fit has seen the effects make the error larger");
  if (const data::Run* slowest = slowest_record(runs)) {
    // Beside an effect numbers may lie where they make no model without it.
    const auto frequency =
        replay::if_possible<double>([&] { return ringing_frequency(recalibrated(diagnosis, declared)); });
    if (frequency) warn_of_ringing(out, *slowest, *frequency, runs);
    warn_of_short_lags(out, diagnosis, *slowest);
  }
  warn_of_unknown_colour(out, diagnosis, runs);
  warn_of_far_input_errors(out, runs);
  if (diagnosis.verdict == Verdict::partly_explained || diagnosis.verdict == Verdict::unexplained) return out;
  for (const ErrorComparison& errors : diagnosis.validate_errors)
    if (errors.after.rmse > notable_ratio * errors.noise_floor_rmse)
      warn(fmt::format("on the runs that no fit has seen the error is {:.3g} times the noise: {}",
                       errors.after.rmse / errors.noise_floor_rmse, reason_for_larger_error(errors)));
  return out;
}

}  // namespace coilwright::measurement
