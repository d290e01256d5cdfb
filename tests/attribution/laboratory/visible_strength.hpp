#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "attribution/laboratory/plan.hpp"

namespace attribution::laboratory {

/// Five times the smallest strength at which a plan of an experiment (experiment-plan/1, what `coilwright plan --json`
/// prints) says that the effect of this name could be seen: the value of its first number, in the unit of its key, at
/// most its physical bound. Nothing where the plan says that it could not be seen, for an effect without numbers, and
/// for a stop, whose angle is no strength.
[[nodiscard]] std::optional<double> five_times_visible(const std::string& plan_json, const std::string& name);

/// The same of the experiment of a set of one effect, which `program` (coilwright) plans. Throws std::runtime_error
/// with the program's last words where it fails.
[[nodiscard]] std::optional<double> five_times_visible(const Case& asked, const std::filesystem::path& program,
                                                       int threads);

}  // namespace attribution::laboratory
