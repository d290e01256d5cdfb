#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/page/page.hpp"

namespace coilwright::page {

/// A script that the page carries, with the notice of its licence.
struct Script {
  std::string_view name;     ///< "vega 6.2.0"
  std::string_view text;     ///< JavaScript
  std::string_view licence;  ///< text of its licence; empty for our own
};

/// The scripts and the style that are packed into a page.
struct PageAssets {
  std::span<const Script> scripts;  ///< in the order in which they run
  std::string_view style;           ///< CSS
};

/// A digest of a text, as letters and digits: SHA-256 in hexadecimal.
using Digest = std::function<std::string(std::string_view)>;

/// A page as one self-contained HTML file. Its content security policy allows only its own scripts and style, which
/// carry the digest of the file's content as nonce. Texts are escaped, and its JSON contains no <.
[[nodiscard]] std::string to_html(const Page& page, const PageAssets& assets, const Digest& digest);

/// A figure of a page as a file of its own.
struct FigureFile {
  std::string name;  ///< "response.vl.json", "pose-rest.svg"
  std::string text;
};

/// Every figure of a page, by its id: a chart as its Vega-Lite specification, which still has to be drawn; a drawing as
/// SVG with `style` (the page's CSS) inside.
[[nodiscard]] std::vector<FigureFile> figure_files(const Page& page, std::string_view style);

}  // namespace coilwright::page
