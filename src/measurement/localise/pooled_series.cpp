#include "measurement/localise/pooled_series.hpp"

#include <cmath>
#include <numeric>

namespace coilwright::measurement::localise {

PooledSeries pooled(std::span<const MeasuredMotion> motions, const std::vector<TorqueSeries>& all, std::size_t series) {
  PooledSeries result;
  const auto append = [](std::vector<double>& to, const std::vector<double>& from) {
    to.insert(to.end(), from.begin(), from.end());
  };
  for (std::size_t m = 0; m < motions.size(); ++m) {
    append(result.torque, all[m].torque[series]);
    append(result.noise, all[m].noise[series]);
    append(result.angle, all[m].angle[series]);
    append(result.rate, all[m].rate[series]);
    append(result.rate_noise, all[m].rate_noise[series]);
    append(result.acceleration, all[m].acceleration[series]);
    for (const std::size_t i : all[m].samples) {
      result.time.push_back(motions[m].input.times[i] - motions[m].input.times.front());
      result.run.push_back(static_cast<double>(m + 1));
      result.motion.push_back(&motions[m]);
      result.sample.push_back(i);
    }
  }
  return result;
}

SampleBlocks blocks_of(const PooledSeries& samples, double smoothing_length) {
  const auto size = static_cast<std::size_t>(std::ceil(8.0 * smoothing_length)) + 1;
  SampleBlocks blocks;
  std::size_t block = 0;
  std::size_t filled = 0;
  for (std::size_t i = 0; i < samples.sample.size(); ++i) {
    if (i > 0 && samples.motion[i] != samples.motion[i - 1]) {
      // Every second run begins with an odd block, so that the same time of a run is in even and in odd blocks.
      block = (block / 2 + 1) * 2 + static_cast<std::size_t>(samples.run[i] - 1.0) % 2;
      filled = 0;
    } else if (filled == size) {
      ++block;
      filled = 0;
    }
    blocks.number.push_back(block);
    ++filled;
  }
  return blocks;
}

double mean_square(std::span<const double> values) {
  if (values.empty()) return 0.0;
  return std::inner_product(values.begin(), values.end(), values.begin(), 0.0) / static_cast<double>(values.size());
}

}  // namespace coilwright::measurement::localise
