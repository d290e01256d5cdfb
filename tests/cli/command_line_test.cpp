#include "cli/command_line.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <array>
#include <new>
#include <stdexcept>

#include "coilwright/text/input_error.hpp"
#include "coilwright/text/output/output_file.hpp"

namespace coilwright::cli {
namespace {

using text::OutputError;

/// A command of its own for each way to end.
template <class... Action>
void add(CLI::App& app, const char* name, Action... action) {
  app.add_subcommand(name)->callback([action...] { (action(), ...); });
}

[[noreturn]] void lack_memory() {
  throw std::bad_alloc();
}

void add_endings(CLI::App& app, Outcome& outcome) {
  add(app, "well");
  add(app, "infeasible", [&outcome] { outcome.code = ExitCode::infeasible; });
  add(app, "interrupted", [&outcome] { outcome.code = ExitCode::interrupted; });
  add(app, "input", [] { throw text::InputError({.file = "x.json", .place = "/a", .rule = "is missing"}); });
  add(app, "folder", [] { throw OutputError("out", "Permission denied", OutputError::Stage::preparing); });
  add(app, "disk", [] { throw OutputError("out", "No space left on device", OutputError::Stage::writing); });
  add(app, "memory", &lack_memory);
  add(app, "memory_in_c", []() noexcept { lack_memory(); });
  add(app, "other", [] { throw std::runtime_error("two\nlines"); });
}

struct Ending {
  int code{};
  std::string error{};
  bool operator==(const Ending&) const = default;
};

void PrintTo(const Ending& ending, std::ostream* out) {
  *out << ending.code << " " << ending.error;
}

Ending ending_of(const char* command) {
  constexpr std::array commands{Command{"evaluate", add_endings}};
  const std::array arguments = {"coilwright", command};
  ::testing::internal::CaptureStderr();
  const ExitCode code = run(arguments, commands);
  return {.code = static_cast<int>(code), .error = ::testing::internal::GetCapturedStderr()};
}

TEST(CommandLine, EndsWithTheCodeOfTheOutcome) {
  EXPECT_EQ(ending_of("well"), (Ending{.code = 0}));
  EXPECT_EQ(ending_of("infeasible"), (Ending{.code = 3}));
  EXPECT_EQ(ending_of("interrupted"), (Ending{.code = 130}));
}

TEST(CommandLine, EndsWithTwoWhenInputOrOutputFolderIsWrong) {
  EXPECT_EQ(ending_of("input"), (Ending{.code = 2, .error = "coilwright: x.json: /a: is missing\n"}));
  EXPECT_EQ(ending_of("folder"),
            (Ending{.code = 2, .error = "coilwright: out: cannot be written: Permission denied\n"}));
}

TEST(CommandLine, EndsWithOneAndOneLineOnAnythingElse) {
  EXPECT_EQ(ending_of("disk"),
            (Ending{.code = 1, .error = "coilwright: out: cannot be written: No space left on device\n"}));
  EXPECT_EQ(ending_of("memory"),
            (Ending{.code = 1, .error = "coilwright: out of memory: --threads 1 takes the least\n"}));
  EXPECT_EQ(ending_of("other"), (Ending{.code = 1, .error = "coilwright: two\\nlines\n"}));
}

// A function that a library in C calls may throw nothing.
TEST(CommandLine, EndsWithOneLineWhereMemoryFailsInsideOfALibraryInC) {
  constexpr std::array commands{Command{"evaluate", add_endings}};
  const std::array arguments = {"coilwright", "memory_in_c"};
  EXPECT_EXIT((void)run(arguments, commands), ::testing::ExitedWithCode(1), "^coilwright: out of memory: .*\n$");
}

}  // namespace
}  // namespace coilwright::cli
