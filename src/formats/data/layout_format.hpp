#pragma once

#include <string>
#include <utility>
#include <vector>

#include "coilwright/text/csv/csv_layout.hpp"
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

}  // namespace coilwright::formats
