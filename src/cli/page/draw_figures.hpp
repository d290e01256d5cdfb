#pragma once

#include <string>
#include <vector>

#include "coilwright/page/page_html.hpp"

namespace coilwright::cli {

/// The files with every chart (NAME.vl.json) drawn as NAME.svg beside it, by the packed Vega in Node, where that is
/// installed. Charts that could not be drawn are left as they are; `why` then says why, as a sentence, and is empty
/// otherwise.
struct DrawnFigures {
  std::vector<page::FigureFile> files;
  std::string why;
};
[[nodiscard]] DrawnFigures draw_figures(std::vector<page::FigureFile> files);

}  // namespace coilwright::cli
