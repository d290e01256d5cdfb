#include "coilwright/systems/crawl.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "systems/crawl_step.hpp"

namespace coilwright::systems {
namespace {

void check(const CrawlTiming& timing) {
  if (timing.settling_periods < 0)
    throw std::invalid_argument(fmt::format("settling_periods must be >= 0; got {}", timing.settling_periods));
  if (timing.periods < 1) throw std::invalid_argument(fmt::format("periods must be >= 1; got {}", timing.periods));
  if (!(timing.step > 0.0 && timing.step <= 1e-3))
    throw std::invalid_argument(fmt::format("step must be > 0 and <= 0.001; got {}", timing.step));
}

// The extremes of the counted periods.
struct Reach {
  std::vector<double> lifts;
  double largest = -std::numeric_limits<double>::infinity();
  double smallest = std::numeric_limits<double>::infinity();

  void take(const Crawler& crawler, const CrawlState& state) {
    const mechanics::FloatingFrames frames = crawler.chain().frames(state.position);
    const std::vector<mechanics::LinkPoint>& points = crawler.contact_points();
    lifts.resize(points.size(), 0.0);
    for (std::size_t i = 0; i < points.size(); ++i)
      lifts[i] = std::max(lifts[i], crawler.chain().position(frames, points[i]).y());
    const double bending = state.position.tail(crawler.model().joints()).sum();
    largest = std::max(largest, bending);
    smallest = std::min(smallest, bending);
  }
};

CrawlPowers powers_of(const CrawlWork& work, double stored, double time) {
  return {.electrical = work.electrical / time,
          .copper = work.copper / time,
          .leads = work.leads / time,
          .mechanical = work.mechanical / time,
          .hinges = work.hinges / time,
          .friction = work.friction / time,
          .impacts = work.impacts / time,
          .stored = stored / time,
          .unbalanced = (work.mechanical - work.hinges - work.friction - work.impacts - stored) / time};
}

double deviation(const std::vector<double>& values, double mean) {
  double sum = 0.0;
  for (const double value : values) sum += (value - mean) * (value - mean);
  return std::sqrt(sum / static_cast<double>(values.size()));
}

}  // namespace

Crawl crawl(const Crawler& crawler, const CrawlTiming& timing) {
  check(timing);
  const PulseDrive& drive = crawler.parts().drive;
  const double period = 1.0 / drive.frequency;
  CrawlState state{crawler.lying(), mechanics::CoordinateVector::Zero(crawler.chain().coordinates())};
  CrawlWork work;
  Reach reach;
  const auto phase = [&](Switch position, double duration, bool counted) {
    const int steps = std::max(1, static_cast<int>(std::ceil(duration / timing.step - 1e-9)));
    for (int k = 0; k < steps; ++k) {
      state = advance(crawler, state, position, duration / steps, work);
      if (counted) reach.take(crawler, state);
    }
  };

  std::vector<double> speeds;
  double stored = 0.0;
  for (int k = 0; k < timing.settling_periods + timing.periods; ++k) {
    const bool counted = k >= timing.settling_periods;
    if (k == timing.settling_periods) {
      work = {};
      stored = stored_energy(crawler, state);
    }
    const double from = state.position[0];
    phase(Switch::closed, drive.duty * period, counted);
    phase(Switch::open, (1.0 - drive.duty) * period, counted);
    if (counted) speeds.push_back((from - state.position[0]) / period);
  }

  const double time = timing.periods * period;
  Crawl out;
  for (const double speed : speeds) out.speed += speed / timing.periods;
  out.speed_scatter = deviation(speeds, out.speed);
  out.pulse_current = crawler.pulse_current();
  out.mean_current = work.charge / time;
  out.run_time = crawler.parts().cell.capacity / out.mean_current;
  out.distance_per_charge = out.speed * out.run_time;
  out.largest_bending = reach.largest;
  out.smallest_bending = reach.smallest;
  out.lifts = std::move(reach.lifts);
  out.powers = powers_of(work, stored_energy(crawler, state) - stored, time);
  return out;
}

}  // namespace coilwright::systems
