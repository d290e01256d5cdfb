#pragma once

#include <string_view>

namespace coilwright::exports {

/// Comment of mould.scad that says how its parts become files.
extern const std::string_view how_to_render;

/// What of mould.scad is the same for every actuator: the choices of whoever prints the mould, and the modules.
extern const std::string_view scad_modules;

}  // namespace coilwright::exports
