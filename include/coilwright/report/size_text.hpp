#pragma once

#include <string>

#include "coilwright/formats/study/size_json.hpp"

namespace coilwright::report {

/// The stop reason of a run that was interrupted after its search had ended.
inline constexpr const char* interrupted_after_search =
    "INTERRUPTED when the search was over: what is missing below was not looked at; --resume goes on.";

/// The results of `size` for a person: the best design, the limits that hold it back and the effect of a step of each
/// variable.
[[nodiscard]] std::string to_text(const formats::SizeReport& report);

}  // namespace coilwright::report
