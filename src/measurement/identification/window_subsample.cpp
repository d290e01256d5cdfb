#include "measurement/identification/window_subsample.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
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

// The same for an effect with fewer and with further numbers.
std::vector<std::string> names_of_effects(const FittedHypothesis& fitted) {
  std::vector<std::string> out;
  for (const actuator::EffectKind* kind : fitted.kinds()) out.emplace_back(kind->id());
  std::ranges::sort(out);
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

std::vector<FittedHypothesis> split_off_the_best(std::vector<FittedHypothesis>& all, double overdispersion) {
  constexpr std::size_t of_each_size = 3;
  std::ranges::stable_sort(all, {}, [&](const FittedHypothesis& each) { return quasi_bic(each, overdispersion); });
  std::map<std::size_t, std::vector<std::vector<std::string>>> taken;  // names of effects, by their number
  std::vector<FittedHypothesis> best;
  std::vector<FittedHypothesis> others;
  for (FittedHypothesis& each : all) {
    std::vector<std::string> names = names_of_effects(each);
    std::vector<std::vector<std::string>>& of_its_size = taken[names.size()];
    bool is_taken = std::ranges::find(of_its_size, names) != of_its_size.end();
    if (!is_taken && of_its_size.size() < of_each_size) {
      of_its_size.push_back(std::move(names));
      is_taken = true;
    }
    (is_taken ? best : others).push_back(std::move(each));
  }
  all = std::move(others);
  return best;
}

}  // namespace coilwright::measurement::identification
