#include "truth/motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "actuator/paper_finger.hpp"
#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "coilwright/simulation/equilibrium.hpp"
#include "coilwright/simulation/performance.hpp"
#include "coilwright/simulation/transient.hpp"
#include "degree.hpp"
#include "truth/torque_curves.hpp"

namespace truth {
namespace {

Experiment step_to(double current, double interval, double duration) {
  Experiment experiment;
  for (int i = 0; i * interval <= duration; ++i) {
    experiment.times.push_back(i * interval);
    experiment.currents.push_back(i == 0 ? 0.0 : current);
  }
  return experiment;
}

coilwright::simulation::Performance code_under_test(double current) {
  const auto design = coilwright::actuator::paper_finger();
  return std::get<coilwright::simulation::Performance>(coilwright::simulation::performance_of(
      design, coilwright::actuator::assemble_or_throw(design), {.current = current}));
}

// Two independent programs: a figure of the paper's finger on which both agree is wrong only if both are wrong.
TEST(Truth, HasTheEquilibriaOfTheCodeUnderTest) {
  for (const double current : {0.35, 0.7, 1.05, 1.4}) {
    const auto theirs = code_under_test(current).cold.steady_angles;
    const auto ours = equilibrium({}, {}, current);
    for (int j = 0; j < 2; ++j) EXPECT_NEAR(ours[j] / degree, theirs[j] / degree, 1e-4) << current;
  }
}

TEST(Truth, BendsAsFarAndAsFastAsTheCodeUnderTest) {
  const auto theirs = code_under_test(1.4).cold;
  const auto ours = equilibrium({}, {}, 1.4);
  EXPECT_NEAR((ours[0] + ours[1]) / degree, 63.617, 0.5e-3);
  EXPECT_NEAR(theirs.steady_angles.sum() / degree, 63.617, 0.5e-3);
  // The step is in the second sample, 10 us late, which does not change a peak.
  const double peak = peak_bending_rate({}, {}, step_to(1.4, 1e-5, 0.05));
  EXPECT_NEAR(peak / degree, 1708.07, 0.01);
  EXPECT_NEAR(theirs.peak_bending_speed / degree, 1708.07, 0.01);
}

// Both stop, hold and let go at the same instants, in either of their ways to find them; what is left is that of
// curves.
TEST(Truth, SticksWhereTheCodeUnderTestSticks) {
  constexpr double friction = 4e-4;
  Experiment experiment;
  for (int i = 0; i <= 1000; ++i) {
    const double time = 2e-3 * i;
    experiment.times.push_back(time);
    experiment.currents.push_back(time < 0.4 ? 1.4 : time < 0.9 ? 0.0 : 0.7 + 0.5 * std::sin(12.0 * time));
  }
  const Trajectory ours = simulate({}, {.friction = friction}, experiment);

  auto design = coilwright::actuator::paper_finger();
  design.effects = {{coilwright::actuator::standard_effects().find("dry_friction"), {friction}}};
  const coilwright::actuator::Model model = coilwright::actuator::assemble_or_throw(design).model;
  coilwright::simulation::ModelInput input{.times = experiment.times};
  for (const double current : experiment.currents) input.currents.push_back(model.all_coils(current));
  const auto rest = coilwright::simulation::find_equilibrium(model, input.currents.front(), Eigen::Vector2d(0.5, 0.4));
  const auto theirs = coilwright::simulation::simulate(
      model, input, {.angles = rest.value(), .rates = Eigen::Vector2d::Zero()}, {.relative = 1e-9});
  int held = 0;
  for (std::size_t i = 0; i < ours.size(); ++i)
    for (const int j : {0, 1}) {
      EXPECT_NEAR(ours[i][j] / degree, theirs[i].angles[j] / degree, 2e-4) << experiment.times[i];
      held += theirs[i].rates[j] == 0.0 ? 1 : 0;
    }
  EXPECT_GT(held, 400);
  EXPECT_LT(held, 1600);
}

nlohmann::json reference(const std::string& name) {
  std::ifstream file(COILWRIGHT_TEST_DATA "/magnetics/" + name);
  return nlohmann::json::parse(file);
}

TEST(Truth, GivesTheExactTorqueInAnyPose) {
  const nlohmann::json poses = reference("noncoaxial.json");
  int rows = 0;
  for (const auto& row : poses.at("hinge")) {
    if (row.at("model") != "edge") continue;
    Pair pair;
    pair.axis_offset = row.at("h");
    pair.coil_offset = row.at("la");
    pair.magnet_offset = row.at("lb");
    const double angle = row.at("theta_deg").get<double>() * degree;
    constexpr double current = 1.4;  // of all rows
    // The torque of the reference is positive towards closing. The error of the quadrature near the hinge, where the
    // parts are 0.9 mm apart, is 1e-6 of the largest torque.
    EXPECT_NEAR(current * exact_torque(pair, angle), -row.at("torque_joint_exact").get<double>(), 2.5e-8) << angle;
    EXPECT_NEAR(current * line_of_centres_torque(pair, angle), -row.at("torque_joint_approx").get<double>(), 2.5e-8);
    ++rows;
  }
  EXPECT_EQ(rows, 12);
}

TEST(Truth, GivesTheForceOfThePapersShells) {
  const nlohmann::json pairs = reference("coaxial.json");
  int rows = 0;
  for (const auto& row : pairs.at("cases")) {
    if (row.at("kind") != "coil_magnet" || row.at("coil_model") != "edge") continue;
    const double z = row.at("z");
    const auto& coil = row.at("coil");
    const auto& magnet = row.at("magnet");
    const Pair pair{.inner_radius = coil.at("ri"),
                    .outer_radius = coil.at("ro"),
                    .coil_length = coil.at("l"),
                    .turns_radial = coil.at("Nr"),
                    .turns_axial = coil.at("Nz"),
                    .magnet_radius = magnet.at("R"),
                    .magnet_length = magnet.at("l"),
                    .remanence = magnet.at("J")};
    const double theirs = -row.at("Fz_on_2").get<double>() / coil.at("I").get<double>();
    // Not for parts that overlap or nearly touch: the quadrature is made for the gaps of the finger.
    if (z < 0.5 * (pair.coil_length + pair.magnet_length) + 0.3e-3 || pair.turns_radial < 2) continue;
    EXPECT_NEAR(coaxial_force(pair, z) / theirs, 1.0, 1e-6) << row.at("id");
    ++rows;
  }
  EXPECT_GT(rows, 3);
}

// The straight finger with its coils at the distance of the row.
TEST(Truth, GivesTheForceBetweenCoils) {
  const nlohmann::json pairs = reference("coaxial.json");
  int rows = 0;
  for (const auto& row : pairs.at("cases")) {
    if (!row.at("id").get<std::string>().starts_with("coil_coil/base_z") || row.at("coil_model") != "edge") continue;
    const auto inductance = [&](double distance) {
      Pair pair;
      pair.coil_offset = 0.5 * distance - pair.magnet_offset;
      return coil_coil_inductance(pair, 0.0, 0.0);
    };
    constexpr double h = 1e-4;
    const double z = row.at("z");
    const double ours = 1.4 * 1.4 * (inductance(z + h) - inductance(z - h)) / (2.0 * h);
    // 0.1 %: few loops, and shells are replaced by a distribution of the same variance.
    EXPECT_NEAR(ours / row.at("Fz_on_2").get<double>(), 1.0, 1e-3) << row.at("id");
    ++rows;
  }
  EXPECT_EQ(rows, 2);
}

}  // namespace
}  // namespace truth
