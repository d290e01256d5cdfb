#pragma once

#include <string>

namespace coilwright::exports {

/// One file of an export, complete in memory: the writing is the caller's.
struct ExportedFile {
  std::string name;  ///< a plain file name, without a folder
  std::string text;  ///< UTF-8, lines end with a newline
};

}  // namespace coilwright::exports
