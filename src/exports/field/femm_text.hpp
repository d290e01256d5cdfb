#pragma once

#include <string_view>

namespace coilwright::exports {

/// What pair.lua does with its numbers: draws coil and magnet, solves, prints the force. Lua 4.0, which FEMM 4.2 has,
/// and every later one.
extern const std::string_view femm_script;

}  // namespace coilwright::exports
