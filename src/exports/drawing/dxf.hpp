#pragma once

#include <string>

#include "exports/drawing/sketch.hpp"

namespace coilwright::exports {

/// A complete DXF file of a sketch, in the ASCII form of release 12, which every program that knows DXF reads: lines,
/// circles and texts on a layer each for body, windings, magnets, slits, axes, dimensions and notes, at the size of the
/// part in mm. Letters beyond ASCII, which release 12 does not have, are question marks, but for the sign of a
/// diameter.
[[nodiscard]] std::string dxf_of(const Sketch& sketch);

}  // namespace coilwright::exports
