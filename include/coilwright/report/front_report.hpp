#pragma once

#include <string>

#include "coilwright/sizing/search/pareto.hpp"
#include "coilwright/sizing/study/study.hpp"
#include "coilwright/text/json/json.hpp"

namespace coilwright::report {

/// result.json of `pareto`; its keys are in docs/formats.md. `study` has the options that were used.
[[nodiscard]] text::Json to_json(const sizing::Study& study, const sizing::ParetoResult& result);

/// The ends of the front and its middle as a table, or the design nearest to feasible.
[[nodiscard]] std::string to_text(const sizing::Study& study, const sizing::ParetoResult& result);

}  // namespace coilwright::report
