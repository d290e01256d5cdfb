#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <cstdio>
#include <thread>
#include <vector>

#include "actuator/paper_finger.hpp"
#include "coilwright/actuator/assemble.hpp"
#include "coilwright/actuator/parts/coil_row.hpp"
#include "coilwright/actuator/parts/hinge_pair_parts.hpp"
#include "coilwright/magnetics/hinge_torque.hpp"
#include "coilwright/magnetics/wrench.hpp"
#include "degree.hpp"
#include "error_text.hpp"

namespace coilwright::actuator {
namespace {

using mechanics::JointVector;

ModelSpec finger_spec(Configuration configuration) {
  Design design = paper_finger();
  design.layout = layout_of(configuration);
  return assemble_or_throw(design).model.nominal_spec();
}

TEST(HingePairParts, GiveTheExactTorqueOfAPairTakenByItsLineOfCentres) {
  const HingePair pair = finger_spec(Configuration::B).magnetics.hinge_pairs().front();
  ASSERT_NE(pair.parts, nullptr);
  const HingePairParts::Spec& spec = pair.parts->spec();
  EXPECT_EQ(spec.fidelity, magnetics::Fidelity::line_of_centres);
  for (const double angle : {0.0, 30.0 * degree, 82.5 * degree}) {
    const auto torque = [&](magnetics::Fidelity fidelity) {
      return magnetics::hinge_torque_per_ampere(spec.coil, spec.magnet, spec.geometry, fidelity, angle);
    };
    const double largest = torque(magnetics::Fidelity::exact) + 1e-3;
    EXPECT_NEAR(pair.torque_per_ampere->value(angle), torque(magnetics::Fidelity::line_of_centres), 2e-6 * largest);
    EXPECT_NEAR(pair.parts->exact_torque()->value(angle), torque(magnetics::Fidelity::exact), 2e-6 * largest);
  }
}

TEST(HingePairParts, BuildTheExactCurveOnceForAllThreads) {
  const HingePair pair = finger_spec(Configuration::B).magnetics.hinge_pairs().front();
  std::vector<std::shared_ptr<const magnetics::Curve>> seen(4);
  {
    std::vector<std::jthread> threads;
    for (auto& curve : seen) threads.emplace_back([&curve, &pair] { curve = pair.parts->exact_torque(); });
  }
  for (const auto& curve : seen) EXPECT_EQ(curve, seen.front());
  EXPECT_NE(seen.front(), nullptr);
}

// Work that the exact wrench on the second coil does when a joint between the two turns by a little.
JointVector exact_torques(const ModelSpec& spec, const PlacedCoil& first, const PlacedCoil& second,
                          const JointVector& angles, double first_current, double second_current) {
  const mechanics::LinkFrames frames = spec.chain.frames(angles);
  const auto at = [&](int link) { return frames[static_cast<std::size_t>(link + 1)]; };
  const auto space = [](const Eigen::Vector2d& v) { return Eigen::Vector3d(v.x(), v.y(), 0.0); };
  const Eigen::Vector3d axis = space(at(first.centre.link).axis());
  const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(axis, Eigen::Vector3d::UnitZ());
  const Eigen::Vector3d between =
      space(spec.chain.position(second.centre, angles) - spec.chain.position(first.centre, angles));
  const magnetics::Wrench wrench =
      magnetics::wrench(first.coil, first_current, second.coil, second_current,
                        {.position = turn * between, .axis = turn * space(at(second.centre.link).axis())});
  const Eigen::Vector3d force = turn.conjugate() * wrench.force;
  const Eigen::Vector3d torque = turn.conjugate() * wrench.torque;
  JointVector out = JointVector::Zero(spec.chain.joints());
  const mechanics::PointJacobian moves = spec.chain.jacobian(second.centre, angles);
  for (int j = first.centre.link + 1; j <= second.centre.link; ++j)
    out[j] = moves.col(j).dot(force.head<2>()) + torque.z();
  return out;
}

// The source paper: 0.024 N at 1.4 A in both, two gaps and a magnet's length apart.
TEST(CoilRow, PullsAsThePaperSays) {
  const ModelSpec spec = finger_spec(Configuration::B);
  ASSERT_NE(spec.coil_row, nullptr);
  const std::vector<DistantPair> pairs = spec.coil_row->pairs();
  ASSERT_EQ(pairs.size(), 1U);
  EXPECT_EQ(pairs[0].coil, 0);
  EXPECT_EQ(pairs[0].second_coil, 1);
  const double force = 1.4 * 1.4 * pairs[0].axial_force->value(2.0 * 9.9e-3);
  std::printf("two coils at 1.4 A, 19.8 mm apart: %.4f N; the paper: 0.024 N\n", -force);
  EXPECT_NEAR(-force, 0.024, 0.0015);  // like currents attract; its last digit is a field solver's
}

// Against the exact wrench, which knows no axis: on the axis to the curve's 1e-6, off it as well as dipoles are.
TEST(CoilRow, TurnsTheJointsAsTheExactWrenchDoes) {
  ModelSpec spec = finger_spec(Configuration::B);
  const std::vector<PlacedCoil>& coils = spec.coil_row->coils();
  const CoilRow dipoles(spec.chain, coils, DistantPair::Orientation::dipoles);
  const MagneticStage stage({}, dipoles.pairs());
  CoilCurrents currents(2);
  currents << 1.4, -0.9;
  double largest = 0.0;
  for (const double angle : {0.0, 10.0 * degree, 30.0 * degree}) {
    const JointVector angles = JointVector::Constant(2, angle);
    JointVector torques = JointVector::Zero(2);
    stage.add_torques(spec.chain, angles, currents, torques);
    const JointVector exact = exact_torques(spec, coils[0], coils[1], angles, 1.4, -0.9);
    largest = std::max(largest, exact.lpNorm<Eigen::Infinity>());
    const double allowed = angle == 0.0 ? 1e-5 : 0.25;
    EXPECT_LT((torques - exact).lpNorm<Eigen::Infinity>(), allowed * largest) << angle / degree;
  }
  EXPECT_GT(largest, 1e-4);
}

// Magnets between them do not matter: every coil of C pulls at every other, with one curve.
TEST(CoilRow, PairsEveryCoilWithEveryOther) {
  const ModelSpec spec = finger_spec(Configuration::C);
  const std::vector<DistantPair> pairs = spec.coil_row->pairs();
  ASSERT_EQ(pairs.size(), 3U);
  EXPECT_EQ(pairs[0].axial_force, pairs[2].axial_force);
  EXPECT_EQ(pairs[1].first.link, -1);
  EXPECT_EQ(pairs[1].second.link, 3);
  const double near = std::abs(pairs[0].axial_force->value(19.8e-3));
  const double far = std::abs(pairs[1].axial_force->value(39.6e-3));
  EXPECT_NEAR(near / far, 16.0, 5.0);  // dipoles: the fourth power
}

TEST(CoilRow, HasTheToleranceOfItsDesign) {
  const auto force = [](double tolerance) {
    Design design = paper_finger();
    design.curve_tolerance = tolerance;
    return assemble_or_throw(design).model.nominal_spec().coil_row->pairs()[0].axial_force->value(2.0 * 9.9e-3);
  };
  EXPECT_NE(force(1e-2), force(1e-6));
  // Of the largest, at 0.9 of this distance: 1.5 times this by the fourth power.
  EXPECT_NEAR(force(1e-2), force(1e-6), 2e-2 * std::abs(force(1e-6)));
}

TEST(CoilRow, NeedsTwoCoilsOnRisingLinks) {
  const ModelSpec spec = finger_spec(Configuration::B);
  std::vector<PlacedCoil> coils = spec.coil_row->coils();
  std::swap(coils[0], coils[1]);
  const auto text = [&] {
    return error_text([&] { (void)CoilRow(spec.chain, coils, DistantPair::Orientation::dipoles); });
  };
  EXPECT_EQ(text(), "coils: links must rise; got -1 after 1");
  coils.pop_back();
  EXPECT_EQ(text(), "coils: at least two; got 1");
  EXPECT_EQ(finger_spec(Configuration::A).coil_row, nullptr);
}

}  // namespace
}  // namespace coilwright::actuator
