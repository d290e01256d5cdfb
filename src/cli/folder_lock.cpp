#include "folder_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>

#include "coilwright/text/output/output_file.hpp"

namespace coilwright::cli {

FolderLock::FolderLock(const std::filesystem::path& folder)
    : descriptor_(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (descriptor_ < 0) return;  // whoever writes into it will say why
  if (flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  close(descriptor_);
  throw text::OutputError(folder, "another run of coilwright is writing to it; wait for its end, or give another --out",
                          text::OutputError::Stage::preparing);
}

FolderLock::~FolderLock() {
  if (descriptor_ >= 0) close(descriptor_);  // and with it the lock
}

}  // namespace coilwright::cli
