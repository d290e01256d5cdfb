#include "video/motion_start.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace coilwright::video {
namespace {

constexpr double doubled = 0.1;  // probability of a picture to show the one before, until the motion says more
constexpr double misfit = 0.05;  // of the way: a finger is not one oscillator, and its rates are tried in steps
constexpr double stray = 1e-6;   // density of a sample that was misread, over that of the noise at its middle

// Probability of each course, over that of the first: few torques rise as slowly as the finger moves.
constexpr std::array likely = {1.0, 1.0, 1.0, 1.0, 0.05};

// Way from rest, over the angle of its rate: of an oscillator that is damped little, more and just so that it does not
// swing, and of a mass with a damper alone, under a constant torque; of a mass under a torque that rises to one.
double way_of(std::size_t course, double angle) {
  if (course == 2) return 1.0 - (1.0 + angle) * std::exp(-angle);
  if (course == 3) return angle - 1.0 + std::exp(-angle);
  if (course == 4) return 0.5 * angle * angle - angle + 1.0 - std::exp(-angle);
  const double decay = course == 0 ? 0.1 : 0.4;  // over the rate
  return 1.0 - std::exp(-decay * angle) * (std::cos(angle) + decay * std::sin(angle));
}

// From where the samples are all but on a parabola to where the fastest is past its peak.
constexpr std::array rates = {0.03, 0.1, 0.2, 0.3, 0.45, 0.6, 0.8, 1.0, 1.3, 1.6, 2.0, 2.5, 3.1, 3.9, 4.9, 6.0};

// Density, over that of the noise at its middle.
double density(double off, double sigma, double noise) {
  return noise / sigma * std::exp(-0.5 * off * off / (sigma * sigma));
}

// What the samples are, as ways from rest, until they swing back.
struct Ways {
  std::vector<double> times;
  std::vector<double> ways;     // rad, positive where it goes
  std::vector<double> alike;    // density of a sample as one that repeats the sample before, times its probability
  std::vector<double> at_rest;  // density of a sample as one that has come no way
  std::size_t last{};           // the last that does not look like the one before: the courses lead through it
};

Ways ways_of(std::span<const AngleSample> samples, std::size_t first, double rest, double noise) {
  Ways out;
  const double sign = samples[first].angle < rest ? -1.0 : 1.0;
  constexpr double goes_on = 3.0;  // standard deviations
  constexpr double swings = 0.8;   // of the way to the peak: what comes back so far does swing, and by how much is open
  double farthest = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double way = sign * (samples[i].angle - rest);
    farthest = std::max(farthest, way);
    if (i > first && way < swings * farthest - goes_on * noise) break;
    if (i <= first || way > out.ways.back() + goes_on * noise) out.last = i;
    const double off = i > 0 ? way - out.ways.back() : 0.0;
    out.alike.push_back(i > 0 ? doubled * density(off, std::sqrt(2.0) * noise, noise) : 0.0);
    out.at_rest.push_back((1.0 - doubled) * density(way, noise, noise) + out.alike.back() + stray);
    out.times.push_back(samples[i].time);
    out.ways.push_back(way);
  }
  return out;
}

}  // namespace

MotionStart motion_start(std::span<const AngleSample> samples, std::size_t first, double rest, double noise,
                         double interval) {
  const Ways seen = ways_of(samples, first, rest, noise);
  const std::size_t count = seen.ways.size();
  const double begin = seen.times.front();
  const double span = seen.times[first] - begin;
  constexpr double fine = 16.0;  // parts of an interval
  const int parts = static_cast<int>(std::clamp(fine * span / interval, fine, 30.0 * fine));
  MotionStart out{.repeated = std::vector<double>(samples.size(), 0.0)};
  double weights = 0.0, times = 0.0, squares = 0.0;
  std::vector<double> shares(count);
  for (int part = 0; part < parts; ++part) {
    const double start = span * (part + 0.5) / parts;
    std::size_t moving = 0;  // the first sample after the start
    double rest_weight = 1.0;
    while (seen.times[moving] - begin <= start) rest_weight *= seen.at_rest[moving++];
    double weight = 0.0;
    for (std::size_t course = 0; course < likely.size(); ++course)
      for (const double rate_span : rates) {
        const double rate = rate_span / (seen.times.back() - begin - start);
        const double scale = seen.ways[seen.last] / way_of(course, rate * (seen.times[seen.last] - begin - start));
        double each = likely[course] * rest_weight;
        for (std::size_t i = moving; i < count; ++i) {
          const double way = scale * way_of(course, rate * (seen.times[i] - begin - start));
          const double all = (1.0 - doubled) * density(seen.ways[i] - way, std::hypot(noise, misfit * way), noise) +
                             seen.alike[i] + stray;
          shares[i] = seen.alike[i] / all;
          each *= all;
        }
        for (std::size_t i = moving; i < count; ++i) out.repeated[i] += each * shares[i];
        weight += each;
      }
    for (std::size_t i = 0; i < moving; ++i) out.repeated[i] += weight * seen.alike[i] / seen.at_rest[i];
    weights += weight;
    times += weight * start;
    squares += weight * start * start;
  }
  for (double& each : out.repeated) each /= weights;
  const double mean = times / weights;
  out.moment = {.time = begin + mean, .sigma = std::sqrt(std::max(0.0, squares / weights - mean * mean))};
  return out;
}

}  // namespace coilwright::video
