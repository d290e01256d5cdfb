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
#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <thread>

#include "cli/commands.hpp"

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

// A program that was started, with what it prints.
class Child {
 public:
  Child(const std::string& file, const std::vector<std::string>& arguments, const std::string& folder) {
    std::vector<std::string> words{"coilwright"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    posix_spawn_file_actions_t streams;
    posix_spawn_file_actions_init(&streams);
    posix_spawn_file_actions_adddup2(&streams, output_.descriptor(), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&streams, errors_.descriptor(), STDERR_FILENO);
    posix_spawn_file_actions_addchdir_np(&streams, folder.c_str());
    const int failed = posix_spawn(&id_, file.c_str(), &streams, nullptr, ended_by_null(words).data(), environ);
    posix_spawn_file_actions_destroy(&streams);
    if (failed != 0) throw cannot_run(file, failed);
  }

  // The exit code; 128 and the signal where one ended it, as a shell has it.
  [[nodiscard]] int wait() const { return *status(0); }
  [[nodiscard]] std::optional<int> ended() const { return status(WNOHANG); }
  void kill() const {
    ::kill(id_, SIGKILL);
    (void)wait();
  }
  [[nodiscard]] std::string output() const { return output_.text(); }
  [[nodiscard]] std::string errors() const { return errors_.text(); }

 private:
  [[nodiscard]] std::optional<int> status(int how) const {
    int out{};
    pid_t found{};
    while ((found = waitpid(id_, &out, how)) == -1 && errno == EINTR) continue;
    if (found == 0) return std::nullopt;
    return WIFEXITED(out) ? WEXITSTATUS(out) : 128 + WTERMSIG(out);
  }

  FileInMemory output_, errors_;
  pid_t id_{};
};

// What a program says that fails, after its warnings.
std::optional<std::string> line_of(const std::string& errors) {
  constexpr std::string_view name = "coilwright: ";
  const std::size_t begin = errors.starts_with(name) ? 0 : errors.find(fmt::format("\n{}", name));
  if (begin == std::string::npos) return std::nullopt;
  std::string line = errors.substr(begin + name.size() + (begin > 0 ? 1 : 0));
  while (line.ends_with('\n')) line.pop_back();
  return line;
}

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
  const Child child(file_of(program), arguments, ".");
  const int status = child.wait();
  Printed out{.output = child.output(), .errors = child.errors()};
  if (status == 0) return out;
  throw std::runtime_error(line_of(out.errors).value_or(fmt::format("{} failed", file_of(program))));
}

std::optional<Failure> failure_within(std::chrono::milliseconds longest, const std::filesystem::path& folder,
                                      const std::vector<std::string>& arguments) {
  const Child child("/proc/self/exe", arguments, folder.string());
  const auto end = std::chrono::steady_clock::now() + longest;
  std::optional<int> status;
  while (!(status = child.ended()) && std::chrono::steady_clock::now() < end)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  if (!status) {
    child.kill();
    return std::nullopt;
  }
  if (*status == 0 || *status == static_cast<int>(ExitCode::infeasible)) return std::nullopt;
  return Failure{.code = *status, .line = line_of(child.errors()).value_or("it ended without a word")};
}

}  // namespace coilwright::cli
