#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/exports/kinds.hpp"

namespace coilwright::exports {
namespace {

using actuator::Configuration;
using actuator::Design;
using actuator::Model;
using ::testing::HasSubstr;

Model model_of(Configuration configuration) {
  Design design;
  design.layout = actuator::layout_of(configuration);
  return actuator::assemble_or_throw(design).model;
}

Model rebuilt(const LumpedNumbers& numbers) {
  return Model(actuator::spec_of(numbers.model, actuator::magnetics_of(numbers.model)));
}

// A table is read to 1e-4 of its largest torque, 17 mN m/A at the prototype's straight joint.
constexpr double table_error = 1.7e-6;

TEST(LumpedNumbers, TurnTheJointsOfAFingerAsItsDesignDoes) {
  const Model model = model_of(Configuration::B);
  const Model lumped = rebuilt(lumped_numbers(model));
  ASSERT_EQ(lumped.joints(), 2);
  ASSERT_EQ(lumped.coils(), 2);
  const actuator::CoilCurrents currents = (actuator::CoilCurrents(2) << 0.7, 1.3).finished();
  for (const double first : {-0.01, 0.07, 0.33, 0.81, 1.6}) {
    mechanics::JointVector pose(2);
    pose << first, 0.9 - 0.4 * first;
    const mechanics::JointVector rates = (mechanics::JointVector(2) << 3.0, -2.0).finished();
    const mechanics::JointVector expected = model.torques(pose, rates, currents);
    const mechanics::JointVector found = lumped.torques(pose, rates, currents);
    for (int j = 0; j < 2; ++j) EXPECT_NEAR(found[j], expected[j], 1.3 * table_error) << first;
    EXPECT_TRUE(lumped.chain().mass_matrix(pose).isApprox(model.chain().mass_matrix(pose), 1e-14));
    EXPECT_TRUE(lumped.chain().gravity_torques(pose).isApprox(model.chain().gravity_torques(pose), 1e-14));
  }
}

TEST(LumpedNumbers, KeepThePlaceOfTheTip) {
  const Model model = model_of(Configuration::A);
  const Model lumped = rebuilt(lumped_numbers(model));
  const mechanics::JointVector pose = mechanics::JointVector::Constant(1, 0.4);
  EXPECT_TRUE(lumped.chain().position(lumped.tip(), pose).isApprox(model.chain().position(model.tip(), pose), 1e-14));
}

// Joints 2 and 3 of a C are turned by the coil between its magnets, in the sense that repels each.
TEST(LumpedNumbers, KeepTheSenseOfEveryPair) {
  Design design;
  design.layout = actuator::layout_of(Configuration::C);
  design.layout[3].polarity = -1;
  const Model model = actuator::assemble_or_throw(design).model;
  const LumpedNumbers numbers = lumped_numbers(model);
  ASSERT_EQ(numbers.model.pairs.size(), 4U);
  std::vector<double> first;
  for (const actuator::LumpedPair& pair : numbers.model.pairs)
    first.push_back(std::get<actuator::TorqueTable>(pair.source).torques.front());
  EXPECT_GT(first[0], 0.0);
  EXPECT_GT(first[1], 0.0);
  EXPECT_LT(first[2], 0.0);
  EXPECT_LT(first[3], 0.0);
}

TEST(LumpedNumbers, NameWhatNeighboursDoNotDoOnlyWhereThereIsMore) {
  const auto left_out = [](Configuration configuration) { return lumped_numbers(model_of(configuration)).left_out; };
  for (const std::string& line : left_out(Configuration::B)) EXPECT_THAT(line, ::testing::Not(HasSubstr("neighbours")));
  EXPECT_THAT(left_out(Configuration::C), ::testing::Contains(HasSubstr("the pull between magnets")));
  EXPECT_THAT(left_out(Configuration::D), ::testing::Contains(HasSubstr("not their neighbours")));
}

// What was exported once is numbers already: nothing more is lost, and the tables are near the first ones.
TEST(LumpedNumbers, OfALumpedModelAreItself) {
  const LumpedNumbers once = lumped_numbers(model_of(Configuration::B));
  const Model lumped = rebuilt(once);
  const LumpedNumbers twice = lumped_numbers(lumped);
  EXPECT_TRUE(twice.left_out.empty());
  const Model again = rebuilt(twice);
  for (const double angle : {0.0, 0.4, 1.1}) {
    const mechanics::JointVector pose = mechanics::JointVector::Constant(2, angle);
    const mechanics::JointVector difference =
        again.magnetic_torques(pose, again.all_coils(1.0)) - lumped.magnetic_torques(pose, lumped.all_coils(1.0));
    EXPECT_LT(difference.cwiseAbs().maxCoeff(), table_error);
  }
}

}  // namespace
}  // namespace coilwright::exports
