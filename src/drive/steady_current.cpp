#include "coilwright/drive/steady_current.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "drive/phase.hpp"
#include "drive/require.hpp"

namespace coilwright::drive {
namespace {

// Periods that are averaged where none repeats, and time constants after which a start is forgotten (e^-40).
constexpr int averaged_periods = 1000;
// Followed at least: with a limit a period comes back to itself by what its last chop leaves, not by L/R.
constexpr double followed_periods = 500.0;
constexpr double forgetting = 40.0;
// Relative to the largest current that a phase heads for.
constexpr double repeated = 1e-13;

// Everything that is summed along the phases.
struct Sums {
  double time{}, conducting{}, charge{}, square{}, supply_charge{};
  double source{}, switches{}, diodes{}, supply{};
  double peak{}, valley = std::numeric_limits<double>::infinity();
  bool limited{};
};

class Runner {
 public:
  Runner(const Circuit& circuit, const Driver& driver) : circuit_(circuit), driver_(driver) {}

  // Follows one period from `start` and adds it to `sums`. Returns the current at its end.
  double period(double start, const PhaseLengths& lengths, Sums& sums) const {
    double current = drive(start, lengths.on, sums);
    current = along(driver_.dead, current, lengths.dead_before_off, sums);
    current = along(driver_.off, current, lengths.off, sums);
    return along(driver_.dead, current, lengths.dead_before_on, sums);
  }

  // The start that an unlimited period, taken as linear, comes back to; below zero where the current stops.
  [[nodiscard]] double linear_start(const PhaseLengths& lengths) const {
    double slope = 1.0, end = 0.0;
    const auto add = [&](const Path& path, double time) {
      const Phase phase(circuit_, path);
      end = phase.current(end, time);
      slope *= std::exp(-time / phase.time_constant);
    };
    add(driver_.on, lengths.on);
    add(driver_.dead, lengths.dead_before_off);
    add(driver_.off, lengths.off);
    add(driver_.dead, lengths.dead_before_on);
    return slope < 1.0 ? end / (1.0 - slope) : 0.0;
  }

  // One cycle of the limit while the command stays on.
  void limit_cycle(Sums& sums) const {
    const CurrentLimit& limit = *driver_.limit;
    const Phase chop(circuit_, driver_.chop), on(circuit_, driver_.on);
    double start = std::max(0.0, chop.current(limit.trip, limit.off_time));
    double pulse = on.time_to_reach(start, limit.trip);
    if (pulse < limit.blanking) {
      // The blanking time carries it past the limit, and up until a pulse of that length gains what is lost meanwhile.
      pulse = limit.blanking;
      const double slope = std::exp(-pulse / on.time_constant - limit.off_time / chop.time_constant);
      start = std::max(0.0, chop.current(on.current(0.0, pulse), limit.off_time) / (1.0 - slope));
    }
    sums.limited = true;
    static_cast<void>(along(driver_.chop, along(driver_.on, start, pulse, sums), limit.off_time, sums));
  }

 private:
  double along(const Path& path, double start, double time, Sums& sums) const {
    if (time <= 0.0) return start;
    const Phase phase(circuit_, path);
    // From zero a path that would take the current below stays there: its diodes block.
    const bool blocked = start <= 0.0 && phase.goal <= 0.0;
    const double flowing = blocked ? 0.0 : std::min(time, phase.time_to_zero(start));
    const double end = flowing < time ? 0.0 : std::max(0.0, phase.current(start, time));
    const double charge = flowing > 0.0 ? phase.charge(start, flowing) : 0.0;
    const double square = flowing > 0.0 ? phase.square(start, flowing) : 0.0;
    sums.time += time;
    sums.conducting += flowing;
    sums.charge += charge;
    sums.square += square;
    if (path.source != 0.0) sums.supply_charge += std::copysign(charge, path.source);
    sums.source += path.source * charge;
    sums.switches += path.resistance * square;
    sums.diodes += path.diodes * charge;
    sums.supply += path.supply_resistance * square;
    sums.peak = std::max({sums.peak, start, end});
    sums.valley = std::min({sums.valley, start, end});
    return end;
  }

  double drive(double start, double time, Sums& sums) const {
    if (!driver_.limit) return along(driver_.on, start, time, sums);
    const Phase on(circuit_, driver_.on);
    double current = start;
    for (double left = time; left > 0.0;) {
      const double pulse = std::max(on.time_to_reach(current, driver_.limit->trip), driver_.limit->blanking);
      if (pulse >= left) return along(driver_.on, current, left, sums);
      sums.limited = true;
      current = along(driver_.on, current, pulse, sums);
      left -= pulse;
      const double rest = std::min(left, driver_.limit->off_time);
      current = along(driver_.chop, current, rest, sums);
      left -= rest;
    }
    return current;
  }

  Circuit circuit_;
  Driver driver_;
};

SteadyCurrent result(const Circuit& circuit, const Sums& sums, double start, double end) {
  const auto mean = [&](double sum) { return sum / sums.time; };
  return {.mean = mean(sums.charge),
          .rms = std::sqrt(mean(sums.square)),
          .peak = sums.peak,
          .valley = sums.valley,
          .supply_mean = mean(sums.supply_charge),
          // Roundings of phases that are added up.
          .conduction = sums.conducting >= sums.time * (1.0 - 1e-12) ? 1.0 : mean(sums.conducting),
          .is_limited = sums.limited,
          .powers = {.source = mean(sums.source),
                     .coils = circuit.resistance * mean(sums.square),
                     .switches = mean(sums.switches),
                     .diodes = mean(sums.diodes),
                     .supply = mean(sums.supply),
                     .stored = mean(0.5 * circuit.inductance * (end - start) * (end + start))}};
}

void check(const Circuit& circuit, const Pulses& pulses) {
  require_positive("resistance", circuit.resistance);
  require_positive("inductance", circuit.inductance);
  require_positive("frequency", pulses.frequency);
  require(pulses.duty >= 0.0 && pulses.duty <= 1.0, "duty", "from 0 to 1", pulses.duty);
}

}  // namespace

SteadyCurrent steady_current(const Circuit& circuit, const Driver& driver, const Pulses& pulses) {
  check(circuit, pulses);
  const Runner runner(circuit, driver);
  const PhaseLengths lengths = phase_lengths(driver, pulses);
  const Phase on(circuit, driver.on);
  const bool reaches_limit = driver.limit && lengths.on > 0.0 && on.goal > driver.limit->trip;
  if (reaches_limit && pulses.duty == 1.0) {
    Sums sums;
    runner.limit_cycle(sums);
    return result(circuit, sums, 0.0, 0.0);
  }
  // Nothing switches at duty 1: the current is where the supply drives it.
  double start = pulses.duty == 1.0 ? on.goal : std::max(0.0, runner.linear_start(lengths));
  if (lengths.on <= 0.0) start = 0.0;
  if (reaches_limit) start = std::min(start, driver.limit->trip);
  const double forgotten = forgetting * circuit.time_constant() * pulses.frequency;
  const auto most = static_cast<std::size_t>(std::clamp(forgotten, followed_periods, 1e6));
  for (std::size_t i = 0; i < most; ++i) {
    Sums sums;
    const double end = runner.period(start, lengths, sums);
    if (std::abs(end - start) <= repeated * std::abs(on.goal)) return result(circuit, sums, start, end);
    start = end;
  }
  Sums sums;
  double end = start;
  for (int i = 0; i < averaged_periods; ++i) end = runner.period(end, lengths, sums);
  SteadyCurrent out = result(circuit, sums, start, end);
  out.repeats = false;
  return out;
}

}  // namespace coilwright::drive
