#pragma once

#include <string>
#include <string_view>

#include "coilwright/formats/study/search_json.hpp"

namespace coilwright::report {

/// "1200 keep every limit, 700 do not, and 100 could not be evaluated".
[[nodiscard]] std::string to_text(const formats::ArchiveCounts& counts);

/// "the limit of evaluations was reached" for StopReason::evaluation_limit.
[[nodiscard]] std::string_view meaning_of(sizing::StopReason reason);

}  // namespace coilwright::report
