#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "coilwright/measurement/data/run.hpp"

namespace coilwright::measurement::data {

/// Whether a record shows an instrument at rest: its input stays where it is, and its angles spread by less than 5
/// degrees, alike at the begin and at the end. A record without an angle is none.
[[nodiscard]] bool nothing_moves(const Run& run);

/// Whether two motions are one experiment, recorded twice: inputs and readings that agree to a tenth and a sixth of
/// their range (rms), after a shift of at most a third of the shorter one, as two of a person's begins differ. Two with
/// the same readings to the last digit are one record and its copy.
[[nodiscard]] bool is_repeated(const Run& run, const Run& other);

/// For each run the index of the first one that it repeats (is_repeated), or its own.
[[nodiscard]] std::vector<std::size_t> experiments_of(std::span<const Run> runs);

}  // namespace coilwright::measurement::data
