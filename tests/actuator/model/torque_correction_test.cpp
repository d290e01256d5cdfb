#include "coilwright/actuator/model/torque_correction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <vector>

#include "coilwright/actuator/model/model.hpp"
#include "error_text.hpp"

namespace coilwright::actuator {
namespace {

using enum CorrectionVariable;

// Uneven nodes, and torques of no pattern.
TorqueCorrection over_angle_and_rate() {
  return {.axes = {{.variable = angle, .nodes = {-0.1, 0.2, 0.45, 0.9}},
                   {.variable = rate, .nodes = {-7.0, -1.5, 0.0, 2.5, 8.0}, .linear_below = 0.6}},
          .torques = {1e-3,  -2e-3, 0.5e-3, 3e-3,  -1e-3,  2e-3,   0.7e-3, -0.4e-3, 1.1e-3, 2.3e-3,
                      -3e-3, 1e-3,  0.2e-3, -1e-3, 0.9e-3, 1.7e-3, 2e-3,   -0.6e-3, 0.3e-3, -2e-3}};
}

TorqueCorrection over_angle(std::vector<double> nodes, std::vector<double> torques) {
  return {.axes = {{.variable = angle, .nodes = std::move(nodes)}}, .torques = std::move(torques)};
}

TEST(TorqueSurface, HasTheGivenTorquesAtItsNodes) {
  const TorqueCorrection given = over_angle_and_rate();
  const TorqueSurface surface(given);
  std::size_t node = 0;
  for (const double first : given.axes[0].nodes)
    for (const double second : given.axes[1].nodes)
      EXPECT_NEAR(surface.at(first, second).torque, given.torques[node++], 1e-17);  // some eps of 3e-3
}

// A natural spline bends least of all curves through its points: through points of a line it is that line.
TEST(TorqueSurface, IsStraightWhereItsTorquesAre) {
  const TorqueSurface surface(over_angle({-0.3, 0.1, 0.2, 0.7}, {-2.6e-3, -0.2e-3, 0.4e-3, 3.4e-3}));
  for (const double at : {-0.29, 0.0, 0.13, 0.55}) EXPECT_NEAR(surface.at(at, 9.0).torque, 6e-3 * at - 0.8e-3, 1e-17);
}

// The same spline another way: of a product of two functions it is the product of their splines.
TEST(TorqueSurface, OfAProductIsTheProductOfTheSurfacesOfItsFactors) {
  const std::vector<double> first{-0.1, 0.2, 0.45, 0.9};
  const std::vector<double> second{-0.5, 0.1, 1.2};
  const std::vector<double> f{2e-3, -1e-3, 0.4e-3, 3e-3};
  const std::vector<double> g{0.7, -1.3, 2.1};
  TorqueCorrection product{.axes = {{.variable = angle, .nodes = first}, {.variable = current, .nodes = second}}};
  for (const double each : f)
    for (const double other : g) product.torques.push_back(each * other);
  const TorqueSurface whole(product);
  const TorqueSurface of_f(over_angle(first, f));
  const TorqueSurface of_g({.axes = {{.variable = current, .nodes = second}}, .torques = g});
  for (const double x : {-0.17, -0.02, 0.31, 0.93})
    for (const double y : {-0.6, 0.4, 1.1, 1.3})
      EXPECT_NEAR(whole.at(x, y).torque, of_f.at(x, 0.0).torque * of_g.at(y, 0.0).torque, 1e-16) << x << " " << y;
}

// Inside, at the edges, where it fades and beyond.
TEST(TorqueSurface, HasTheSlopesOfItsTorque) {
  const TorqueSurface surface(over_angle_and_rate());
  constexpr double step = 1e-6;  // truncation 1e-12 of third derivatives of 1, rounding 1e-19 / 1e-6
  for (const double x : {-0.25, -0.16, -0.1, 0.0, 0.45, 0.9, 0.96, 1.3})
    for (const double y : {-20.0, -8.5, -7.0, -0.3, 0.0, 1.0, 8.0, 9.0, 30.0}) {
      const TorqueSurface::Value here = surface.at(x, y);
      EXPECT_NEAR(here.slopes[0], (surface.at(x + step, y).torque - surface.at(x - step, y).torque) / (2.0 * step),
                  1e-8)
          << x << " " << y;
      EXPECT_NEAR(here.slopes[1], (surface.at(x, y + step).torque - surface.at(x, y - step).torque) / (2.0 * step),
                  1e-8)
          << x << " " << y;
    }
}

TEST(TorqueSurface, IsTwiceDifferentiableAtItsNodesAndEdges) {
  const TorqueSurface surface(over_angle_and_rate());
  constexpr double step = 1e-5;
  const auto slope = [&](double x) { return surface.at(x, 1.3).slopes[0]; };
  // First and last node, one between, and the two places where it is gone.
  for (const double x : {-0.1, 0.2, 0.9, -0.2, 1.0}) {
    const double before = (slope(x - step) - slope(x - 2.0 * step)) / step;
    const double after = (slope(x + 2.0 * step) - slope(x + step)) / step;
    EXPECT_NEAR(slope(x - step), slope(x + step), 1e-4) << x;  // second derivatives of 1 N m/rad^2 times the step
    EXPECT_NEAR(before, after, 2e-2) << x;                     // third derivatives of 100 N m/rad^3 times the steps
  }
}

TEST(TorqueSurface, IsGoneATenthOfItsRangeBeyondIt) {
  const TorqueSurface surface(over_angle_and_rate());
  EXPECT_NE(surface.at(0.99, 1.0).torque, 0.0);
  for (const double x : {-0.2001, 1.0001, 4.0, -50.0}) EXPECT_EQ(surface.at(x, 1.0).torque, 0.0) << x;
  for (const double y : {-40.0, 40.0, 1e6}) EXPECT_EQ(surface.at(0.3, y).torque, 0.0) << y;
}

TEST(TorqueSurface, NeverExceedsItsLargestTorqueByMuchWhereItFades) {
  const TorqueSurface surface(over_angle({0.0, 0.1, 0.2, 0.3}, {1e-3, -1e-3, 1e-3, -1e-3}));
  double largest = 0.0;
  for (int i = 0; i <= 1000; ++i) largest = std::max(largest, std::abs(surface.at(-0.1 + 5e-4 * i, 0.0).torque));
  // Going on straight for a tenth of the range while it fades adds at most a fifth of slope times width: 0.3 here.
  EXPECT_LE(largest, 1.35e-3);
}

std::string correction_refusal(const TorqueCorrection& correction) {
  return error_text([&] { validate(correction); });
}

TEST(TorqueCorrection, SaysWhatIsWrongWithIt) {
  TorqueCorrection good = over_angle_and_rate();
  EXPECT_EQ(correction_refusal(good), "");
  TorqueCorrection wrong = good;
  wrong.axes.clear();
  EXPECT_EQ(correction_refusal(wrong), "torque_correction: must be over one or two variables; got 0");
  wrong = good;
  wrong.axes[0].nodes = {0.1, 0.2};
  EXPECT_EQ(correction_refusal(wrong), "torque_correction: angle must have at least 3 nodes; got 2");
  wrong = good;
  wrong.axes[1].nodes[2] = -2.0;
  EXPECT_EQ(correction_refusal(wrong), "torque_correction: nodes of rate must increase; got -2 after -1.5");
  wrong = good;
  wrong.axes[1].linear_below = 0.0;
  EXPECT_EQ(correction_refusal(wrong), "torque_correction: rate must be linear below a finite value > 0; got 0");
  wrong = good;
  wrong.axes[1].variable = angle;
  EXPECT_EQ(correction_refusal(wrong), "torque_correction: its variables must differ; got angle twice");
  wrong = good;
  wrong.torques.pop_back();
  EXPECT_EQ(correction_refusal(wrong), "torque_correction: must have one torque per node, 20 here; got 19");
  wrong = good;
  wrong.torques[3] = NAN;
  EXPECT_EQ(correction_refusal(wrong), "torque_correction: torques must be finite; got nan");
}

// Two joints without gravity, coils or springs.
ModelSpec chain_with(std::optional<TorqueCorrection> correction) {
  const std::vector<mechanics::Link> links{
      {.length = 0.02, .com_along = 0.011, .com_offset = 0.002, .mass = 0.02, .inertia = 3e-6},
      {.length = 0.018, .com_along = 0.009, .com_offset = 0.001, .mass = 0.015, .inertia = 2e-6}};
  return {.chain = mechanics::PlanarChain(links, 0.0),
          .hinges = {Hinge{.stiffness = 0.011}, Hinge{.stiffness = 0.013}},
          .magnetics = {},
          .coils = 0,
          .tip = {},
          .torque_correction = std::move(correction)};
}

mechanics::JointVector pair_of(double first, double second) {
  mechanics::JointVector out(2);
  out << first, second;
  return out;
}

TEST(CorrectedModel, AddsTheTorqueOfItsOwnStateToEveryJoint) {
  const TorqueCorrection correction = over_angle_and_rate();
  const TorqueSurface surface(correction);
  const Model with(chain_with(correction));
  const Model without(chain_with(std::nullopt));
  const auto angles = pair_of(0.13, 0.61);
  const auto rates = pair_of(-2.2, 4.1);
  const mechanics::JointVector added =
      with.torques(angles, rates, with.all_coils(0.0)) - without.torques(angles, rates, without.all_coils(0.0));
  EXPECT_NEAR(added[0], surface.at(0.13, -2.2).torque, 1e-17);
  EXPECT_NEAR(added[1], surface.at(0.61, 4.1).torque, 1e-17);
  EXPECT_EQ(with.nominal_spec().torque_correction, correction);
}

TEST(CorrectedModel, LeavesJointsAloneThatHaveNone) {
  TorqueCorrection correction = over_angle_and_rate();
  correction.joint = 1;
  const Model with(chain_with(correction));
  const Model without(chain_with(std::nullopt));
  const auto angles = pair_of(0.13, 0.61);
  const auto rates = pair_of(-2.2, 4.1);
  const mechanics::JointVector added =
      with.torques(angles, rates, with.all_coils(0.0)) - without.torques(angles, rates, without.all_coils(0.0));
  EXPECT_EQ(added[0], 0.0);
  EXPECT_NE(added[1], 0.0);
}

TEST(CorrectedModel, CountsTheSlopeOverTheRateAsDamping) {
  const TorqueCorrection correction = over_angle_and_rate();
  const Model model(chain_with(correction));
  const auto angles = pair_of(0.13, 0.61);
  const mechanics::JointMatrix damping = model.damping(angles, model.all_coils(0.0));
  const TorqueSurface surface(correction);
  EXPECT_NEAR(damping(0, 0), -surface.at(0.13, 0.0).slopes[1], 1e-17);
  EXPECT_NEAR(damping(1, 1), -surface.at(0.61, 0.0).slopes[1], 1e-17);
  EXPECT_EQ(damping(0, 1), 0.0);
}

// The work of the joints over a small time is the change of kinetic energy plus that of two potentials: of the spring,
// and of the correction, integrated here by Simpson's rule.
TEST(CorrectedModel, KeepsEnergyWhereItsTorqueDependsOnTheAngleAlone) {
  const TorqueCorrection correction = over_angle({-0.1, 0.2, 0.45, 0.9}, {1e-3, -2e-3, 0.5e-3, 3e-3});
  const TorqueSurface surface(correction);
  const Model model(chain_with(correction));
  const auto work_to = [&](double to) {
    constexpr int pieces = 2000;
    double sum = surface.at(0.0, 0.0).torque + surface.at(to, 0.0).torque;
    for (int i = 1; i < pieces; ++i) sum += (i % 2 == 1 ? 4.0 : 2.0) * surface.at(to * i / pieces, 0.0).torque;
    return sum * to / pieces / 3.0;
  };
  const auto energy = [&](const mechanics::JointVector& angles, const mechanics::JointVector& rates) {
    double sum = 0.5 * rates.dot(model.chain().mass_matrix(angles) * rates);
    for (int j = 0; j < 2; ++j)
      sum += 0.5 * model.hinges()[static_cast<std::size_t>(j)].stiffness * angles[j] * angles[j] - work_to(angles[j]);
    return sum;
  };
  // Runge and Kutta's steps of fourth order, small enough that halving them changes nothing that is tested.
  mechanics::JointVector angles = pair_of(0.7, 0.3);
  mechanics::JointVector rates = pair_of(0.0, 0.0);
  const double before = energy(angles, rates);
  constexpr double step = 2e-5;
  const auto slope = [&](const mechanics::JointVector& at, const mechanics::JointVector& moving) {
    mechanics::JointVector out(2);
    model.derivative(at, moving, {}, model.all_coils(0.0), pair_of(0.0, 0.0), out, {});
    return out;
  };
  for (int i = 0; i < 20'000; ++i) {
    const mechanics::JointVector a1 = slope(angles, rates);
    const mechanics::JointVector r2 = rates + 0.5 * step * a1;
    const mechanics::JointVector a2 = slope(angles + 0.5 * step * rates, r2);
    const mechanics::JointVector r3 = rates + 0.5 * step * a2;
    const mechanics::JointVector a3 = slope(angles + 0.5 * step * r2, r3);
    const mechanics::JointVector r4 = rates + step * a3;
    const mechanics::JointVector a4 = slope(angles + step * r3, r4);
    angles += step / 6.0 * (rates + 2.0 * r2 + 2.0 * r3 + r4);
    rates += step / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
  }
  EXPECT_GT((angles - pair_of(0.7, 0.3)).norm(), 0.05);
  EXPECT_NEAR(energy(angles, rates), before, 1e-6 * before);
}

TEST(CorrectedModel, IsRefusedWithoutTheCoilOrTheJointThatItNeeds) {
  TorqueCorrection correction = over_angle({-0.1, 0.2, 0.45}, {1e-3, -2e-3, 0.5e-3});
  correction.joint = 2;
  EXPECT_EQ(error_text([&] { (void)Model(chain_with(correction)); }), "torque_correction: joint must be 1 to 2; got 3");
  correction = over_angle({-0.1, 0.2, 0.45}, {1e-3, -2e-3, 0.5e-3});
  correction.axes[0].variable = current;
  EXPECT_EQ(error_text([&] { (void)Model(chain_with(correction)); }),
            "torque_correction: over the current needs coils, and the model has none");
}

}  // namespace
}  // namespace coilwright::actuator
