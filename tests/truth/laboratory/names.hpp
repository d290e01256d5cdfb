#pragma once

#include <string_view>

#include "truth/laboratory/request.hpp"

namespace truth::laboratory {

/// The words of programs and answers: "within", "listed", "beside_pictures", "low_passed", "elsewhere", "rig_changes".
[[nodiscard]] std::string_view name_of(Deviation deviation);
[[nodiscard]] std::string_view name_of(Tolerances tolerances);
[[nodiscard]] std::string_view name_of(InputLog log);
[[nodiscard]] std::string_view name_of(Colour colour);
[[nodiscard]] std::string_view name_of(DeclaredFaces faces);
[[nodiscard]] std::string_view name_of(Programme programme);

}  // namespace truth::laboratory
