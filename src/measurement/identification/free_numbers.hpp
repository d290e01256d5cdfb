#pragma once

#include <span>

#include "measurement/replay/prepared_run.hpp"

namespace coilwright::measurement::identification {

/// The declared model with each number that a fit may move freely taken by what the records say of it, so that an
/// answer does not depend on what was declared of it. Its typical change is at least what moves the records by a
/// hundred times their noise: a difference by a ten-thousandth of a declared 1e-6 is rounding where 6e-5 is true. And a
/// fit starts where, of the declared value and of 0.01 to 100 times that change, the records are nearest (the second
/// only for a number that cannot be below zero).
[[nodiscard]] replay::DeclaredModel with_free_numbers_of_records(std::span<const replay::PreparedRun> runs,
                                                                 const replay::DeclaredModel& declared);

}  // namespace coilwright::measurement::identification
