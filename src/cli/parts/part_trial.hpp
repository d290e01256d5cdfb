#pragma once

#include <functional>
#include <string>
#include <vector>

#include "coilwright/text/output/output_folder.hpp"

namespace coilwright::cli {

/// Tries the first part of a run for three seconds, in a folder of its own that `fill` puts its files into: what no
/// part can run with is refused by each in its first moments. Throws text::InputError with the reason where the input
/// is wrong, and std::runtime_error where the part fails otherwise.
void require_part_runs(const std::vector<std::string>& arguments, const std::function<void(text::OutputFolder&)>& fill);

}  // namespace coilwright::cli
