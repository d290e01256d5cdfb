#include "cli/progress_line.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

namespace coilwright::cli {
namespace {

using namespace std::chrono_literals;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST(Pace, IsThatOfTheLastHalfMinute) {
  Pace pace;
  const Pace::Time begin{};
  EXPECT_EQ(pace.rate(), std::nullopt);
  pace.learn(begin, 0);
  EXPECT_EQ(pace.rate(), std::nullopt);
  EXPECT_EQ(pace.left(100), std::nullopt);
  pace.learn(begin + 1s, 5000);  // from an archive, at once
  EXPECT_DOUBLE_EQ(pace.rate().value(), 5000.0);
  for (std::size_t second = 2; second <= 60; ++second)
    pace.learn(begin + std::chrono::seconds(second), 5000 + 10 * (second - 1));
  EXPECT_DOUBLE_EQ(pace.rate().value(), 10.0);
  EXPECT_DOUBLE_EQ(pace.left(6000).value(), (6000.0 - 5590.0) / 10.0);
  EXPECT_DOUBLE_EQ(pace.left(5000).value(), 0.0);
}

TEST(Pace, SaysNothingWhileNothingIsDone) {
  Pace pace;
  pace.learn(Pace::Time{}, 7);
  pace.learn(Pace::Time{} + 5s, 7);
  EXPECT_EQ(pace.left(9), std::nullopt);
}

TEST(DurationText, IsOneOfAPerson) {
  EXPECT_EQ(duration_text(0.2), "0 s");
  EXPECT_EQ(duration_text(59.4), "59 s");
  EXPECT_EQ(duration_text(130.0), "2 min 10 s");
  EXPECT_EQ(duration_text(3.0 * 3600.0 + 301.0), "3 h 5 min");
}

std::string said(ProgressLine::Place place, std::chrono::milliseconds interval, std::chrono::milliseconds work) {
  std::ostringstream out;
  {
    int calls = 0;
    const ProgressLine line(out, place, interval, [&calls] { return calls++ == 0 ? "long words" : "words"; });
    std::this_thread::sleep_for(work);
  }
  return out.str();
}

TEST(ProgressLine, IsWrittenOverAndGoneAtTheEndOnATerminal) {
  const std::string text = said(ProgressLine::Place::terminal, 5ms, 200ms);
  EXPECT_THAT(text, StartsWith("\rlong words\rwords     \r"));
  EXPECT_THAT(text, EndsWith("\r          \r"));
}

TEST(ProgressLine, IsLineAfterLineInALogAndNotAtTheBegin) {
  EXPECT_EQ(said(ProgressLine::Place::log, 10min, 50ms), "");
  EXPECT_THAT(said(ProgressLine::Place::log, 5ms, 200ms), StartsWith("long words\nwords\n"));
}

TEST(ProgressLine, SaysNothingWhereItIsNotWanted) {
  EXPECT_EQ(said(ProgressLine::Place::nowhere, 1ms, 50ms), "");
}

TEST(ProgressInterval, IsHalfAMinuteInALog) {
  EXPECT_EQ(progress_interval(ProgressLine::Place::log), 30s);
  EXPECT_EQ(progress_place(true), ProgressLine::Place::nowhere);
}

}  // namespace
}  // namespace coilwright::cli
