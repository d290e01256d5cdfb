#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "coilwright/report/simulation/document.hpp"
#include "coilwright/text/json/json.hpp"

namespace coilwright::page {

using report::Lines;
using report::Table;
using report::TableBlock;

/// A picture drawn by the program: a complete svg element, which takes its colours from the page's style.
struct Drawing {
  std::string svg;
};

/// A picture in a file of its own, shown as an image with its own style.
struct Image {
  std::string svg;
};

/// A picture with the text that replaces it for readers who cannot see it.
struct Figure {
  std::string id;     ///< "response": of its element, and of its file with --figures; unique in a page
  std::string title;  ///< a phrase
  /// A description of the picture in a sentence or two, which stands for it.
  std::string description;
  std::variant<text::Json, Drawing, Image> content;  ///< a Vega-Lite specification, or a drawing
  Table table{};                                     ///< numbers of the picture; empty if a table beside it has them
};

/// A place that the page's script fills. Its element has this id and begins with `html`, which is written unchanged.
struct Widget {
  std::string html;
};

using Block = std::variant<Lines, TableBlock, Figure, Widget>;

/// The content under one heading.
struct Section {
  std::string id;
  std::string title;
  std::vector<Block> blocks{};
};

/// JSON that the page's script reads, by the id of its element.
struct DataBlock {
  std::string id;
  std::string json;
};

/// A report before it becomes a file.
struct Page {
  std::string title;
  std::string verdict;                  ///< one sentence or a few, shown first
  std::vector<std::string> cautions{};  ///< what a reader must see beside it, as the text of Lines
  std::string origin;                   ///< program, version, command: one line
  std::vector<std::string> inputs{};    ///< the files that it is made of, with their hashes, a line each
  std::vector<Section> sections{};
  std::vector<DataBlock> data{};
};

}  // namespace coilwright::page
