#include "coilwright/text/csv/csv_writer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <locale>
#include <sstream>
#include <stdexcept>

namespace coilwright::text {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(CsvWriter, WritesAHeaderAndRowsOfNumbersAndTexts) {
  std::ostringstream out;
  CsvWriter writer(out, {"configuration", "turns", "speed_deg_s", "note"});
  writer.row({"B", 14, 312.25, CsvCell()});
  EXPECT_EQ(out.str(), "configuration,turns,speed_deg_s,note\nB,14,312.25,\n");
}

TEST(CsvWriter, WritesTheFewestDigitsThatReadBackAsTheSameDouble) {
  std::ostringstream out;
  CsvWriter writer(out, {"a", "b", "c", "d", "e"});
  writer.row({0.1, 1.0 / 3.0, 5e-324, 1.7976931348623157e308, -0.0});
  EXPECT_EQ(out.str(), "a,b,c,d,e\n0.1,0.3333333333333333,5e-324,1.7976931348623157e+308,-0\n");
}

TEST(CsvWriter, QuotesOnlyWhatWouldBeMisread) {
  std::ostringstream out;
  CsvWriter writer(out, {"a", "b", "c", "d"});
  writer.row({"plain text", "x,y", "say \"no\"", " padded"});
  writer.row({"two\nlines", "", "\"", "λ"});
  EXPECT_EQ(out.str(), "a,b,c,d\nplain text,\"x,y\",\"say \"\"no\"\"\",\" padded\"\n\"two\nlines\",,\"\"\"\",λ\n");
}

TEST(CsvWriter, IgnoresTheLocale) {
  struct CommaDecimals : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new CommaDecimals));
  std::ostringstream out;
  CsvWriter(out, {"a", "b"}).row({1234567.5, 1234567});
  std::locale::global(before);
  EXPECT_EQ(out.str(), "a,b\n1234567.5,1234567\n");
}

TEST(CsvWriter, RefusesARowOfTheWrongWidth) {
  std::ostringstream out;
  CsvWriter writer(out, {"a", "b"});
  EXPECT_THAT([&] { writer.row({1.5}); },
              ThrowsMessage<std::invalid_argument>("a row must have 2 cells, one a column; got 1"));
  EXPECT_EQ(out.str(), "a,b\n");
}

TEST(CsvWriter, RefusesNumbersThatAreNotFiniteAndWritesNothingOfTheirRow) {
  std::ostringstream out;
  CsvWriter writer(out, {"a", "speed_deg_s"});
  EXPECT_THAT(
      [&] {
        writer.row({1.5, std::numeric_limits<double>::quiet_NaN()});
      },
      ThrowsMessage<std::invalid_argument>("column speed_deg_s must be finite; got nan"));
  EXPECT_EQ(out.str(), "a,speed_deg_s\n");
}

TEST(CsvWriter, RefusesAHeaderThatNobodyCouldRead) {
  std::ostringstream out;
  EXPECT_THAT([&] { CsvWriter(out, {}); }, ThrowsMessage<std::invalid_argument>("columns must not be empty"));
  EXPECT_THAT([&] { CsvWriter(out, {"a", ""}); }, ThrowsMessage<std::invalid_argument>("a column must have a name"));
  EXPECT_THAT(
      [&] {
        CsvWriter(out, {"a", "b", "a"});
      },
      ThrowsMessage<std::invalid_argument>("column a must not be there twice"));
}

}  // namespace
}  // namespace coilwright::text
