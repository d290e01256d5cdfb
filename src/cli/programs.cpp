#include "cli/programs.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/mman.h>
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

}  // namespace

std::span<const CommandPlace> command_places() {
  return places;
}

const CommandPlace* place_of(std::string_view command) {
  const auto found = std::ranges::find(places, command, &CommandPlace::name);
  return found == places.end() ? nullptr : &*found;
}

void go_on_in(std::string_view program, std::span<const char* const> arguments) {
  const std::string file = file_of(program);
  std::vector<std::string> words(arguments.begin(), arguments.end());
  execv(file.c_str(), ended_by_null(words).data());
  throw cannot_run(file, errno);
}

Ended run_program(std::string_view program, const std::vector<std::string>& arguments, Stream stream) {
  const std::string file = file_of(program);
  std::vector<std::string> words{"coilwright"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const int kept = memfd_create("printed", MFD_CLOEXEC);  // a file in memory: it takes any length, and nobody waits
  posix_spawn_file_actions_t streams;
  posix_spawn_file_actions_init(&streams);
  posix_spawn_file_actions_adddup2(&streams, kept, static_cast<int>(stream));
  if (stream == Stream::errors) posix_spawn_file_actions_addopen(&streams, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  pid_t child{};
  const int failed = posix_spawn(&child, file.c_str(), &streams, nullptr, ended_by_null(words).data(), environ);
  posix_spawn_file_actions_destroy(&streams);
  int status{};
  if (failed == 0)
    while (waitpid(child, &status, 0) == -1 && errno == EINTR) continue;
  std::ostringstream printed;
  if (failed == 0) printed << std::ifstream(fmt::format("/proc/self/fd/{}", kept)).rdbuf();
  close(kept);
  if (failed != 0) throw cannot_run(file, failed);
  return {.status = WIFEXITED(status) ? WEXITSTATUS(status) : 1, .printed = printed.str()};
}

}  // namespace coilwright::cli
