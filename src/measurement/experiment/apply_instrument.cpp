#include "measurement/experiment/apply_instrument.hpp"

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <cmath>
#include <random>

namespace coilwright::measurement::experiment {

// Boost's generator and distribution, not those of the standard library, which leaves the numbers that
// std::normal_distribution draws to each implementation.
std::vector<double> apply_instrument(const Instrument& instrument, const NoiseStream& stream,
                                     std::vector<double> values) {
  const auto half = [](std::uint64_t word, int which) { return static_cast<std::uint32_t>(word >> (32 * which)); };
  std::seed_seq sequence{half(stream.seed, 0), half(stream.seed, 1), half(stream.run, 0), half(stream.channel, 0)};
  boost::random::mt19937_64 generator(sequence);
  boost::random::normal_distribution<double> normal;
  for (double& value : values) {
    if (instrument.noise > 0.0) value += instrument.noise * normal(generator);
    if (instrument.resolution > 0.0) value = std::round(value / instrument.resolution) * instrument.resolution;
  }
  return values;
}

}  // namespace coilwright::measurement::experiment
