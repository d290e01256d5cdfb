#include "coilwright/text/csv/csv_writer.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "coilwright/text/csv/csv_texts.hpp"
#include "temporary_folder.hpp"

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

// Text that a spreadsheet takes for a formula, and does: told by its first letter, behind apostrophes too.
TEST(CsvWriter, WritesNoFormulaAndItsTextsAreReadAsTheyWere) {
  std::vector<std::string> texts{"plain", "a=1", "'", "''", "'plain", "5 mm", "\"", ""};
  for (const char first : {'=', '+', '-', '@', '\t', '\r', '\n'})
    for (const char* before : {"", "'", "'''"})
      for (const char* rest : {"", "1+1", "cmd|' /C calc'!A0", "x,\"y\"", " "})
        texts.push_back(fmt::format("{}{}{}", before, first, rest));
  const coilwright::testing::TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "table.csv";
  {
    std::ofstream out(path, std::ios::binary);
    CsvWriter writer(out, {"+column", "number"});
    for (const std::string& text : texts) writer.row({text, -1.5});
  }
  std::ifstream in(path, std::ios::binary);
  const std::string written{std::istreambuf_iterator<char>(in), {}};
  EXPECT_THAT(written, ::testing::StartsWith("'+column,number\n"));
  EXPECT_THAT(written, HasSubstr("\n'=1+1,-1.5\n"));
  EXPECT_THAT(written, HasSubstr("\n'plain,-1.5\n"));
  EXPECT_THAT(written, ::testing::Not(HasSubstr("\n=")));
  const CsvTexts read = read_csv_texts(path, [](std::string_view) { return true; });
  EXPECT_EQ(read.column("+column"), texts);
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
