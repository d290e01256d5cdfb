#pragma once

#include <cstddef>
#include <span>

#include "coilwright/sizing/search/pareto.hpp"
#include "coilwright/sizing/study/broken_part_limits.hpp"
#include "coilwright/sizing/study/study.hpp"
#include "coilwright/text/json/json.hpp"

namespace coilwright::formats {

/// Index of the design of a front that is best in one objective. The front must not be empty.
[[nodiscard]] std::size_t end_of(const sizing::ParetoResult& result, std::size_t objective);

/// Index of the design of a front whose worst objective, from ideal to nadir, is least bad. The front must not be
/// empty.
[[nodiscard]] std::size_t middle_of(const sizing::ParetoResult& result);

/// result.json of `pareto`; its keys are in docs/formats-results.md. `study` has the options that were used, `broken`
/// the limits of parts that designs of the front break.
[[nodiscard]] text::Json to_json(const sizing::Study& study, const sizing::ParetoResult& result,
                                 std::span<const sizing::BrokenPartLimit> broken);

}  // namespace coilwright::formats
