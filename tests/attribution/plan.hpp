#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "truth/data_set.hpp"

namespace attribution {

/// What is hidden in a set: one effect of the catalogue, nothing, two effects, or an effect outside the catalogue.
enum class Category { one, nothing, two, outsider };

[[nodiscard]] std::string_view name_of(Category category);

/// A set to be simulated and diagnosed.
struct Case {
  int number{};
  Category category{};
  truth::DataSetRequest request;
};

/// Sets `first` to `first + count - 1` of the infinite sequence that belongs to `seed`. Of six consecutive sets three
/// hide one effect, one hides nothing, one two effects and one an outsider; the ids of the catalogue, and the
/// outsiders, follow each other in random order, each once per round: those of the first catalogue. Two of its nine
/// outsiders have become effects since and count as such. So 120 sets are at least 60, 20, 20 and at most 16 outsiders,
/// and every id is hidden alone at least twice. coil_coil_force is never one of two: its strength in the run where it
/// is largest is half a standard deviation of the noise.
[[nodiscard]] std::vector<Case> plan(int first, int count, std::uint64_t seed);

}  // namespace attribution
