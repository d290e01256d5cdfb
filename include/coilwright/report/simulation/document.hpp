#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "coilwright/report/simulation/text_table.hpp"
#include "coilwright/text/json/json.hpp"
#include "coilwright/text/json/node.hpp"

namespace coilwright::report {

/// Lines of text, each with its end. Two spaces at the beginning of a line are a level: it belongs to the line above it
/// that has fewer. A line of level 0 is a paragraph.
struct Lines {
  std::string text;
};

/// Texts in rows and columns, formatted for reading.
struct Table {
  std::vector<std::string> header{};
  std::vector<std::vector<std::string>> rows{};  ///< each as long as the header
  std::string note{};                            ///< remark on rows that are not shown; empty: all are
};

/// A table without a picture.
struct TableBlock {
  std::string caption{};  ///< a phrase; a terminal, which has the title above it, leaves it out
  Table table{};
  std::vector<TextTable::Align> align{};  ///< on a terminal; columns without an entry are right-aligned
  bool headed = true;                     ///< whether a terminal shows the header: its cells need it
  std::size_t further_in{};               ///< spaces on a terminal beyond those of its section
};

/// One value with a name.
struct Bar {
  std::string label;
  double value{};
  std::string group;  ///< the group that the legend names, with a colour of its own
};

/// Values side by side, of which a terminal shows nothing, as the table beside them has them: bars from 0.
struct BarChart {
  std::string id;
  std::string title;
  std::string description;
  std::string value_title;  ///< with its unit
  std::string label_title;
  std::vector<Bar> bars{};  ///< in their order on the page
  /// Draws a symbol at each value instead of a bar, with one shape for each group, on an axis that need not begin at 0.
  bool symbols{};
};

/// The content under one heading.
struct Section {
  std::string id;     ///< of its element on a page
  std::string title;  ///< a phrase
  std::vector<std::variant<Lines, TableBlock, BarChart>> blocks{};

  /// Adds lines behind what is there; nothing if there are none.
  void say(const std::string& lines);
};

/// What a result says, before it is printed on a terminal, shown in a notebook or drawn as a page.
struct Document {
  std::string title{};                  ///< name of what was computed, and what was asked for; empty: the reader's file
  std::string verdict{};                ///< the answer, a sentence or a few
  std::vector<std::string> cautions{};  ///< what a reader must see beside it: "BEWARE: ...", as the text of Lines
  std::vector<Section> sections{};      ///< those without blocks are left out
};

/// A section for a terminal: its title, then its blocks, tables two spaces further in.
[[nodiscard]] std::string to_text(const Section& section);

/// The document for a terminal: title, verdict, cautions and sections, with an empty line before each.
[[nodiscard]] std::string to_text(const Document& document);

/// Lines as paragraphs and lists of HTML.
[[nodiscard]] std::string to_html(const Lines& lines);

/// A table as HTML, in a region that scrolls by itself where it is wider than the page.
[[nodiscard]] std::string to_html(const TableBlock& block);

/// The document as HTML for a notebook, without its charts, whose numbers the tables have.
[[nodiscard]] std::string to_html(const Document& document);

/// The document as JSON, the `summary` of a result.
[[nodiscard]] text::Json to_json(const Document& document);

/// Reads that back. Throws text::InputError.
[[nodiscard]] Document read_document(const text::Node& node);

}  // namespace coilwright::report
