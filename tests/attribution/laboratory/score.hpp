#pragma once

#include <string>

#include "attribution/laboratory/outcome.hpp"
#include "attribution/laboratory/plan.hpp"
#include "truth/laboratory/laboratory_set.hpp"

namespace attribution::laboratory {

/// Compares a diagnosis.json (diagnosis/1) with what is true of the set. Only keys of the format are read, so that any
/// program's diagnosis can be scored. Throws what nlohmann::json throws for a text that is none.
[[nodiscard]] Outcome score(const Case& asked, const truth::laboratory::LaboratorySet& set,
                            const std::string& diagnosis_json);

}  // namespace attribution::laboratory
