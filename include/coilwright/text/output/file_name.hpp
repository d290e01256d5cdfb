#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace coilwright::text {

/// The first of some names that cannot be that of a file, and the reason.
struct FileNameFault {
  std::size_t index{};
  std::string rule{};  ///< "must be a plain file name", ..
};

/// Checks a name from a person that becomes a file in a folder. No system may read it as a path to another folder (no /
/// and no \), or as the folder or its parent (. and ..); it must not be empty and must be one line without control
/// characters. Returns the rule that `name` breaks; absent if it keeps all.
[[nodiscard]] std::optional<std::string> fault_of_file_name(std::string_view name);

/// Checks names that become files of one folder: also, two names must differ by more than capitals, because some
/// systems take them for one file. Returns the first fault; absent if all can be written.
[[nodiscard]] std::optional<FileNameFault> fault_of_file_names(std::span<const std::string> names);

}  // namespace coilwright::text
