#include "coilwright/text/csv/csv_texts.hpp"

#include <gtest/gtest.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/text/input_error.hpp"
#include "temporary_folder.hpp"

namespace coilwright::text {
namespace {

CsvTexts read(std::string_view content, const std::function<bool(std::string_view)>& keep) {
  const coilwright::testing::TemporaryFolder folder;
  return read_csv_texts(folder.file("t.csv", content), keep);
}

bool all(std::string_view) {
  return true;
}

TEST(CsvTexts, KeepsTextsAndNumbersAsTheyStand) {
  const CsvTexts table = read("gap_mm,status,reason\n1.50,ok,\n,failed,\"a, b \"\"c\"\"\"\n", all);
  EXPECT_EQ(table.rows(), 2U);
  EXPECT_EQ(table.column("gap_mm"), (std::vector<std::string>{"1.50", ""}));
  EXPECT_EQ(table.column("reason")[1], "a, b \"c\"");
  EXPECT_EQ(table.number("gap_mm", 0), 1.5);
  EXPECT_FALSE(table.number("gap_mm", 1).has_value());
  EXPECT_FALSE(table.number("status", 0).has_value());
}

TEST(CsvTexts, KeepsTheColumnsThatAreAskedFor) {
  const CsvTexts table = read("a,b,c\n1,2,3\n", [](std::string_view name) { return name == "c"; });
  EXPECT_EQ(table.names(), (std::vector<std::string>{"c"}));
  EXPECT_FALSE(table.has("a"));
  EXPECT_THROW(static_cast<void>(table.column("a")), std::out_of_range);
}

TEST(CsvTexts, MayHaveNoRowButMustHaveAHeader) {
  EXPECT_EQ(read("a,b\n", all).rows(), 0U);
  EXPECT_THROW(read("", all), InputError);
}

TEST(CsvTexts, NamesTheLineOfARowOfAnotherWidth) {
  try {
    static_cast<void>(read("a,b\n1,2\n3\n", all));
    FAIL() << "was read";
  } catch (const InputError& error) {
    EXPECT_EQ(error.fault().place, "line 3");
    EXPECT_EQ(error.fault().value, "1");
  }
}

TEST(CsvTexts, GivesTheSameRowsOneByOne) {
  const coilwright::testing::TemporaryFolder folder;
  std::vector<std::string> seen;
  const std::vector<std::string> names = for_each_csv_row(
      folder.file("t.csv", "name,note,value\nthis,one,1\nthat,two,2\n"),
      [](std::string_view name) { return name != "note"; },
      [&](std::span<const std::string_view> fields) {
        for (const std::string_view field : fields) seen.emplace_back(field);
      });
  EXPECT_EQ(names, (std::vector<std::string>{"name", "value"}));
  EXPECT_EQ(seen, (std::vector<std::string>{"this", "1", "that", "2"}));
}

TEST(NumberIn, TakesAFieldAsAWhole) {
  EXPECT_EQ(number_in("-1.5e-3"), -1.5e-3);
  for (const char* none : {"", "1.5 ", "x", "1,5", "nan", "inf", "1e999"}) EXPECT_FALSE(number_in(none)) << none;
}

}  // namespace
}  // namespace coilwright::text
