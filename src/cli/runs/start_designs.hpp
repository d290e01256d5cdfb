#pragma once

#include <span>
#include <string>

#include "cli/runs/study_run.hpp"

namespace coilwright::cli {

/// Lets the search of a study start from what the archives in other folders of results answer (--start): of one
/// objective the best design, of several the front. Variables are matched by their names, in the units of these;
/// objectives, limits, operating point and what does not vary may differ. A number becomes the nearest that the
/// variable takes, a design with a word that the variable does not take is left out, and a line on standard error says
/// so. Throws InputError for a folder without an archive, without objectives, without a design that keeps its limits or
/// without one of the study's variables, where all designs are left out, and for more designs than the budget has room
/// for.
void add_starts(std::span<const std::string> folders, StudyInput& input);

}  // namespace coilwright::cli
