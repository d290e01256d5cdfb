#include "measurement/records/exchanged_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/fisher_f.hpp>
#include <cstddef>
#include <optional>

#include "coilwright/measurement/signals/correlation_time.hpp"
#include "measurement/fit/parallel.hpp"
#include "measurement/records/declared_readings.hpp"

namespace coilwright::measurement::records {
namespace {

constexpr double false_alarm = 0.01;  // of all pairs together

// What the first angle of a motion shows, and the declared model of it.
struct Shown {
  const data::Run* run{};
  std::vector<double> measured{}, declared{};
};

std::vector<Shown> shown_by(std::span<const data::Run> runs, const replay::DeclaredModel& declared) {
  const fit::Hypothesis as_declared(declared, {});
  std::vector<Shown> all(runs.size());
  fit::in_parallel(runs.size(), [&](std::size_t r) {
    if (!is_motion_of_angles(runs[r])) return;
    const auto readings = declared_readings(runs[r], declared, as_declared);
    if (!readings) return;
    const auto angle =
        std::ranges::find_if(*readings, [](const DeclaredReadings& each) { return is_angle(*each.channel); });
    all[r] = {.run = &runs[r], .measured = angle->measured, .declared = angle->declared};
  });
  std::erase_if(all, [](const Shown& each) { return each.run == nullptr; });
  return all;
}

// As many samples of both as there are at the same times; none on rigs or channels that differ.
std::size_t common_samples(const Shown& a, const Shown& b) {
  if (!(a.run->rig == b.run->rig)) return 0;
  const auto is_angle_of_both = std::ranges::find_if(a.run->channels, is_angle);
  if (is_angle_of_both->name != std::ranges::find_if(b.run->channels, is_angle)->name) return 0;
  const auto near = [&](double s, double t) { return std::abs(s - t) < 0.1 * (a.run->times[1] - a.run->times[0]); };
  const std::size_t most = std::min(a.measured.size(), b.measured.size());
  const auto times = std::span(a.run->times).first(most);
  return static_cast<std::size_t>(std::ranges::mismatch(times, std::span(b.run->times).first(most), near).in1 -
                                  times.begin());
}

struct Missed {
  double mean_square{}, freedom{};
};
Missed missed(std::span<const double> measured, std::span<const double> declared) {
  signals::ScaledResidual residual{.run = {}, .times = {}, .values = {}, .starts = {0}, .bands = {}};
  double squares = 0.0;
  for (std::size_t i = 0; i < measured.size(); ++i) {
    residual.values.push_back(measured[i] - declared[i]);
    squares += residual.values.back() * residual.values.back();
  }
  const auto count = static_cast<double>(measured.size());
  return {.mean_square = squares / count,
          .freedom = std::max(1.0, count / signals::correlation_time(std::span(&residual, 1)))};
}

// That readings are no nearer to the other run's motion than to their own.
double probability_of_own(const Shown& own, const Shown& other, std::size_t samples) {
  const auto measured = std::span(own.measured).first(samples);
  const Missed by_own = missed(measured, std::span(own.declared).first(samples));
  const Missed by_other = missed(measured, std::span(other.declared).first(samples));
  if (!(by_own.mean_square > by_other.mean_square) || !(by_other.mean_square > 0.0)) return 1.0;
  const boost::math::fisher_f ratio(by_own.freedom, by_other.freedom);
  return boost::math::cdf(boost::math::complement(ratio, by_own.mean_square / by_other.mean_square));
}

}  // namespace

std::vector<data::Warning> exchanged_runs(std::span<const data::Run> runs, const replay::DeclaredModel& declared) {
  constexpr std::size_t fewest = 20;  // samples
  const std::vector<Shown> shown = shown_by(runs, declared);
  const double pairs = 0.5 * static_cast<double>(shown.size()) * static_cast<double>(shown.size() - 1);
  std::vector<data::Warning> out;
  for (std::size_t a = 0; a < shown.size(); ++a)
    for (std::size_t b = a + 1; b < shown.size(); ++b) {
      const std::size_t samples = common_samples(shown[a], shown[b]);
      if (samples < fewest) continue;
      const double right =
          std::max(probability_of_own(shown[a], shown[b], samples), probability_of_own(shown[b], shown[a], samples));
      if (right * pairs >= false_alarm) continue;
      out.push_back({.run = shown[a].run->name,
                     .text = fmt::format("its readings are what the declared model shows of the input of {}, and those "
                                         "of {} what it shows of this one's: were the two exchanged? If so, give each "
                                         "its own input again",
                                         shown[b].run->name, shown[b].run->name)});
    }
  return out;
}

}  // namespace coilwright::measurement::records
