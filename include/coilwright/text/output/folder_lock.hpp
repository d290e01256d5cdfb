#pragma once

#include <filesystem>

namespace coilwright::text {

/// A lock on a folder that no other process can have at the same time. It ends with the process, however that ends, and
/// leaves no file.
class FolderLock {
 public:
  /// Locks the folder. Throws OutputError (preparing) if another process has the lock. If the file system has no such
  /// locks, a line on standard error says so.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int descriptor_;
};

}  // namespace coilwright::text
