#include "measurement/whiteness/block_tests.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "measurement/whiteness/energy_limits.hpp"
#include "measurement/whiteness/false_alarms.hpp"

namespace coilwright::measurement::whiteness {
namespace {

constexpr std::size_t smallest_block = 8;  // samples

struct SampleBlock {
  const NormalisedRun* run{};
  std::size_t first{};
  std::size_t size{};
};

// Blocks inside windows, each overlapping the next by half.
std::vector<SampleBlock> blocks_of(std::span<const NormalisedRun> runs) {
  std::vector<SampleBlock> blocks;
  for (const NormalisedRun& run : runs) {
    if (!run.is_long()) continue;
    const std::vector<std::size_t>& starts = run.residual->starts;
    for (std::size_t w = 0; w < starts.size(); ++w) {
      const std::size_t end = w + 1 < starts.size() ? starts[w + 1] : run.samples();
      for (std::size_t size = smallest_block; 2 * size <= end - starts[w]; size *= 2)
        for (std::size_t first = starts[w]; first + size <= end; first += size / 2)
          blocks.push_back({&run, first, size});
    }
  }
  return blocks;
}

struct RunSums {
  std::vector<double> running_sums{};
  std::map<std::size_t, double> limits{};  // by the size of a block
};

}  // namespace

void test_blocks(std::span<const NormalisedRun> runs, WorstTest& worst) {
  const std::vector<SampleBlock> blocks = blocks_of(runs);
  std::map<const NormalisedRun*, RunSums> sums_of;
  for (const SampleBlock& block : blocks) {
    auto [found, is_new] = sums_of.try_emplace(block.run);
    RunSums& of_run = found->second;
    if (is_new) {
      const std::vector<double>& values = block.run->residual->values;
      of_run.running_sums.assign(values.size() + 1, 0.0);
      std::partial_sum(values.begin(), values.end(), of_run.running_sums.begin() + 1);
    }
    const auto [limit, first_of_size] = of_run.limits.try_emplace(block.size);
    if (first_of_size)
      limit->second =
          energy_limit({.count = 1.0,
                        .degrees_of_freedom = block.run->residual->freedom_below(0.5 / static_cast<double>(block.size)),
                        .allowed_energy = block.run->allowed_energy},
                       false_alarms::of_blocks / static_cast<double>(blocks.size()));
    const double sum = of_run.running_sums[block.first + block.size] - of_run.running_sums[block.first];
    worst.consider(sum * sum / (static_cast<double>(block.size) * block.run->noise_variance), 1.0, limit->second, [&] {
      const std::string place = block.run->has_times()
                                    ? fmt::format("{:.4g} s", block.run->residual->times[block.first])
                                    : fmt::format("sample {}", block.first);
      return fmt::format("{}, {} from {}", block.run->residual->run, length_text(*block.run, block.size), place);
    });
  }
}

}  // namespace coilwright::measurement::whiteness
