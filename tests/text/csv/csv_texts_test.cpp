#include "coilwright/text/csv/csv_texts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
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

// What an InputError says, without the folder.
std::string refusal_by(const std::function<void()>& task) {
  try {
    task();
  } catch (const InputError& error) {
    const std::string text = error.what();
    return text.substr(std::min(text.find("t.csv"), text.size()));
  }
  return {};
}

TEST(CsvTexts, KeepsTextsAndNumbersAsTheyStand) {
  const CsvTexts table = read("gap_mm,status,reason\n1.50,ok,\n,failed,\"a, b \"\"c\"\"\"\n", all);
  EXPECT_EQ(table.rows(), 2U);
  EXPECT_EQ(table.column("gap_mm"), (std::vector<std::string>{"1.50", ""}));
  EXPECT_EQ(table.column("reason")[1], "a, b \"c\"");
  EXPECT_EQ(table.number("gap_mm", 0), 1.5);
  EXPECT_FALSE(table.number("gap_mm", 1).has_value());
  EXPECT_EQ(refusal_by([&] { static_cast<void>(table.number("status", 0)); }),
            "t.csv: line 2: column status: must be a number; got \"ok\"");
  EXPECT_EQ(refusal_by([&] { static_cast<void>(table.required_number("gap_mm", 1)); }),
            "t.csv: line 3: column gap_mm: must be a number; got \"\"");
}

TEST(CsvTexts, KeepsTheColumnsThatAreAskedFor) {
  const CsvTexts table = read("a,b,c\n1,2,3\n", [](std::string_view name) { return name == "c"; });
  EXPECT_EQ(table.names(), (std::vector<std::string>{"c"}));
  EXPECT_FALSE(table.has("a"));
  EXPECT_EQ(refusal_by([&] { static_cast<void>(table.column("a")); }), "t.csv: must have the column a");
}

TEST(CsvTexts, MayHaveNoRowButMustHaveAHeader) {
  EXPECT_EQ(read("a,b\n", all).rows(), 0U);
  EXPECT_THROW(read("", all), InputError);
}

TEST(CsvTexts, WasCutWhereItDoesNotEndWithALine) {
  EXPECT_EQ(refusal_by([] { static_cast<void>(read("a,b\n1,2", all)); }),
            "t.csv: must end with a whole line: it was cut");
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
      [&](std::span<const std::string_view> fields, std::size_t line) {
        seen.push_back(std::to_string(line));
        for (const std::string_view field : fields) seen.emplace_back(field);
      });
  EXPECT_EQ(names, (std::vector<std::string>{"name", "value"}));
  EXPECT_EQ(seen, (std::vector<std::string>{"2", "this", "1", "3", "that", "2"}));
}

TEST(NumberIn, TakesAFieldAsAWhole) {
  EXPECT_EQ(number_in("-1.5e-3"), -1.5e-3);
  for (const char* none : {"", "1.5 ", "x", "1,5", "nan", "inf", "1e999"}) EXPECT_FALSE(number_in(none)) << none;
}

}  // namespace
}  // namespace coilwright::text
