#include "measurement/data/usable_runs.hpp"

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <utility>

namespace coilwright::measurement::data {
namespace {

constexpr std::size_t fewest_samples = 20;

bool changes(const std::vector<std::vector<double>>& inputs) {
  return std::ranges::adjacent_find(inputs, std::not_equal_to<>()) != inputs.end();
}

bool is_stuck(const Run& run, const Channel& channel) {
  return channel.values.size() >= fewest_samples && changes(run.inputs) &&
         std::ranges::adjacent_find(channel.values, std::not_equal_to<>()) == channel.values.end();
}

}  // namespace

UsableRuns usable_runs(const std::vector<Run>& runs) {
  UsableRuns out;
  for (const Run& run : runs) {
    Run kept = run;
    std::erase_if(kept.channels, [&](const Channel& channel) {
      if (!is_stuck(run, channel)) return false;
      out.warnings.push_back(
          {.run = run.name, .text = channel.name + " never changes while the input moves; left out"});
      return true;
    });
    if (!kept.channels.empty()) out.runs.push_back(std::move(kept));
  }
  if (out.runs.empty()) throw std::invalid_argument("fit runs: every measured column is stuck at one value");
  return out;
}

}  // namespace coilwright::measurement::data
