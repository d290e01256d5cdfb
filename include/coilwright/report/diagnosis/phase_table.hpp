#pragma once

#include <span>
#include <string>

#include "coilwright/measurement/diagnosis.hpp"

namespace coilwright::report {

/// The time of a diagnosis for a person: seconds and simulated runs, a line for each phase, and their total. Two runs
/// differ in it, so it belongs to the progress and to no file. Empty without phases.
[[nodiscard]] std::string to_text(std::span<const measurement::Phase> phases);

}  // namespace coilwright::report
