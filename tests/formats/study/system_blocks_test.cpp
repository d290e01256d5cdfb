// What the blocks of a study become. What is refused, and how, is in tests/cli/system_study_input_test.py.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <string>

#include "coilwright/formats/study/study_file.hpp"
#include "coilwright/sizing/study/broken_part_limits.hpp"
#include "coilwright/sizing/study/design_problem.hpp"
#include "temporary_folder.hpp"

namespace coilwright::formats {
namespace {

using namespace sizing;

class SystemBlocks : public ::testing::Test {
 protected:
  SystemBlocks() {
    std::ofstream(folder_.path() / "finger.json") << R"({"format": "actuator/1", "configuration": "B"})";
  }

  // A study with these further members.
  Study parse(const std::string& members) const {
    return parse_study(R"({"format": "study/1", "name": "x", "actuator": "finger.json", )" + members + "}",
                       (folder_.path() / "s.json").string());
  }

  coilwright::testing::TemporaryFolder folder_;
};

const std::string gripper = R"("gripper": {"width_mm": 60, "mass_g": 40, "friction": 0.8})";
const std::string crawler =
    R"("crawler": {"friction_forwards": 0.3, "friction_backwards": 0.6, "duty": 0.4, "cell_voltage_V": 4.1,
                   "step_ms": 0.2, "settling_periods": 0, "periods": 1})";

std::set<std::string> beyond_the_standard(const Study& study) {
  std::set<std::string> out;
  for (const simulation::ResultQuantity& each : study.quantities)
    if (simulation::standard_quantities().find(each.name) == nullptr) out.insert(each.name);
  return out;
}

// What nobody asked for would cost every design its time.
TEST_F(SystemBlocks, BringTheQuantitiesThatAreAskedForAndNoOthers) {
  const std::string rest =
      R"(, "operating_point": {"current_A": 1}, "variables": {"gap_mm": {"lower": 1, "upper": 2}})";
  EXPECT_EQ(beyond_the_standard(parse(gripper + rest + R"(, "objectives": [{"minimise": "mass_g"}])")),
            (std::set<std::string>{}));
  const Study study = parse(gripper + rest + R"(, "objectives": [{"minimise": "gripper_mass_g"}],
    "constraints": [{"quantity": "1 + grip_margin", "name": "safety", "unit": "1", "at_least": 2}],
    "columns": [{"quantity": "grip_closing_time_ms"}, {"quantity": "mass_g"}])");
  EXPECT_EQ(beyond_the_standard(study), (std::set<std::string>{"gripper_mass_g", "safety", "grip_closing_time_ms"}));
}

TEST_F(SystemBlocks, OfAGripperHoldTheFingerInItsPose) {
  const Study study = parse(gripper + R"(, "operating_point": {"current_A": 1},
    "variables": {"gap_mm": {"lower": 1, "upper": 2}}, "objectives": [{"maximise": "grip_margin"}])");
  EXPECT_EQ(study.operating.cases, actuator::HeldCases::gripping);
}

TEST_F(SystemBlocks, LetTheirNumbersVary) {
  const Study study = parse(gripper + R"(, "operating_point": {"current_A": 1.4},
    "variables": {"gripper_centre_below_palm_mm": {"values": [10, 18]}, "gripper_mass_g": {"lower": 20, "upper": 50}},
    "objectives": [{"minimise": "grip_load_N"}])");
  const DesignProblem problem(study);
  EXPECT_EQ(problem.problem().starts.at(0), (std::vector{1.0, 40.0}));  // 16 mm is nearer to 18 than to 10
  EXPECT_EQ(problem.settings_at(std::vector{0.0, 25.0}),
            (simulation::Settings{{"gripper_centre_below_palm_mm", 0.01}, {"gripper_mass_g", 0.025}}));
  const Evaluation light = problem.problem().evaluate(std::vector{1.0, 25.0});
  ASSERT_EQ(light.failure, "");
  EXPECT_DOUBLE_EQ(light.objectives[0], 0.025 * 9.81);
}

TEST_F(SystemBlocks, OfACrawlerDriveTheActuator) {
  const Study study = parse(crawler + R"(, "operating_point": {"current_of": "crawler"},
    "variables": {"crawler_duty": {"values": [0.3, 0.4]}}, "objectives": [{"minimise": "crawl_cell_load"}])");
  const DesignProblem problem(study);
  const auto design = std::get<EvaluatedDesign>(problem.evaluate(std::vector{0.0}));
  EXPECT_EQ(design.point.duty, 0.3);
  // Two coils of the default finger on one cell, with 0.12 ohm of leads in front of both.
  EXPECT_DOUBLE_EQ(design.point.current, 4.1 / (design.performance.coil_resistance + 2 * 0.12));
  EXPECT_DOUBLE_EQ(problem.problem().evaluate(std::vector{0.0}).objectives[0], 2.0 * design.point.current / 3.0);
  EXPECT_EQ(std::get<EvaluatedDesign>(problem.evaluate_base()).point.duty, 0.4);
}

const std::string weak_cell = R"("driver": {"kind": "cell", "voltage_V": 6, "resistance_Ohm": 1},
                                 "operating_point": {"current_A": 0.5})";

// Whether or not any quantity of the driver is asked for.
TEST_F(SystemBlocks, OfADriverLeaveNoPerformanceToWhatItCannotDrive) {
  const DesignProblem problem(parse(weak_cell + R"(, "variables": {"driver_voltage_V": {"values": [1, 6]}},
    "objectives": [{"minimise": "mass_g"}])"));
  const Evaluation weak = problem.problem().evaluate(std::vector{0.0});
  EXPECT_EQ(weak.failure.find("the driver cannot give the current: raise driver.voltage_V or lower current_A; got 0."),
            0u)
      << weak.failure;
  EXPECT_GT(weak.infeasibility, 0.0);
  EXPECT_EQ(problem.problem().evaluate(std::vector{1.0}).failure, "");
  EXPECT_TRUE(std::holds_alternative<EvaluatedDesign>(problem.evaluate_base()));
}

// Two of five builds have a cell that is too weak.
TEST_F(SystemBlocks, OfADriverCountInEveryBuild) {
  const auto failure = [this](const std::string& deviations) {
    const DesignProblem problem(parse(weak_cell + R"(, "variables": {"gap_mm": {"values": [0.9]}},
      "spread": {"driver_voltage_V": {"uniform": )" +
                                      deviations + R"(}}, "objectives": [{"minimise": "p05_mass_g"}])"));
    return problem.problem().evaluate(std::vector{0.0}).failure;
  };
  EXPECT_EQ(failure("[-0.5, 0.5]"), "");
  EXPECT_EQ(failure("[-5.5, 1]"), "p05_mass_g has no value: it has none in too many builds of the spread");
}

// The ripple of slow pulses heats more than a limit on thermal_load knows.
TEST_F(SystemBlocks, OfADriverHaveALimitOfTheirPulses) {
  struct OverSteady {
    double load{};  // with the pulses, over that of the steady current
    bool peaks_are_too_high{};
  };
  const auto limit = [this](const std::string& frequency) {
    const DesignProblem problem(parse(R"("driver": {"kind": "h_bridge", "voltage_V": 24, "frequency_Hz": )" +
                                      frequency +
                                      R"(}, "operating_point": {"current_A": 0.5},
      "variables": {"gap_mm": {"values": [0.9]}}, "objectives": [{"minimise": "mass_g"}])"));
    const auto design = std::get<EvaluatedDesign>(problem.evaluate(std::vector{0.0}));
    const double load = simulation::standard_quantities().at("thermal_load").value(design.view()).value();
    const std::vector<simulation::PartLimit> limits = limits_of_pulses(problem.study(), design);
    EXPECT_EQ(limits.at(1).quantity, "driver_peak_over_limit");
    return OverSteady{.load = limits.front().value.value() / load, .peaks_are_too_high = limits[1].is_broken()};
  };
  EXPECT_NEAR(limit("200000").load, 1.0, 1e-3);
  EXPECT_FALSE(limit("200000").peaks_are_too_high);
  EXPECT_GT(limit("100").load, 1.5);
  EXPECT_TRUE(limit("100").peaks_are_too_high);
}

}  // namespace
}  // namespace coilwright::formats
