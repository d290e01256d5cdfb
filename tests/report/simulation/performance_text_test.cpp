// One evaluation as a person and as a program read it, with a quantity of a user's own. This test links what an
// evaluation needs and nothing else; `evaluation_links_no_search` looks at its libraries.
#include "coilwright/report/simulation/performance_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <utility>
#include <variant>

#include "coilwright/formats/actuator/actuator_file.hpp"
#include "coilwright/formats/simulation/performance_json.hpp"

namespace coilwright::report {
namespace {

using simulation::QuantityTable;
using ::testing::HasSubstr;
using ::testing::Not;

QuantityTable table_with_aspect_ratio() {
  return simulation::standard_quantities().with({.name = "aspect_ratio",
                                                 .meaning = "width divided by height of the cross-section",
                                                 .scale = 1.0,
                                                 .value = [](const simulation::DesignView& d) {
                                                   return d.assembly.dimensions.width / d.assembly.dimensions.height;
                                                 }});
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
  const std::string value = to_text(view, table);
  EXPECT_THAT(value, HasSubstr("width divided by height of the cross-section\n"));
  EXPECT_THAT(value, HasSubstr("mass_g "));
  EXPECT_THAT(formats::to_json(view, table).text(), HasSubstr("\"aspect_ratio\": 0."));
  EXPECT_THAT(to_text(view), Not(HasSubstr("aspect_ratio")));
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
    std::istringstream lines(to_text(view, *quantities));
    for (const simulation::ResultQuantity& quantity : *quantities) {
      std::string line;
      std::getline(lines, line);
      ASSERT_EQ(line.substr(0, quantity.name.size()), quantity.name);
      EXPECT_EQ(line.find(quantity.meaning), width + 15) << line;
    }
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(line.substr(0, width), "joint_angles_deg" + std::string(width - 16, ' '));
  }
}

TEST(PerformanceText, OfALumpedModelHasWhatNeedsNoDesign) {
  const actuator::Assembly assembly = actuator::assemble_or_throw(actuator::Design{});
  const auto motion = std::get<simulation::MotionSummary>(simulation::motion_of(assembly.model, 1.1));
  const std::string text = to_text(motion, 1.1, table_with_aspect_ratio());
  EXPECT_THAT(text, HasSubstr("current_A"));
  EXPECT_THAT(text, HasSubstr("grasp_joint_angles_deg"));
  EXPECT_THAT(text, Not(HasSubstr("mass_g")));
  EXPECT_THAT(text, Not(HasSubstr("aspect_ratio")));
}

}  // namespace
}  // namespace coilwright::report
