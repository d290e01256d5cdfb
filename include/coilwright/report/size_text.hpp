#pragma once

#include <string>

#include "coilwright/formats/study/size_json.hpp"

namespace coilwright::report {

/// What `size` found, for a person: the best design, the limits that hold it back and what a step of each variable
/// does.
[[nodiscard]] std::string to_text(const formats::SizeReport& report);

}  // namespace coilwright::report
