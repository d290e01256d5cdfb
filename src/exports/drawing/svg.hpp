#pragma once

#include <string>
#include <string_view>

#include "exports/drawing/sketch.hpp"

namespace coilwright::exports {

/// What an SVG says about itself.
struct SvgText {
  std::string_view title;
  std::string_view description;
};

/// A complete SVG of a sketch, `scale` times as large as the part where it is printed as it is. Its user unit is a
/// millimetre of the part.
[[nodiscard]] std::string svg_of(const Sketch& sketch, double scale, const SvgText& text);

}  // namespace coilwright::exports
