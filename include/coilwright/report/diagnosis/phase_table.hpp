#pragma once

#include <span>
#include <string>

#include "coilwright/measurement/diagnosis.hpp"

namespace coilwright::report {

/// Where the time of a diagnosis went, for a person: seconds and simulated runs, a line a phase, and their total. No
/// two runs give the same, so it belongs to the progress and into no file. Empty where there is no phase.
[[nodiscard]] std::string to_text(std::span<const measurement::Phase> phases);

}  // namespace coilwright::report
