#include "cli/programs.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <system_error>

namespace coilwright::cli {
namespace {

constexpr std::array places{
#define COMMAND(name, program, help) CommandPlace{#name, #program, help},
#include "cli/commands.def"
#undef COMMAND
};

std::string file_of(std::string_view program) {
#ifdef COILWRIGHT_ONE_PROGRAM
  (void)program;
  return "/proc/self/exe";
#else
  const std::filesystem::path here = std::filesystem::read_symlink("/proc/self/exe").parent_path();
  return (here / (program == "coilwright" ? std::string(program) : fmt::format("coilwright-{}", program))).string();
#endif
}

std::runtime_error cannot_run(const std::string& file, int error) {
  const std::string why = std::generic_category().message(error);
  if (error != ENOENT) return std::runtime_error(fmt::format("{} cannot be run: {}", file, why));
  return std::runtime_error(fmt::format(
      "{} is not there: it has this command. Build it (cmake --build --preset release --target {}), or install all of "
      "Coilwright",
      file, std::filesystem::path(file).filename().string()));
}

std::vector<char*> ended_by_null(std::vector<std::string>& words) {
  std::vector<char*> out;
  for (std::string& word : words) out.push_back(word.data());
  out.push_back(nullptr);
  return out;
}

// It takes any length, and nobody waits for a reader.
class FileInMemory {
 public:
  FileInMemory() = default;
  ~FileInMemory() { close(descriptor_); }
  FileInMemory(const FileInMemory&) = delete;
  FileInMemory& operator=(const FileInMemory&) = delete;

  [[nodiscard]] int descriptor() const { return descriptor_; }
  [[nodiscard]] std::string text() const {
    std::ostringstream out;
    out << std::ifstream(fmt::format("/proc/self/fd/{}", descriptor_)).rdbuf();
    return out.str();
  }

 private:
  int descriptor_ = memfd_create("stream", MFD_CLOEXEC);
};

}  // namespace

std::span<const CommandPlace> command_places() {
  return places;
}

const CommandPlace* place_of(std::string_view command) {
  const auto found = std::ranges::find(places, command, &CommandPlace::name);
  return found == places.end() ? nullptr : &*found;
}

namespace {

// Where the system has no memory for a program and its libraries, it ends it by a signal, or its loader does, in words
// of its own. So it is tried first, where its memory is limited.
void require_memory_for(std::string_view program) {
  rlimit addresses{};
  if (getrlimit(RLIMIT_AS, &addresses) != 0 || addresses.rlim_cur == RLIM_INFINITY) return;
  try {
    (void)run_program(program, {"--version"});
  } catch (const std::exception&) {
    throw std::runtime_error(fmt::format("out of memory: {} MB (ulimit -v) do not take {} and its libraries",
                                         addresses.rlim_cur / 1'000'000, file_of(program)));
  }
}

}  // namespace

void go_on_in(std::string_view program, std::span<const char* const> arguments) {
  require_memory_for(program);
  const std::string file = file_of(program);
  std::vector<std::string> words(arguments.begin(), arguments.end());
  execv(file.c_str(), ended_by_null(words).data());
  throw cannot_run(file, errno);
}

Printed run_program(std::string_view program, const std::vector<std::string>& arguments) {
  const std::string file = file_of(program);
  std::vector<std::string> words{"coilwright"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const FileInMemory output;
  const FileInMemory errors;
  posix_spawn_file_actions_t streams;
  posix_spawn_file_actions_init(&streams);
  posix_spawn_file_actions_adddup2(&streams, output.descriptor(), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&streams, errors.descriptor(), STDERR_FILENO);
  pid_t child{};
  const int failed = posix_spawn(&child, file.c_str(), &streams, nullptr, ended_by_null(words).data(), environ);
  posix_spawn_file_actions_destroy(&streams);
  if (failed != 0) throw cannot_run(file, failed);
  int status{};
  while (waitpid(child, &status, 0) == -1 && errno == EINTR) continue;
  Printed out{.output = output.text(), .errors = errors.text()};
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return out;
  constexpr std::string_view name = "coilwright: ";
  throw std::runtime_error(out.errors.starts_with(name) ? out.errors.substr(name.size())
                                                        : fmt::format("{} failed", file));
}

}  // namespace coilwright::cli
