#include "measurement/frozen_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "coilwright/measurement/noise/noise_level.hpp"
#include "measurement/data/equal_stretches.hpp"

namespace coilwright::measurement {
namespace {

constexpr std::size_t fewest = 10;  // samples
// At three resolutions one neighbour in ten is alike by chance, ten in a row never.
constexpr double least_noise = 3.0;  // resolutions

// Stretches in which nothing but a standing picture keeps a reading.
std::vector<data::EqualStretch> long_stretches(const std::vector<double>& values) {
  std::vector<data::EqualStretch> out = data::equal_stretches(values);
  std::erase_if(out, [](const data::EqualStretch& each) { return each.size < fewest; });
  return out;
}

// The noise of what lies outside of them, which has no noise itself.
noise::NoiseLevel noise_without(const data::Run& run, const data::Channel& channel,
                                const std::vector<data::EqualStretch>& left) {
  data::Run rest{.name = run.name, .kind = run.kind};
  data::Channel values{.name = channel.name, .kind = channel.kind};
  auto next = left.begin();
  for (std::size_t i = 0; i < run.times.size(); ++i) {
    if (next != left.end() && i == next->end()) ++next;
    if (next != left.end() && i >= next->first) continue;
    rest.times.push_back(run.times[i]);
    values.values.push_back(channel.values[i]);
  }
  return values.values.empty() ? noise::NoiseLevel{} : noise::noise_of(rest, values);
}

}  // namespace

std::optional<data::Warning> frozen_pictures(const data::Run& run) {
  if (run.kind != data::RunKind::transient) return std::nullopt;
  for (const data::Channel& channel : run.channels) {
    const std::vector<data::EqualStretch> stretches = long_stretches(channel.values);
    if (stretches.empty() || channel.values.size() != run.times.size()) continue;
    const noise::NoiseLevel level = noise_without(run, channel, stretches);
    if (level.resolution <= 0.0 || level.sigma < least_noise * level.resolution) continue;
    const auto [least, most] = std::ranges::minmax(channel.values);
    data::EqualStretch longest;
    for (const data::EqualStretch& each : stretches) {
      const double value = channel.values[each.first];
      if (value != least && value != most && each.size > longest.size) longest = each;
    }
    if (longest.size == 0) continue;
    return data::Warning{
        .run = run.name,
        .text = fmt::format("{} is exactly the same in {} samples from {:.6g} s on, where its noise would show: the "
                            "camera or the tracker stopped there. Leave them out of the record: they look like a "
                            "finger that sticks",
                            channel.name, longest.size, run.times[longest.first])};
  }
  return std::nullopt;
}

}  // namespace coilwright::measurement
