#include "coilwright/text/output/folder_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <iostream>
#include <system_error>

#include "coilwright/text/one_line.hpp"
#include "coilwright/text/output/output_file.hpp"

namespace coilwright::text {

FolderLock::FolderLock(const std::filesystem::path& folder)
    : descriptor_(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (descriptor_ < 0) return;  // whoever writes into it will say why
  if (flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return;
  if (errno != EWOULDBLOCK) {
    std::cerr << fmt::format(
        "coilwright: {}: cannot be locked ({}): start no other run there until this one has ended\n",
        one_line(folder.string(), 600), std::generic_category().message(errno));
    return;
  }
  close(descriptor_);
  throw OutputError(folder, "another run of coilwright is writing to it; wait for its end, or give another --out",
                    OutputError::Stage::preparing);
}

FolderLock::~FolderLock() {
  if (descriptor_ >= 0) close(descriptor_);  // and with it the lock
}

}  // namespace coilwright::text
