// Memory that fails, for a program that is started with it (LD_PRELOAD): glibc's, but that the allocation of the number
// COILWRIGHT_FAIL_AT gives none, nor any after it where COILWRIGHT_FAIL_ON is set. Without these variables it only
// counts: COILWRIGHT_COUNT names the file that gets the number of allocations at the end.
#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstdlib>

extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* old, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
}

namespace {

std::atomic<long> made{0};
long fail_at = 0;
bool fail_on = false;
const char* count_in = nullptr;

[[gnu::constructor]] void begin() {
  const char* at = std::getenv("COILWRIGHT_FAIL_AT");
  fail_at = at != nullptr ? std::atol(at) : 0;
  fail_on = std::getenv("COILWRIGHT_FAIL_ON") != nullptr;
  count_in = std::getenv("COILWRIGHT_COUNT");
}

[[gnu::destructor]] void end() {
  if (count_in == nullptr) return;
  char text[32];
  const int size = std::snprintf(text, sizeof text, "%ld", made.load());
  const int file = open(count_in, O_WRONLY | O_CREAT | O_TRUNC, 0644);
  if (write(file, text, static_cast<std::size_t>(size)) != size) std::abort();
  close(file);
}

bool fails() {
  const long number = ++made;
  if (fail_at == 0 || number < fail_at || (number > fail_at && !fail_on)) return false;
  errno = ENOMEM;
  return true;
}

}  // namespace

extern "C" {

void* malloc(std::size_t size) {
  return fails() ? nullptr : __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) {
  return fails() ? nullptr : __libc_calloc(count, size);
}
void* realloc(void* old, std::size_t size) {
  return fails() ? nullptr : __libc_realloc(old, size);
}
void* memalign(std::size_t alignment, std::size_t size) {
  return fails() ? nullptr : __libc_memalign(alignment, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  return fails() ? nullptr : __libc_memalign(alignment, size);
}
int posix_memalign(void** out, std::size_t alignment, std::size_t size) {
  if (fails()) return ENOMEM;
  *out = __libc_memalign(alignment, size);
  return *out == nullptr ? ENOMEM : 0;
}
}
