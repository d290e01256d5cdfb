#pragma once

#include <string>
#include <vector>

namespace coilwright::exports {

/// One file of an export, complete in memory: the writing is the caller's.
struct ExportedFile {
  std::string name;  ///< a plain file name, without a folder
  std::string text;  ///< UTF-8, lines end with a newline
  /// What of the actuator the file cannot say, one line each without a full stop: the text names it too.
  std::vector<std::string> left_out{};
  /// Why that is so much that the file is of another actuator, without a full stop; empty where it is not.
  std::string too_much{};
};

}  // namespace coilwright::exports
