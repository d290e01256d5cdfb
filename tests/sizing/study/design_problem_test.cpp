#include "coilwright/sizing/study/design_problem.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <stdexcept>

#include "coilwright/sizing/study/expression.hpp"
#include "sizing/expect_error.hpp"
#include "sizing/small_study.hpp"

namespace coilwright::sizing {
namespace {

using testing::expect_error;
using testing::small_study;

TEST(DesignProblem, SetsEveryVariableOnACopyOfItsBase) {
  Study study = small_study();
  study.base.body.bottom_layer = 2.9e-3;
  const DesignProblem problem(study);
  const actuator::Design design = problem.design_at(std::vector{1.0, 0.7 + 0.2, 14.0, 2.0});
  EXPECT_EQ(design.layout.size(), 2u);
  EXPECT_EQ(design.body.gap, 0.9e-3);
  EXPECT_EQ(design.coil.turns_radial, 14);
  EXPECT_EQ(design.coil.wire_gauge, 30);
  EXPECT_EQ(design.body.bottom_layer, 2.9e-3);
}

TEST(DesignProblem, TakesTheCurrentFromTheGaugeOfThePoint) {
  const DesignProblem problem(small_study());
  const auto thin = std::get<EvaluatedDesign>(problem.evaluate(std::vector{0.0, 0.9, 13.0, 2.0}));
  const auto thick = std::get<EvaluatedDesign>(problem.evaluate(std::vector{0.0, 0.9, 13.0, 0.0}));
  // 1.4 A at AWG 28, by the law (d / d_28)^2.06 for AWG 30 and 27; each gauge is 92^(1/39) thinner than the last.
  EXPECT_NEAR(thin.point.current, 0.9 * 1.4 * std::pow(92.0, -2.0 / 39.0 * 2.06), 2e-4);
  EXPECT_NEAR(thick.point.current, 0.9 * 1.4 * std::pow(92.0, 1.0 / 39.0 * 2.06), 2e-4);
  EXPECT_EQ(thin.point.duty, 0.4);
}

TEST(DesignProblem, TellsTheSearchObjectivesAndScaledMargins) {
  const DesignProblem problem(small_study());
  const std::vector point{0.0, 0.9, 13.0, 1.0};
  const auto design = std::get<EvaluatedDesign>(problem.evaluate(point));
  const Evaluation seen = problem.problem().evaluate(point);
  EXPECT_EQ(seen.failure, "");
  ASSERT_EQ(seen.objectives.size(), 2u);
  EXPECT_EQ(seen.objectives[1], design.performance.mass * 1e3);
  // A difference of numbers near 1, each rounded: 4 eps of 1.
  EXPECT_NEAR(seen.constraints[0], design.performance.mass * 1e3 / 66.0 - 1.0, 9e-16);
  EXPECT_NO_THROW(validate_problem(problem.problem()));
}

// small_study: configuration (B, A), gap 0.7 to 1.2 step 0.2, layers 13 to 14, gauge of the list 27, 28, 30.
TEST(DesignProblem, StartsFromTheStudysOwnActuator) {
  Study study = small_study();
  study.base.layout = actuator::layout_of(actuator::Configuration::A);
  study.base.coil.wire_gauge = 29;
  actuator::find_parameter("gap_mm")->set(study.base, 0.00097);
  actuator::find_parameter("turns_radial")->set(study.base, 20);
  const Problem problem = DesignProblem(study).problem();
  ASSERT_EQ(problem.starts.size(), 1u);
  ASSERT_EQ(problem.starts[0].size(), 4u);
  EXPECT_EQ(problem.starts[0][0], 1.0);
  EXPECT_NEAR(problem.starts[0][1], 0.97, 1e-15);
  EXPECT_EQ(problem.starts[0][2], 20.0);  // the search clamps it
  EXPECT_EQ(problem.starts[0][3], 1.0);   // 28 and 30 are as near: the first
  study.base.layout = actuator::layout_of(actuator::Configuration::D);
  EXPECT_EQ(DesignProblem(study).problem().starts[0][0], 0.0);  // not in the list: its first
}

TEST(DesignProblem, StartsFromTheStudysStartsNext) {
  Study study = small_study();
  study.starts = {{0.0, 0.9, 13.0, 1.0}, {1.0, 1.1, 14.0, 2.0}};
  const Problem problem = DesignProblem(study).problem();
  ASSERT_EQ(problem.starts.size(), 3u);
  EXPECT_EQ(problem.starts[1], study.starts[0]);
  EXPECT_EQ(problem.starts[2], study.starts[1]);
}

TEST(DesignProblem, KnowsTheNearestCoordinateOfAValue) {
  const Study study = small_study();
  EXPECT_EQ(nearest_coordinate(study.variables[0], "A"), 1.0);
  EXPECT_EQ(nearest_coordinate(study.variables[0], "D"), std::nullopt);
  EXPECT_EQ(nearest_coordinate(study.variables[0], 1.0), std::nullopt);  // a word is wanted
  EXPECT_NEAR(nearest_coordinate(study.variables[1], 0.93).value(), 0.9, 1e-12);
  EXPECT_NEAR(nearest_coordinate(study.variables[1], 5.0).value(), 1.1, 1e-12);  // the last of its grid
  EXPECT_EQ(nearest_coordinate(study.variables[1], "A"), std::nullopt);
  EXPECT_EQ(nearest_coordinate(study.variables[2], 2.0), 13.0);
  EXPECT_EQ(nearest_coordinate(study.variables[3], 30.0), 2.0);  // the index in its list
  EXPECT_EQ(nearest_coordinate(study.variables[3], 99.0), 2.0);
}

TEST(DesignProblem, KeepsEveryQuantityOfADesign) {
  const DesignProblem problem(small_study());
  const std::vector point{0.0, 0.9, 13.0, 1.0};
  const auto design = std::get<EvaluatedDesign>(problem.evaluate(point));
  const Evaluation seen = problem.problem().evaluate(point);
  const simulation::QuantityTable& quantities = problem.study().quantities;
  ASSERT_EQ(seen.quantities.size(), quantities.size());
  for (std::size_t i = 0; i < quantities.size(); ++i)
    EXPECT_EQ(seen.quantities[i], quantities[i].value(design.view())) << quantities[i].name;
}

// Neither an objective nor a limit need stand in any table.
TEST(DesignProblem, TakesAnObjectiveOfAUsersOwn) {
  Study study = small_study();
  study.objectives = {{.quantity = {.name = "grasp_force_per_mass_N_kg",
                                    .meaning = "grasp force divided by the mass of the actuator",
                                    .scale = 15.0,
                                    .value =
                                        [](const simulation::DesignView& d) {
                                          return d.performance.cold.grasp_force / d.performance.mass;
                                        }},
                       .sense = Sense::maximise}};
  const DesignProblem problem(study);
  const std::vector point{0.0, 0.9, 13.0, 1.0};
  const auto design = std::get<EvaluatedDesign>(problem.evaluate(point));
  EXPECT_EQ(problem.problem().objectives[0].name, "grasp_force_per_mass_N_kg");
  EXPECT_EQ(problem.problem().evaluate(point).objectives,
            (std::vector{design.performance.cold.grasp_force / design.performance.mass}));
}

TEST(DesignProblem, NeedNotOutliveTheProblemItGives) {
  const std::vector point{0.0, 0.9, 13.0, 1.0};
  const Evaluation seen = DesignProblem(small_study()).problem().evaluate(point);
  const Problem problem = DesignProblem(small_study()).problem();
  EXPECT_EQ(problem.evaluate(point), seen);
}

TEST(DesignProblem, RefusesAnObjectiveWithoutAValue) {
  Study study = small_study();
  study.objectives[1].quantity.value = nullptr;
  expect_error<std::invalid_argument>([&] { DesignProblem{study}; },
                                      "quantity \"mass_g\": the function that gives the value must not be empty");
}

TEST(DesignProblem, SaysWhyADesignCannotBeBuilt) {
  Study study = small_study();
  study.variables = {ParameterVariable{.parameter = actuator::find_parameter("coil_inner_radius_mm"),
                                       .range = Choice{.values = {0.3, 0.45, 3.0}}}};
  const DesignProblem problem(study);
  const Evaluation far = problem.problem().evaluate(std::vector{0.0});
  const Evaluation near = problem.problem().evaluate(std::vector{1.0});
  EXPECT_EQ(far.failure, "coil inner radius must be at least 0.5334 mm for AWG 28; got 0.3 mm");
  EXPECT_GT(far.infeasibility, near.infeasibility);
  EXPECT_GT(near.infeasibility, 0.0);
  EXPECT_EQ(problem.problem().evaluate(std::vector{2.0}).failure, "");
}

TEST(DesignProblem, SaysWhichQuantityADesignLacks) {
  Study study = small_study();
  study.variables = {CurrentVariable{.range = Choice{.values = {0.0, 0.9, 4.0, 5.0}}}};
  study.current = VariedCurrent{};
  study.operating.duty = 1.0;
  study.objectives = {{.quantity = testing::quantity("rise_time_s"), .sense = Sense::minimise}};
  study.limits = {{.quantity = testing::quantity("coil_temperature_degC"), .value = 120.0}};
  const DesignProblem problem(study);
  const Problem searched = problem.problem();
  EXPECT_EQ(searched.evaluate(std::vector{0.0}).failure,
            "rise_time_s has no value: the current does not change the bending angle, or the current is at or beyond "
            "that of a "
            "thermal runaway");
  EXPECT_EQ(searched.evaluate(std::vector{1.0}).failure, "");
  const Evaluation runaway = searched.evaluate(std::vector{2.0});
  EXPECT_EQ(runaway.failure,
            "coil_temperature_degC has no value: the current is at or beyond that of a thermal runaway");
  // Further beyond is less feasible.
  EXPECT_GT(searched.evaluate(std::vector{3.0}).infeasibility, runaway.infeasibility);
}

TEST(DesignProblem, MakesAFailedDesignOfOneFarOutsideAllHardware) {
  Study study = small_study();
  study.variables = {
      ParameterVariable{.parameter = actuator::find_parameter("gap_mm"), .range = Choice{.values = {0.9, 1e6}}},
      ParameterVariable{.parameter = actuator::find_parameter("remanence_T"), .range = Choice{.values = {1.4, 1e6}}}};
  const DesignProblem problem(study);
  for (const auto& point : {std::vector{1.0, 0.0}, {0.0, 1.0}, {1.0, 1.0}}) {
    const Evaluation refused = problem.problem().evaluate(point);
    EXPECT_NE(refused.failure, "");
    EXPECT_GT(refused.infeasibility, 0.0);
  }
}

TEST(DesignProblem, EvaluatesTheActuatorItStartsFrom) {
  Study study = small_study();
  const auto base = std::get<EvaluatedDesign>(DesignProblem(study).evaluate_base());
  EXPECT_DOUBLE_EQ(base.point.current, 0.9 * 1.4);
  study.current = FixedCurrent{.current = -0.7};
  EXPECT_EQ(std::get<EvaluatedDesign>(DesignProblem(study).evaluate_base()).point.current, -0.7);
  study.variables.emplace_back(CurrentVariable{.range = Interval{.lower = 0.2, .upper = 0.8}});
  study.current = VariedCurrent{};
  study.limits.clear();
  // Faster with every ampere, so at the end of the range, and not at the 1.4 A that its wire of AWG 28 bears.
  EXPECT_EQ(std::get<EvaluatedDesign>(DesignProblem(study).evaluate_base()).point.current, 0.8);
}

// Of a quantity of our own that peaks at a current: every legal current is compared by hand.
TEST(DesignProblem, DrivesTheActuatorItStartsFromAsItsLimitsLetIt) {
  const auto of_current = [](std::string name, auto value) {
    return simulation::ResultQuantity{
        .name = std::move(name),
        .meaning = "of the current alone",
        .scale = 1.0,
        .value = [value](const simulation::DesignView& d) -> std::optional<double> { return value(d.point.current); }};
  };
  Study study = small_study();
  study.variables = {CurrentVariable{.range = Interval{.lower = 0.2, .upper = 1.3, .step = 0.01}}};
  study.current = VariedCurrent{};
  study.objectives = {
      {.quantity = of_current("hill", [](double i) { return -(i - 0.777) * (i - 0.777); }), .sense = Sense::maximise}};
  study.limits.clear();
  const auto current = [&] { return std::get<EvaluatedDesign>(DesignProblem(study).evaluate_base()).point.current; };
  EXPECT_DOUBLE_EQ(current(), 0.78);
  study.limits = {
      {.quantity = of_current("heat", [](double i) { return i * i; }), .side = Limit::Side::at_most, .value = 0.3}};
  EXPECT_DOUBLE_EQ(current(), 0.54);  // 0.54^2 = 0.2916, 0.55^2 = 0.3025
  study.limits.front().value = 0.01;  // below 0.1 A: none is allowed, and the lowest is the nearest
  EXPECT_DOUBLE_EQ(current(), 0.2);
  study.variables = {CurrentVariable{.range = Choice{.values = {0.3, 0.5, 1.1}}}};
  study.limits.front().value = 0.3;
  EXPECT_DOUBLE_EQ(current(), 0.5);
  study.variables = {CurrentVariable{.range = Interval{.lower = 0.2, .upper = 1.3}}};
  EXPECT_NEAR(current(), std::sqrt(0.3), 1.1e-3);  // a thousandth of the range
  EXPECT_LE(current(), std::sqrt(0.3));
}

TEST(DesignProblem, RefusesAStudyWithTwoCurrentsOrNone) {
  Study study = small_study();
  study.current = VariedCurrent{};
  expect_error<std::invalid_argument>([&] { DesignProblem{study}; },
                                      "current: must be fixed or a variable, one of the two");
  study = small_study();
  study.variables.emplace_back(CurrentVariable{.range = Interval{.lower = 0.2, .upper = 0.8}});
  expect_error<std::invalid_argument>([&] { DesignProblem{study}; },
                                      "current: must be fixed or a variable, one of the two");
}

TEST(DesignProblem, NumbersThePointsOfItsGridLastVariableFastest) {
  const DesignProblem problem(small_study());
  ASSERT_EQ(problem.point_count(), 2u * 3u * 2u * 3u);
  std::set<std::vector<double>> seen;
  for (std::size_t i = 0; i < problem.point_count(); ++i) {
    const std::vector<double> point = problem.point(i);
    if (!seen.empty()) {
      EXPECT_GT(point, *seen.rbegin()) << i;  // ascending, as an archive sorts
    }
    seen.insert(point);
  }
  EXPECT_EQ(problem.point(0), (std::vector{0.0, 0.7, 13.0, 0.0}));
  EXPECT_EQ(problem.point(1), (std::vector{0.0, 0.7, 13.0, 1.0}));
  EXPECT_EQ(problem.point(3), (std::vector{0.0, 0.7, 14.0, 0.0}));
  EXPECT_EQ(problem.point(35)[0], 1.0);
}

TEST(DesignProblem, RefusesToNumberPointsWithoutEndOrBeyondCounting) {
  Study study = small_study();
  study.variables[1] =
      ParameterVariable{.parameter = actuator::find_parameter("gap_mm"), .range = Interval{.lower = 0.7, .upper = 1.2}};
  expect_error<std::invalid_argument>([&] { (void)DesignProblem(study).point_count(); },
                                      "gap_mm must have a step or a list of values");
  study.variables.clear();
  for (const char* name : {"gap_mm", "side_wall_mm", "top_wall_mm"})
    study.variables.emplace_back(ParameterVariable{.parameter = actuator::find_parameter(name),
                                                   .range = Interval{.lower = 1, .upper = 2, .step = 2e-6}});
  expect_error<std::invalid_argument>([&] { (void)DesignProblem(study).point_count(); },
                                      "a grid must have at most 1000000000000 designs");
}

// Of a gripper 70 mm wide, say: a number that is no part of the design.
TEST(DesignProblem, GivesTheSettingsOfAPointToItsQuantities) {
  Study study = small_study();
  study.variables = {SettingVariable{
      .name = "gripper_spacing_mm", .base = 71.0, .range = Interval{.lower = 60, .upper = 80, .step = 5}}};
  study.objectives = {{.quantity = {.name = "spacing_m",
                                    .meaning = "the setting itself",
                                    .scale = 0.1,
                                    .value = [](const simulation::DesignView& d) -> std::optional<double> {
                                      const auto found = d.settings->find("gripper_spacing_mm");
                                      return found == d.settings->end() ? 0.071 : found->second;
                                    }},
                       .sense = Sense::maximise}};
  const DesignProblem problem(study);
  EXPECT_EQ(problem.problem().evaluate(std::vector{65.0}).objectives, (std::vector{0.065}));
  EXPECT_EQ(problem.problem().starts, (std::vector<std::vector<double>>{{71.0}}));
  EXPECT_EQ(problem.assess(problem.evaluate_base()).objectives, (std::vector{0.071}));
}

TEST(DesignProblem, TakesCurrentAndDutyThatFollowFromTheDesign) {
  Study study = small_study();
  study.current = DrivenCurrent{.drive = [](const actuator::Assembly& assembly, const simulation::Settings&) {
    return DrivenCurrent::Drive{.current = 4.2 / assembly.coil.resistance, .duty = 0.35};
  }};
  const auto design = std::get<EvaluatedDesign>(DesignProblem(study).evaluate(std::vector{0.0, 0.9, 13.0, 1.0}));
  EXPECT_EQ(design.point.current, 4.2 / design.performance.coil_resistance);
  EXPECT_EQ(design.point.duty, 0.35);
  study.current = DrivenCurrent{};
  expect_error<std::invalid_argument>([&] { DesignProblem{study}; },
                                      "current: the function that drives it must not be empty");
}

TEST(DesignProblem, TellsWhyAQuantityHasNoValueInADesign) {
  Study study = small_study();
  const simulation::ResultQuantity never{.name = "room_mm",
                                         .meaning = "without a value anywhere",
                                         .scale = 1.0,
                                         .value = [](const simulation::DesignView&) { return std::optional<double>(); },
                                         .why_absent =
                                             [](const simulation::DesignView& d) {
                                               return simulation::NoValue{.reason = "no room",
                                                                          .infeasibility = d.performance.mass};
                                             }};
  study.objectives = {{.quantity = never}};
  const DesignProblem problem(study);
  const std::vector point{0.0, 0.9, 13.0, 1.0};
  const Evaluation seen = problem.problem().evaluate(point);
  EXPECT_EQ(seen.failure, "room_mm has no value: no room");
  EXPECT_EQ(seen.infeasibility, std::get<EvaluatedDesign>(problem.evaluate(point)).performance.mass);
  // Through an expression too.
  study.objectives = {{.quantity = expression_quantity({.text = "room_mm * mass_g", .name = "product", .unit = "mm_g"},
                                                       study.quantities.with(never))}};
  EXPECT_EQ(DesignProblem(study).problem().evaluate(point).failure,
            "product_mm_g has no value: room_mm has no value (no room)");
}

}  // namespace
}  // namespace coilwright::sizing
