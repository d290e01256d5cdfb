// One evaluation as a person and as a program read it, with a quantity of a user's own. This test links what an
// evaluation needs and nothing else; `evaluation_links_no_search` looks at its libraries.
#include "coilwright/report/simulation/performance_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "coilwright/formats/actuator/actuator_file.hpp"
#include "coilwright/formats/simulation/performance_json.hpp"
#include "coilwright/report/simulation/percent.hpp"
#include "coilwright/text/json/document.hpp"

namespace coilwright::report {
namespace {

using simulation::QuantityTable;

QuantityTable table_with_aspect_ratio() {
  return simulation::standard_quantities().with({.name = "aspect_ratio",
                                                 .meaning = "width divided by height of the cross-section",
                                                 .scale = 1.0,
                                                 .value = [](const simulation::DesignView& d) {
                                                   return d.assembly.dimensions.width / d.assembly.dimensions.height;
                                                 }});
}

TEST(Percent, IsNoPowerOfTenAndHasNoSignWhereNothingIsLeft) {
  EXPECT_EQ(percent(0.00123), "0.123 %");
  EXPECT_EQ(percent(0.1234), "12.3 %");
  EXPECT_EQ(percent(11.5432), "1154 %");
  EXPECT_EQ(percent(9.996), "1000 %");
  EXPECT_EQ(percent(0.0612, 2), "6.1 %");
  EXPECT_EQ(percent(1.55, 2), "155 %");
  EXPECT_EQ(percent_change(0.0391), "+3.9 %");
  EXPECT_EQ(percent_change(-0.12), "-12.0 %");
  EXPECT_EQ(percent_change(4e-4), "0.0 %");
  EXPECT_EQ(percent_change(-4e-4), "0.0 %");
}

struct Row {
  std::string name;
  std::optional<double> value;
  std::string meaning;
};

// A text has these rows in this order, each value to the six digits that it prints, and then what is listed by joints.
void expect_rows(const std::string& text, const std::vector<Row>& expected) {
  std::istringstream lines(text);
  std::string title;
  std::getline(lines, title);
  EXPECT_EQ(title, "All quantities");
  for (const Row& row : expected) {
    std::string line, name, value, meaning;
    ASSERT_TRUE(std::getline(lines, line)) << row.name;
    std::istringstream cells(line);
    cells >> name >> value >> std::ws;
    std::getline(cells, meaning);
    EXPECT_EQ(name, row.name);
    EXPECT_EQ(meaning, row.meaning);
    if (row.value)
      EXPECT_NEAR(std::stod(value), *row.value, 5e-6 * std::abs(*row.value) + 1e-12) << name;
    else
      EXPECT_EQ(value, "none") << name;
  }
  for (const char* name : {"joint_angles_deg", "rest_joint_angles_deg", "grasp_joint_angles_deg", "modes"}) {
    std::string first;
    lines >> first;
    EXPECT_EQ(first, name);
    lines.ignore(1000, '\n');
  }
  lines >> std::ws;
  EXPECT_TRUE(lines.eof());
}

std::vector<Row> rows_of(const simulation::DesignView& view, const QuantityTable& table) {
  std::vector<Row> rows;
  for (const simulation::ResultQuantity& quantity : table)
    rows.push_back({.name = quantity.name, .value = quantity.value(view), .meaning = quantity.meaning});
  return rows;
}

TEST(PerformanceText, ListsAQuantityOfAUsersOwn) {
  const formats::ActuatorFile file =
      formats::parse_actuator(R"({"format": "actuator/1", "configuration": "B"})", "finger.json");
  const auto& design = std::get<actuator::Design>(file.content);
  const actuator::Assembly assembly = actuator::assemble_or_throw(design);
  const simulation::OperatingPoint point{.current = 1.4};
  const auto performance = std::get<simulation::Performance>(simulation::performance_of(design, assembly, point));
  const simulation::DesignView view{.design = design, .assembly = assembly, .point = point, .performance = performance};
  const QuantityTable table = table_with_aspect_ratio();
  expect_rows(to_text(quantities_section(view, table)), rows_of(view, table));
  expect_rows(to_text(quantities_section(view)),
              rows_of(view, simulation::standard_quantities()));  // which has no aspect ratio
  const auto json = text::parse_json(formats::to_json(view, table).text(), "figures.json");
  EXPECT_DOUBLE_EQ(json.root().find("aspect_ratio")->number(), assembly.dimensions.width / assembly.dimensions.height);
}

// Numbers end in one column, however long a name is: also the longest that there is.
TEST(PerformanceText, AlignsItsColumnsUnderTheLongestName) {
  const actuator::Design design;
  const actuator::Assembly assembly = actuator::assemble_or_throw(design);
  const simulation::OperatingPoint point{.current = 1.0};
  const auto performance = std::get<simulation::Performance>(simulation::performance_of(design, assembly, point));
  const simulation::DesignView view{.design = design, .assembly = assembly, .point = point, .performance = performance};
  const std::string name(50, 'n');
  const QuantityTable table = simulation::standard_quantities().with(
      {.name = name, .meaning = "of a long name", .scale = 1.0, .value = [](const simulation::DesignView&) {
         return 1.0;
       }});
  for (const auto& [quantities, width] :
       {std::pair(&simulation::standard_quantities(), std::size_t{34}), std::pair(&table, name.size())}) {
    std::istringstream lines(to_text(quantities_section(view, *quantities)));
    std::string line;
    std::getline(lines, line);
    std::optional<std::size_t> column;
    for (const simulation::ResultQuantity& quantity : *quantities) {
      std::getline(lines, line);
      ASSERT_EQ(line.substr(2, quantity.name.size()), quantity.name);
      const std::size_t at = line.find(quantity.meaning, 2 + width);
      EXPECT_EQ(at, column.value_or(at)) << line;
      column = at;
    }
    std::getline(lines, line);
    EXPECT_TRUE(line.starts_with("  joint_angles_deg")) << line;
  }
}

TEST(PerformanceText, OfALumpedModelHasWhatNeedsNoDesign) {
  const actuator::Assembly assembly = actuator::assemble_or_throw(actuator::Design{});
  const auto motion = std::get<simulation::MotionSummary>(simulation::motion_of(assembly.model, 1.1));
  std::vector<Row> rows;
  for (const simulation::ResultQuantity& quantity : simulation::standard_quantities())
    if (quantity.value_of_lumped)
      rows.push_back(
          {.name = quantity.name, .value = quantity.value_of_lumped(motion, 1.1), .meaning = quantity.meaning});
  EXPECT_THAT(rows, ::testing::Contains(::testing::Field(&Row::name, "current_A")));
  EXPECT_THAT(rows, ::testing::Not(::testing::Contains(::testing::Field(&Row::name, "mass_g"))));
  expect_rows(to_text(quantities_section(motion, 1.1, table_with_aspect_ratio())), rows);
}

}  // namespace
}  // namespace coilwright::report
