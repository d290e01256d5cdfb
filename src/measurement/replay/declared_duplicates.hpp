#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "coilwright/measurement/replay/declared_model.hpp"

namespace coilwright::measurement::replay {

/// A number of a declared model that no motion can tell from another one.
struct DuplicateNumber {
  std::size_t number{};                ///< index among the calibration
  std::optional<std::size_t> alike{};  ///< the earlier number that moves the model in the same way; nothing: it moves
                                       ///< nothing at all
};

/// The numbers from index `first` on whose small changes have the same effect on every joint's acceleration, up to one
/// factor, as those of an earlier number that is no such duplicate itself: a mass and its distance on an axis without
/// gravity. Compared in a dozen poses and rates under currents (torques, for a model without coils), joints pressed
/// closed among them. Throws as the model's build().
[[nodiscard]] std::vector<DuplicateNumber> duplicate_numbers(const DeclaredModel& declared, std::size_t first);

}  // namespace coilwright::measurement::replay
