#include "coilwright/report/simulation/reach_text.hpp"
#include "coilwright/units/angle.hpp"

#include <fmt/format.h>

#include <optional>

namespace coilwright::report {
namespace {

std::string seconds(const std::optional<double>& time, double followed) {
  return time ? fmt::format("{:.3f}", *time) : fmt::format("> {:.2f}", followed);
}

std::string errors(const control::ReachTask& task) {
  return fmt::format("k {:.3g} % and b {:.3g} % off", 100.0 * task.stiffness_error, 100.0 * task.damping_error);
}

std::string levels(const control::CurrentProfile& profile) {
  std::string out;
  for (std::size_t i = 0; i < profile.levels.size(); ++i) {
    const bool last = i + 1 == profile.levels.size();
    out += last ? fmt::format("{:.3f} A from {:.1f} ms on.\n", profile.levels[i], 1e3 * profile.times[i])
                : fmt::format("{:.3f} A for {:.1f} ms, ", profile.levels[i],
                              1e3 * (profile.times[i + 1] - profile.times[i]));
  }
  return out;
}

}  // namespace

std::string to_text(const control::Reach& reach, const control::ReachTask& task) {
  const control::Arrival& whole = reach.profiles.front().nominal;
  std::string out = fmt::format(
      "From {:.2f} to {:.2f} deg; {:.4g} A hold it. Slowest motion there: {:.3g} Hz, damping ratio {:.3g}.\n\n",
      whole.start * units::degrees_per_radian, whole.end * units::degrees_per_radian, reach.current,
      reach.mode.natural_frequency, reach.mode.damping_ratio);
  out += fmt::format("{:<27}{:>23}{:>25}\n", "", "settling time s", "overshoot %");
  out += fmt::format("{:<27}{:>11}{:>12}{:>13}{:>12}\n", "profile", "as it is", "at worst", "as it is", "at worst");
  for (const control::ProfileQuality& each : reach.profiles)
    out += fmt::format("{:<27}{:>11}{:>12}{:>13.1f}{:>12.1f}\n", each.name,
                       seconds(each.nominal.settling_time, reach.duration),
                       seconds(each.worst.settling_time, reach.duration), 100.0 * each.nominal.overshoot,
                       100.0 * each.worst.overshoot);
  const control::ProfileQuality& best = control::best_profile(reach);
  if (!best.worst.settling_time)
    out += "\nNo profile settles at its worst while it was followed: creep, or another slow effect, decides.";
  out +=
      fmt::format("\nAt worst: with {}, either way. Settled: within 2 % of the change about where that finger ends.\n",
                  errors(task));
  out += fmt::format("Best at worst, {}: {}", best.name, levels(best.profile));
  if (reach.greatest_end - reach.least_end > 1e-6)
    out += fmt::format(
        "Such fingers end between {:.1f} and {:.1f} deg: no profile without a sensor mends that; measure k of yours "
        "(coilwright diagnose).\n",
        reach.least_end * units::degrees_per_radian, reach.greatest_end * units::degrees_per_radian);
  return out;
}

}  // namespace coilwright::report
