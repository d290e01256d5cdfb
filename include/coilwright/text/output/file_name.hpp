#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace coilwright::text {

/// Which of some names cannot be that of a file, and why.
struct FileNameFault {
  std::size_t index{};
  std::string rule{};  ///< "must be a plain file name", ..
};

/// The rule for every name that comes from a person and becomes a file in a folder: one that no system reads as the way
/// to another folder (no / and no \), or as the folder or what lies above it (. and ..), not empty, on one line without
/// control characters. The rule that `name` breaks; nothing where it keeps all.
[[nodiscard]] std::optional<std::string> fault_of_file_name(std::string_view name);

/// The same for names that become files of one folder: of any two, capitals are not all that differs, as there are
/// systems on which they are one file. The first fault; nothing where all can be written.
[[nodiscard]] std::optional<FileNameFault> fault_of_file_names(std::span<const std::string> names);

}  // namespace coilwright::text
