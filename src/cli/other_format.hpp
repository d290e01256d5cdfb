#pragma once

#include "coilwright/text/input_error.hpp"

namespace coilwright::cli {

/// Of a file of another format of this program: the same, with what that file is and which command takes it.
[[nodiscard]] text::InputError with_next_step(const text::InputError& error);

}  // namespace coilwright::cli
