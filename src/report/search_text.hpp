#pragma once

#include <string>
#include <string_view>

#include "coilwright/formats/study/search_json.hpp"

namespace coilwright::report {

/// "1200 kept every limit, 700 did not, 100 could not be evaluated".
[[nodiscard]] std::string to_text(const formats::ArchiveCounts& counts);

/// "the evaluations allowed were made" for StopReason::evaluation_limit.
[[nodiscard]] std::string_view meaning_of(sizing::StopReason reason);

}  // namespace coilwright::report
