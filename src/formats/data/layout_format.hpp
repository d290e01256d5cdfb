#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "coilwright/formats/data/run_file.hpp"
#include "coilwright/text/csv/csv_form.hpp"
#include "coilwright/text/csv/csv_table.hpp"
#include "coilwright/text/json/json.hpp"
#include "coilwright/text/json/object_reader.hpp"

namespace coilwright::formats {

/// A layout, and what it names that a file must have, each with its place.
struct LayoutEntry {
  text::CsvLayout layout{};
  std::vector<std::pair<std::string, text::Node>> named{};  ///< a source, or "sampling_rate_Hz"
};

/// Reads the keys of a layout out of an object that has others too; a key that is there replaces what `base` has.
[[nodiscard]] LayoutEntry read_layout(text::ObjectReader& in, text::CsvLayout base);

/// An object with the keys of a layout added, as read_layout() reads them; no key for what is found in the file.
[[nodiscard]] text::Json with_layout(text::Json object, const text::CsvLayout& layout);

/// The keys of a layout as they are pasted into an object: `"columns": {"Time [s]": "time_s"}`.
[[nodiscard]] std::string pasted(const text::CsvLayout& layout);

/// The error with the advice of with_layout_advice(). `layout` is the entry's own, or that of its input file; `accepts`
/// says whether a header is taken.
[[nodiscard]] text::InputError advised(const text::InputError& error, const text::CsvHeader& header,
                                       const RunEntry& entry, const FileLayout& layout,
                                       const std::function<bool(text::CsvHeader&)>& accepts);

/// Asks a header for its columns by `ask`. Where that throws because the names are others, the error goes on with what
/// to write into dataset.json: the layout that the header would be taken with, or what only a person knows.
template <class Ask>
auto with_layout_advice(text::CsvHeader& header, const RunEntry& entry, const FileLayout& layout, Ask&& ask) {
  try {
    return ask(header);
  } catch (const text::InputError& error) {
    throw advised(error, header, entry, layout, [&](text::CsvHeader& other) {
      try {
        (void)ask(other);
        return true;
      } catch (const text::InputError&) {
        return false;
      }
    });
  }
}

}  // namespace coilwright::formats
