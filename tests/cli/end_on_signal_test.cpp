#include "cli/signals.hpp"

#include <gtest/gtest.h>

#include "cli/commands.hpp"

namespace coilwright::cli {
namespace {

TEST(EndOnSignalDeathTest, SaysThatNothingIsWrittenAndEndsTheProgram) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const auto signalled = [signal] {
      const EndOnSignal nothing_to_save;
      std::raise(signal);
    };
    EXPECT_EXIT(signalled(), ::testing::ExitedWithCode(static_cast<int>(ExitCode::interrupted)),
                "^coilwright: interrupted: nothing is written\n$");
  }
}

TEST(EndOnSignalDeathTest, LeavesSignalsAsTheyWereBefore) {
  const auto signalled = [] {
    { const EndOnSignal nothing_to_save; }
    std::raise(SIGINT);
  };
  EXPECT_EXIT(signalled(), ::testing::KilledBySignal(SIGINT), "^$");
}

}  // namespace
}  // namespace coilwright::cli
