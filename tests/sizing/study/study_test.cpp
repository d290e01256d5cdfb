#include "coilwright/sizing/study/study.hpp"

#include <gtest/gtest.h>

#include "error_text.hpp"
#include "sizing/small_study.hpp"

namespace coilwright::sizing {
namespace {

ParameterVariable gap(double lower, double upper, double step) {
  return parameter_variable("gap_mm", Interval{.lower = lower, .upper = upper, .step = step});
}

TEST(StudyVariable, IsMadeFromTheNameOfAParameter) {
  EXPECT_EQ(gap(0.7, 1.3, 0.2).parameter, actuator::find_parameter("gap_mm"));
  EXPECT_EQ(error_text([] { (void)parameter_variable("gap_m", Choice{.values = {0.7}}); }),
            "no parameter of a design is called \"gap_m\"");
}

TEST(StudyVariable, CountsItsValues) {
  EXPECT_EQ(value_count(gap(0.7, 1.3, 0.2)), 4u);  // 1.3 is there, although 0.6 / 0.2 is below 3
  EXPECT_EQ(value_count(gap(0.7, 1.2, 0.2)), 3u);  // the grid ends at 1.1
  EXPECT_EQ(value_count(gap(0.7, 0.7, 0.0)), 1u);
  EXPECT_EQ(value_count(gap(0.7, 1.3, 0.0)), std::nullopt);
  EXPECT_EQ(value_count(CurrentVariable{.range = Choice{.values = {0.2, 0.9}}}), 2u);
  const auto study = testing::small_study();
  EXPECT_EQ(value_count(study.variables[2]), 2u);  // whole numbers need no step
}

TEST(StudyVariable, GivesTheDecimalsOfItsGrid) {
  const ParameterVariable variable = gap(0.7, 1.3, 0.2);
  EXPECT_EQ(std::get<double>(value_at(variable, 0.7 + 0.2)), 0.9);
  EXPECT_EQ(std::get<double>(value_at(variable, 0.7 + 3 * 0.2)), 1.3);
  // Without a grid there is no decimal to mean.
  EXPECT_EQ(std::get<double>(value_at(gap(0.7, 1.3, 0.0), 0.7 + 0.2)), 0.7 + 0.2);
}

TEST(StudyVariable, GivesValuesOfListsByTheirIndex) {
  const auto study = testing::small_study();
  EXPECT_EQ(std::get<std::string_view>(value_at(study.variables[0], 1.0)), "A");
  EXPECT_EQ(std::get<double>(value_at(study.variables[3], 2.0)), 30.0);
  EXPECT_EQ(search_variable(study.variables[3]).upper, 2.0);
  EXPECT_EQ(search_variable(study.variables[0]).kind, VariableKind::categorical);
}

// Every figure of a motion or a grasp under current has its pose, and what is known without one has none.
TEST(Study, IsHeldInThePosesThatItsQuantitiesAreOf) {
  using actuator::HeldCases;
  const auto poses = [](const char* objective, const char* limit) {
    Study study;
    study.objectives.push_back({.quantity = testing::quantity(objective)});
    study.limits.push_back({.quantity = testing::quantity(limit), .value = 1.0});
    return poses_of_use(study);
  };
  for (const char* free : {"steady_angle_deg", "stroke_deg", "peak_joint_angle_deg", "damping_ratio",
                           "peak_bending_speed_cold_deg_s", "thermal_load_free"}) {
    EXPECT_EQ(poses(free, "thermal_load"), HeldCases::free) << free;
    EXPECT_EQ(poses(free, "grasp_force_cold_N"), HeldCases::both) << free;
  }
  for (const char* gripping : {"grasp_force_N", "grasp_force_cold_N", "thermal_load_gripping"})
    EXPECT_EQ(poses("mass_g", gripping), HeldCases::gripping) << gripping;
  for (const char* neither : {"demagnetisation_margin", "rest_angle_deg", "contact_force_no_current_N", "power_W"})
    EXPECT_EQ(poses("mass_g", neither), HeldCases::both) << neither;
}

TEST(Limit, MeasuresHowFarInsideAValueIs) {
  const Limit most{.quantity = testing::quantity("mass_g"), .side = Limit::Side::at_most, .value = 70.0};
  const Limit least{.quantity = testing::quantity("rest_angle_deg"), .side = Limit::Side::at_least, .value = 0.0};
  EXPECT_EQ(margin(most, 64.5), 5.5);
  EXPECT_EQ(margin(most, 71.5), -1.5);
  EXPECT_EQ(margin(least, -2.5), -2.5);
  EXPECT_EQ(scale_of(most), 70.0);
  EXPECT_EQ(scale_of(least), testing::quantity("rest_angle_deg").scale);
  EXPECT_EQ(name_of(least), "rest_angle_deg >= 0");
}

}  // namespace
}  // namespace coilwright::sizing
