#include "coilwright/text/json/rows.hpp"

#include <gtest/gtest.h>

#include <array>

#include "coilwright/text/json/document.hpp"
#include "text/input_error_text.hpp"

namespace coilwright::text {
namespace {

enum class TableShape { round, square };
constexpr std::array<std::string_view, 2> table_shapes{"round", "square"};
struct Plate {
  double width = 0.02;  // m
  std::optional<double> warmth{};
};
struct Table {
  Plate plate{};
  int legs = 4;
  TableShape shape = TableShape::round;
  double mass{};  // kg
};
constexpr std::array table_rows = {
    row<&Table::plate, &Plate::width>("width_mm", positive, "Of the plate"),
    row<&Table::plate, &Plate::warmth>("warmth_degC", Rule::between(-50, 200), "Of the plate"),
    row<&Table::legs>("legs", Rule::between(3, 8), "How many"),
    choice_row<&Table::shape>("shape", table_shapes, "Of the plate"),
    row<&Table::mass>("mass_g", positive, "Of all", Need::required),
};

Table read_table(const std::string& text) {
  return read_object(parse_json(text, "t").root(), [](ObjectReader& in) { return read_rows(in, table_rows, Table{}); });
}

TEST(Rows, ReadWhatIsWrittenByThem) {
  const Table table{.plate = {.width = 0.0099, .warmth = 21.0}, .legs = 3, .shape = TableShape::square, .mass = 2.5};
  const Table again = read_table(rows_json(table, table_rows).text());
  EXPECT_EQ(again.plate.width, 0.0099);
  EXPECT_EQ(again.plate.warmth, 21.0);
  EXPECT_EQ(again.legs, 3);
  EXPECT_EQ(again.shape, TableShape::square);
  EXPECT_EQ(again.mass, 2.5);
}

TEST(Rows, LeaveWhatAFileDoesNotSay) {
  const Table table = read_table(R"({"mass_g": 1})");
  EXPECT_EQ(table.plate.width, 0.02);
  EXPECT_FALSE(table.plate.warmth);
  EXPECT_EQ(table.legs, 4);
}

TEST(Rows, TellWhatBreaksThemByItsPlace) {
  const auto error = [](const std::string& text) { return testing::error_of([&] { (void)read_table(text); }); };
  EXPECT_EQ(error("{}"), "t: /mass_g: is missing");
  EXPECT_EQ(error(R"({"mass_g": 0})"), "t: /mass_g: must be > 0; got 0");
  EXPECT_EQ(error(R"({"mass_g": 1, "legs": 3.5})"), "t: /legs: must be a whole number; got 3.5");
  EXPECT_EQ(error(R"({"mass_g": 1, "shape": "oval"})"),
            R"(t: /shape: must be one of "round", "square"; got text "oval")");
}

TEST(Rows, AreTheirSchema) {
  const Json schema = schema_of(std::span(table_rows));
  const Document document = parse_json(schema.text(), "s");
  const Node properties = *document.root().find("properties");
  EXPECT_EQ(properties.find("width_mm")->find("default")->number(), 20.0);
  EXPECT_EQ(properties.find("width_mm")->find("exclusiveMinimum")->number(), 0.0);
  EXPECT_EQ(properties.find("legs")->find("type")->text(), "integer");
  EXPECT_EQ(properties.find("legs")->find("maximum")->number(), 8.0);
  EXPECT_EQ(properties.find("shape")->find("default")->text(), "round");
  EXPECT_FALSE(properties.find("warmth_degC")->find("default"));
  EXPECT_FALSE(properties.find("mass_g")->find("default"));
  EXPECT_EQ(document.root().find("required")->elements().front().text(), "mass_g");
}

}  // namespace
}  // namespace coilwright::text
