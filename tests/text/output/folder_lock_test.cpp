#include "coilwright/text/output/folder_lock.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>

#include "coilwright/text/output/output_file.hpp"
#include "temporary_folder.hpp"

namespace {
bool has_locks = true;
}

// In place of the system's: a file system without locks.
extern "C" int flock(int file, int operation) noexcept {
  if (has_locks) return static_cast<int>(syscall(SYS_flock, file, operation));
  errno = ENOLCK;
  return -1;
}

namespace coilwright::text {
namespace {

using coilwright::testing::TemporaryFolder;
using ::testing::ThrowsMessage;
using ::testing::internal::CaptureStderr;
using ::testing::internal::GetCapturedStderr;

TEST(FolderLock, IsOfOneAtATime) {
  const TemporaryFolder folder;
  const auto lock = [&] { const FolderLock second(folder.path()); };
  {
    const FolderLock first(folder.path());
    EXPECT_THAT(lock, ThrowsMessage<OutputError>(folder.path().string() +
                                                 ": cannot be written: another run of coilwright is writing to "
                                                 "it; wait for its end, or give another --out"));
  }
  EXPECT_NO_THROW(lock());
}

TEST(FolderLock, SaysInALineWhereThereAreNone) {
  const TemporaryFolder folder;
  has_locks = false;
  CaptureStderr();
  const FolderLock lock(folder.path());
  EXPECT_EQ(GetCapturedStderr(), "coilwright: " + folder.path().string() +
                                     ": cannot be locked (No locks available): start no other run there until this one "
                                     "has ended\n");
  has_locks = true;
}

}  // namespace
}  // namespace coilwright::text
