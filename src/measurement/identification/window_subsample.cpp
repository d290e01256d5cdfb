#include "measurement/identification/window_subsample.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <utility>

#include "measurement/fit/parallel.hpp"
#include "measurement/identification/search_effort.hpp"
#include "measurement/identification/staged_fit.hpp"

namespace coilwright::measurement::identification {
namespace {

// One window of each block of `block`, at a place in it that follows the golden ratio.
std::vector<replay::Window> one_of_each_block(const std::vector<replay::Window>& windows, std::size_t block) {
  std::vector<replay::Window> out;
  for (std::size_t first = 0; first < windows.size(); first += block) {
    const std::size_t length = std::min(block, windows.size() - first);
    const double golden = static_cast<double>(out.size()) * std::numbers::phi;
    const auto place = static_cast<std::size_t>((golden - std::floor(golden)) * static_cast<double>(length));
    out.push_back(windows[first + place]);
  }
  return out;
}

std::size_t windows_of(std::span<const replay::PreparedRun> runs) {
  std::size_t count = 0;
  for (const replay::PreparedRun& run : runs) count += run.windows.size();
  return count;
}

}  // namespace

std::unique_ptr<WindowSubsample> WindowSubsample::of(std::span<replay::PreparedRun> all) {
  std::size_t samples = 0;
  for (const replay::PreparedRun& run : all)
    for (const replay::SampleRange& range : run.sample_ranges()) samples += range.samples();
  const std::size_t wanted = samples / search_effort.thinned_samples;
  std::vector<replay::PreparedRun> out(all.begin(), all.end());
  bool any = false;
  for (replay::PreparedRun& run : out) {
    const std::size_t block = std::min(wanted, run.windows.size() / search_effort.fewest_windows);
    if (block < 2) continue;
    run.windows = one_of_each_block(run.windows, block);
    any = true;
  }
  if (!any) return nullptr;
  return std::unique_ptr<WindowSubsample>(new WindowSubsample(all, std::move(out)));
}

std::string WindowSubsample::text() const {
  return fmt::format("{} of {} windows", windows_of(some_), windows_of(all_));
}

void WindowSubsample::hand_on_outliers() const {
  for (std::size_t r = 0; r < some_.size(); ++r) {
    all_[r].set_aside = some_[r].set_aside;
    all_[r].noise = some_[r].noise;
  }
}

std::vector<FittedHypothesis> WindowSubsample::on_all(std::span<const FittedHypothesis> best) const {
  std::vector<std::optional<FittedHypothesis>> found(best.size());
  fit::in_parallel(best.size(), [&](std::size_t i) {
    found[i] = fit_exactly(all_, {.hypothesis = best[i].hypothesis, .start = best[i].fit.values});
  });
  std::vector<FittedHypothesis> out;
  for (auto& each : found)
    if (each) out.push_back(std::move(*each));
  return out;
}

}  // namespace coilwright::measurement::identification
