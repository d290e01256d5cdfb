#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "coilwright/page/page.hpp"

namespace coilwright::page {

/// A figure of a page as a file of its own.
struct FigureFile {
  std::string name;  ///< "response.vl.json", "pose-rest.svg"
  std::string text;
};

/// Every figure of a page, by its id: a chart as its Vega-Lite specification, which is yet to be drawn; a drawing as
/// SVG with `style` (the page's CSS) inside.
[[nodiscard]] std::vector<FigureFile> figure_files(const Page& page, std::string_view style);

}  // namespace coilwright::page
