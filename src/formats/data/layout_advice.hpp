#pragma once

#include <functional>
#include <string>

#include "coilwright/formats/data/run_file.hpp"
#include "coilwright/text/csv/csv_table.hpp"

namespace coilwright::formats {

/// Asks a header for its columns by `ask`. Where that throws because the names are others, the error goes on with what
/// to write into dataset.json: the layout that the header would be taken with, or what only a person knows.
template <class Ask>
auto with_layout_advice(text::CsvHeader& header, const RunEntry& entry, const FileLayout& layout, Ask&& ask);

/// The keys of a layout as they are pasted into an object: `"columns": {"Time [s]": "time_s"}`.
[[nodiscard]] std::string pasted(const text::CsvLayout& layout);

/// The error with that advice. `layout` is the entry's own, or that of its input file; `accepts` says whether a header
/// is taken.
[[nodiscard]] text::InputError advised(const text::InputError& error, const text::CsvHeader& header,
                                       const RunEntry& entry, const FileLayout& layout,
                                       const std::function<bool(text::CsvHeader&)>& accepts);

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
