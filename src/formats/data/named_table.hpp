#pragma once

#include "coilwright/text/input_error.hpp"
#include "coilwright/text/json/node.hpp"

namespace coilwright::formats {

/// Whether an error may show what it found in its file: one in the folder of the document that names the file, or a
/// table of numbers wherever it lies. Of all else a document of a stranger could have a line shown, a link included.
[[nodiscard]] bool may_show(const text::InputError& error, const std::string& document);

/// The same error without what was found.
[[nodiscard]] text::InputError without_findings(const text::InputError& error, const std::string& document);

/// Calls `read(path)` for the table that a document names, and shows of it what may_show() allows.
template <class Read>
auto read_named_table(const text::Node& name, const Read& read) {
  try {
    return read(name.path());
  } catch (const text::InputError& error) {
    if (may_show(error, name.file())) throw;
    throw without_findings(error, name.file());
  }
}

}  // namespace coilwright::formats
