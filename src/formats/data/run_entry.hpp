#pragma once

#include <filesystem>
#include <map>
#include <optional>

#include "coilwright/formats/data/run_file.hpp"
#include "coilwright/text/json/node.hpp"

namespace coilwright::formats {

/// A run of a data set, with its files.
struct RunInSet {
  RunFile file;
  bool validate{};                                    ///< whether fits must not see it; never a still run
  std::optional<std::filesystem::path> input_file{};  ///< which runs may share
};

/// Reads one element of "runs", and its files. `met` are the run files so far as the set names them, by where links
/// lead, to which its own is added; `set` is the layout that the set has for all, `usual` what it says of the inputs of
/// motions that say nothing of their own. Throws InputError: of the element before its files, then of those.
[[nodiscard]] RunInSet read_run_in_set(const text::Node& node,
                                       std::map<std::filesystem::path, std::filesystem::path>& met,
                                       const text::CsvLayout& set, const measurement::data::InputUncertainty& usual);

}  // namespace coilwright::formats
