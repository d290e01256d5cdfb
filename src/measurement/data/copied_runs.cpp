#include "coilwright/measurement/data/copied_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <functional>

namespace coilwright::measurement::data {
namespace {

// Fewer readings of coarse resolution may agree by chance.
constexpr std::size_t fewest_readings = 20;

bool may_be_copied(const Run& run) {
  return run.samples() >= fewest_readings && std::ranges::any_of(run.channels, [](const Channel& each) {
           return std::ranges::adjacent_find(each.values, std::ranges::not_equal_to()) != each.values.end();
         });
}

bool has_readings_of(const Run& run, const Run& other) {
  return run.kind == other.kind &&
         std::ranges::equal(run.channels, other.channels, {}, &Channel::values, &Channel::values);
}

}  // namespace

std::vector<Warning> copied_runs(std::span<const Run> fit, std::span<const Run> validate) {
  std::vector<const Run*> runs;
  for (const std::span<const Run> some : {fit, validate})
    for (const Run& run : some) runs.push_back(&run);
  std::vector<Warning> out;
  for (std::size_t i = 1; i < runs.size(); ++i) {
    if (!may_be_copied(*runs[i])) continue;
    const auto before = std::span(runs).first(i);
    const auto original =
        std::ranges::find_if(before, [&](const Run* each) { return has_readings_of(*runs[i], *each); });
    if (original == before.end()) continue;
    out.push_back(
        {.run = runs[i]->name,
         .text = fmt::format("has the readings of {}, every one: a copy tells nothing new, and held out of the "
                             "fit it is no test of it",
                             (*original)->name)});
  }
  return out;
}

}  // namespace coilwright::measurement::data
