#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "coilwright/formats/study/result_json.hpp"

namespace coilwright::report {

/// "1200 keep every limit, 700 do not, and 100 could not be evaluated".
[[nodiscard]] std::string to_text(const formats::ArchiveCounts& counts);

/// " The last fifth of them added 2.1 % of what the front dominates: .." where a search ended because of its limit of
/// evaluations, with what to do where there is more to be had; "better the objective" of one objective. Empty
/// otherwise.
[[nodiscard]] std::string late_gain_text(sizing::StopReason reason, const sizing::Archive& archive,
                                         std::size_t evaluations);

/// "the limit of evaluations was reached" for StopReason::evaluation_limit.
[[nodiscard]] std::string_view meaning_of(sizing::StopReason reason);

}  // namespace coilwright::report
