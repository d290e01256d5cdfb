#pragma once

#include <string>

#include "coilwright/formats/study/size_json.hpp"

namespace coilwright::report {

/// Of a run whose search came to its end, and which was interrupted behind it.
inline constexpr const char* interrupted_after_search =
    "INTERRUPTED when the search was over: what is missing below was not looked at; --resume goes on.";

/// What `size` found, for a person: the best design, the limits that hold it back and what a step of each variable
/// does.
[[nodiscard]] std::string to_text(const formats::SizeReport& report);

}  // namespace coilwright::report
