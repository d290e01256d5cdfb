#include "cli/signals.hpp"

#include <gtest/gtest.h>

namespace coilwright::cli {
namespace {

TEST(StopSignal, RaisesAFlagAtTheFirstSignal) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const StopSignal stop;
    EXPECT_FALSE(stop.requested());
    std::raise(signal);
    EXPECT_TRUE(stop.requested());
  }
}

TEST(StopSignalDeathTest, EndsTheProgramAtTheSecondAfterAnInterrupt) {
  const auto signalled = [](int first, int second) {
    const StopSignal stop;
    std::raise(first);
    std::raise(second);
  };
  EXPECT_EXIT(signalled(SIGINT, SIGINT), ::testing::KilledBySignal(SIGINT), "");
  EXPECT_EXIT(signalled(SIGINT, SIGTERM), ::testing::KilledBySignal(SIGTERM), "");
}

// A closing terminal may send two, one of them by its shell, and `timeout` does.
TEST(StopSignal, TakesAnyNumberOfHangUpsAndTerminations) {
  for (const int signal : {SIGHUP, SIGTERM}) {
    const StopSignal stop;
    std::raise(signal);
    std::raise(signal);
    EXPECT_TRUE(stop.requested());
  }
}

TEST(StopSignal, LeavesAHangUpIgnoredAsNohupAsks) {
  const auto before = std::signal(SIGHUP, SIG_IGN);
  {
    const StopSignal stop;
    std::raise(SIGHUP);
    EXPECT_FALSE(stop.requested());
  }
  EXPECT_EQ(std::signal(SIGHUP, before), SIG_IGN);
}

TEST(StopSignalDeathTest, LeavesSignalsAsTheyWereBefore) {
  const auto signalled = [] {
    { const StopSignal stop; }
    std::raise(SIGTERM);
  };
  EXPECT_EXIT(signalled(), ::testing::KilledBySignal(SIGTERM), "");
}

}  // namespace
}  // namespace coilwright::cli
