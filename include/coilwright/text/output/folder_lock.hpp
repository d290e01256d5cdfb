#pragma once

#include <filesystem>

namespace coilwright::text {

/// While it lives, no other process has this lock on the folder. It ends with the process, however that ends, and
/// leaves no file.
class FolderLock {
 public:
  /// Throws OutputError (preparing) where another process has it. Where the file system has no such locks, that
  /// is said in a line on standard error.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int descriptor_;
};

}  // namespace coilwright::text
