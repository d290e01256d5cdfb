#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "truth/data_set.hpp"

namespace attribution {

/// What is hidden in a set.
enum class Category { one, nothing, two, outsider };

[[nodiscard]] std::string_view name_of(Category category);

/// A set to be made and diagnosed.
struct Case {
  int number{};
  Category category{};
  truth::Order order;
};

/// Sets number `first` to `first + count - 1` of the endless row that belongs to `seed`: of six in a row three hide one
/// effect, one nothing, one two effects, one an outsider; the ids of the catalogue, and the outsiders, take turns in an
/// order of chance. So 120 sets are 60, 20, 20, 20, and every id is hidden alone at least twice. coil_coil_force is
/// never one of two: half a standard deviation of the noise in the run that shows it best is no fair second.
[[nodiscard]] std::vector<Case> plan(int first, int count, std::uint64_t seed);

}  // namespace attribution
