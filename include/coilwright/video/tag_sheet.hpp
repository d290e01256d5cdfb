#pragma once

#include <string>

namespace coilwright::video {

/// A PDF of two A4 pages to print at 100 %: six rows of tags whose black square has sides of `tag_size`, m (2 to 40
/// mm), with a ruler of 100 mm; and the board for calibrating a lens. The same size gives the same bytes.
[[nodiscard]] std::string tag_sheet(double tag_size);

}  // namespace coilwright::video
