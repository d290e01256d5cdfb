#include "measurement/planning/apply_instrument.hpp"

#include <algorithm>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <cmath>
#include <numbers>
#include <random>

namespace coilwright::measurement::planning {
namespace {

// Boost's generator and distributions, not those of the standard library, which leaves the numbers that
// std::normal_distribution draws to each implementation.
using Generator = boost::random::mt19937_64;

// `purpose` parts the streams of one channel, so that outliers do not change with the noise.
Generator generator_of(const NoiseStream& stream, std::uint32_t purpose) {
  const auto half = [](std::uint64_t word, int which) { return static_cast<std::uint32_t>(word >> (32 * which)); };
  if (purpose == 0) {
    std::seed_seq sequence{half(stream.seed, 0), half(stream.seed, 1), half(stream.run, 0), half(stream.channel, 0)};
    return Generator(sequence);
  }
  std::seed_seq sequence{half(stream.seed, 0), half(stream.seed, 1), half(stream.run, 0), half(stream.channel, 0),
                         purpose};
  return Generator(sequence);
}

std::vector<double> white(Generator& generator, std::size_t count) {
  boost::random::normal_distribution<double> normal;
  std::vector<double> out(count);
  for (double& value : out) value = normal(generator);
  return out;
}

// First order, exact between samples, stationary from the first one on: standard deviation 1.
std::vector<double> low_passed(std::vector<double> noise, std::span<const double> times, double frequency) {
  for (std::size_t i = 1; i < noise.size(); ++i) {
    const double kept = std::exp(-2.0 * std::numbers::pi * frequency * (times[i] - times[i - 1]));
    noise[i] = kept * noise[i - 1] + std::sqrt(1.0 - kept * kept) * noise[i];
  }
  return noise;
}

// A sum of first-order noises of equal variance whose corners stand a factor of 4 apart, from once a record to half the
// sampling rate: between those its power falls as 1 / f but for a ripple. Standard deviation 1.
std::vector<double> one_over_f(Generator& generator, std::span<const double> times) {
  const double duration = times.back() - times.front();
  const double fastest = 0.5 * static_cast<double>(times.size() - 1) / duration;
  std::vector<double> sum(times.size(), 0.0);
  int terms = 0;
  for (double corner = 1.0 / duration; corner <= fastest; corner *= 4.0, ++terms) {
    const std::vector<double> term = low_passed(white(generator, times.size()), times, corner);
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += term[i];
  }
  for (double& value : sum) value /= std::sqrt(static_cast<double>(terms));
  return sum;
}

std::vector<double> coloured(const NoiseColour& colour, Generator& generator, std::span<const double> times,
                             std::size_t count) {
  const bool timed = times.size() == count && count > 2;
  if (timed && colour.kind == NoiseColour::Kind::one_over_f) return one_over_f(generator, times);
  std::vector<double> noise = white(generator, count);
  if (timed && colour.kind == NoiseColour::Kind::low_pass) return low_passed(std::move(noise), times, colour.frequency);
  return noise;
}

void add_outliers(const Instrument& instrument, const NoiseStream& stream, std::vector<double>& values) {
  if (instrument.outlier_share <= 0.0) return;
  Generator generator = generator_of(stream, 1);
  const boost::random::uniform_real_distribution<double> evenly(0.0, 1.0);
  for (double& value : values) {
    const double chance = evenly(generator);
    const double sign = evenly(generator) < 0.5 ? -1.0 : 1.0;
    const double size = std::lerp(instrument.smallest_outlier, instrument.largest_outlier, evenly(generator));
    if (chance < instrument.outlier_share) value += sign * size;
  }
}

}  // namespace

std::vector<double> apply_instrument(const Instrument& instrument, const NoiseStream& stream,
                                     std::span<const double> times, std::vector<double> values) {
  if (instrument.noise > 0.0) {
    Generator generator = generator_of(stream, 0);
    const std::vector<double> noise = coloured(instrument.colour, generator, times, values.size());
    for (std::size_t i = 0; i < values.size(); ++i) values[i] += instrument.noise * noise[i];
  }
  if (instrument.hum > 0.0 && !times.empty()) {
    Generator generator = generator_of(stream, 2);
    const double phase = 2.0 * std::numbers::pi * boost::random::uniform_real_distribution<double>(0.0, 1.0)(generator);
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] += instrument.hum * std::sin(2.0 * std::numbers::pi * instrument.hum_frequency * times[i] + phase);
  }
  add_outliers(instrument, stream, values);
  if (instrument.resolution > 0.0)
    for (double& value : values) value = std::round(value / instrument.resolution) * instrument.resolution;
  return values;
}

std::vector<double> normal_numbers(const NoiseStream& stream, std::size_t count) {
  Generator generator = generator_of(stream, 3);
  return white(generator, count);
}

}  // namespace coilwright::measurement::planning
