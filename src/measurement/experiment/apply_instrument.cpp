#include "measurement/experiment/apply_instrument.hpp"

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <cmath>
#include <random>

namespace coilwright::measurement::experiment {

// Boost's generator and distribution, not the standard's: what std::normal_distribution draws is left to each library.
void read_by(const Instrument& instrument, const NoisePlace& place, std::span<double> values) {
  const auto half = [](std::uint64_t word, int which) { return static_cast<std::uint32_t>(word >> (32 * which)); };
  std::seed_seq sequence{half(place.seed, 0), half(place.seed, 1), half(place.run, 0), half(place.channel, 0)};
  boost::random::mt19937_64 generator(sequence);
  boost::random::normal_distribution<double> normal;
  for (double& value : values) {
    if (instrument.noise > 0.0) value += instrument.noise * normal(generator);
    if (instrument.resolution > 0.0) value = std::round(value / instrument.resolution) * instrument.resolution;
  }
}

}  // namespace coilwright::measurement::experiment
