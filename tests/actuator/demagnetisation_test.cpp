#include "coilwright/actuator/demagnetisation.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "actuator/paper_finger.hpp"
#include "coilwright/magnetics/constants.hpp"

namespace coilwright::actuator {
namespace {

Design graded(const char* grade, Configuration configuration = Configuration::B) {
  Design design = paper_finger();
  design.layout = layout_of(configuration);
  make_of_grade(design.magnet, grade);
  return design;
}

Demagnetisation at(const Design& design, const std::vector<double>& temperatures, double current) {
  return InnerFields(design, assemble_or_throw(design)).demagnetisation(temperatures, current);
}

// The audit of the physics: at 60 degC HcJ is 613 kA/m and the mean inner field of the prototype's disc 630 kA/m.
TEST(InnerFields, DemagnetiseThePrototypeAtSixtyDegrees) {
  const double margin = at(graded("N52"), {25.0, 60.0, 25.0}, 0.0).margin;
  EXPECT_NEAR(613.2 / (1.0 + margin), 630.0, 0.5);
  EXPECT_LT(margin, 0.0);
  EXPECT_GT(at(graded("N52"), {25.0, 55.0, 25.0}, 0.0).margin, 0.0);
  EXPECT_GT(at(graded("N42SH"), {25.0, 100.0, 25.0}, 0.0).margin, 0.3);
}

// Beyond the coercivity the margin is what of the field the magnet does not stand: one slope where the two meet (near
// 57.5 degC), down to -1 where no coercivity is left.
TEST(InnerFields, FallOnWhereTheMagnetIsLost) {
  const InnerFields fields(graded("N52"), assemble_or_throw(graded("N52")));
  const auto margin = [&](double temperature) {
    return fields.demagnetisation(std::vector<double>{25.0, temperature, 25.0}, 0.0).margin;
  };
  double zero = 50.0;
  for (double hot = 70.0; hot - zero > 1e-9;) {
    const double middle = (zero + hot) / 2.0;
    (margin(middle) > 0.0 ? zero : hot) = middle;
  }
  constexpr double step = 1e-3;  // degC: the curvature adds a hundred-thousandth of the slope
  EXPECT_NEAR((margin(zero) - margin(zero - step)) / (margin(zero + step) - margin(zero)), 1.0, 1e-3);
  for (double temperature = 60.0; temperature < 145.0; temperature += 10.0)
    EXPECT_LT(margin(temperature + 10.0), margin(temperature)) << temperature;
  EXPECT_EQ(margin(400.0), -1.0);
}

// The same audit: discs of 1 mm lose at 20 degC.
TEST(InnerFields, DemagnetiseAThinDiscInTheCold) {
  Design design = graded("N52");
  design.magnet.length = 1e-3;
  EXPECT_LT(at(design, {20.0, 20.0, 20.0}, 0.0).margin, 0.0);
}

// Without current and neighbours both figures have a closed form: N and 1 - L / (2 sqrt(L^2 + R^2)) times M.
TEST(InnerFields, AreTheMagnetsOwnWhereNothingElseIs) {
  const Design design = graded("N48");
  constexpr double temperature = 37.0;
  const double coercivity = 955e3 * (1.0 - 0.0075 * 17.0);
  const Demagnetisation found = at(design, {20.0, temperature, 20.0}, 0.0);
  const double magnetisation = design.magnet.polarisation() * (1.0 - 0.0012 * 17.0) / magnetics::vacuum_permeability;
  const double shape = magnetics::demagnetisation_factor({.radius = 10e-3, .length = 6e-3});
  EXPECT_NEAR(found.margin, 1.0 - shape * magnetisation / coercivity, 1e-12);
  EXPECT_NEAR(found.margin_worst_point, 1.0 - 0.742752 * magnetisation / coercivity, 1e-6);
}

// Two coils at 1.4 A: the mean of a coil's field, by the far side's closed form of the room below, twice; either sign.
TEST(InnerFields, CountTheCoilsByTheWorseSignOfTheirCurrent) {
  const Design design = graded("N52");
  const std::vector<double> warm{20.0, 30.0, 20.0};
  const Demagnetisation idle = at(design, warm, 0.0);
  const Demagnetisation on = at(design, warm, 1.4);
  EXPECT_LT(on.margin, idle.margin);
  EXPECT_LT(on.margin_worst_point, idle.margin_worst_point);
  EXPECT_EQ(on.margin, at(design, warm, -1.4).margin);
  const double coercivity = 876e3 * (1.0 - 0.0075 * 10.0);
  // 4.93 kA/m a coil, of which recoil passes on 1 / (1 + chi N).
  EXPECT_NEAR((idle.margin - on.margin) * coercivity, 2.0 * 4.93e3 * 0.9711, 0.03 * 2.0 * 4.93e3);
  // Coils that face each other cancel on the magnet between them.
  Design opposed = design;
  opposed.layout.back().polarity = -1;
  EXPECT_NEAR(at(opposed, warm, 1.4).margin, idle.margin, 1e-12);
}

// Magnets that attract hold each other's field up; those that repel press it down.
TEST(InnerFields, CountNeighbouringMagnets) {
  Design pulling = graded("N52", Configuration::C);
  Design pushing = pulling;
  pushing.layout[3].polarity = -1;
  const std::vector<double> cool(5, 20.0);
  const double alone = at(graded("N52"), {20.0, 20.0, 20.0}, 0.0).margin;
  const double helped = at(pulling, cool, 0.0).margin;
  const double pressed = at(pushing, cool, 0.0).margin;
  EXPECT_GT(helped, alone);
  EXPECT_LT(pressed, alone);
  EXPECT_NEAR(helped - alone, alone - pressed, 1e-12);
  // The hotter of two is the worse, and a hot neighbour helps less.
  EXPECT_LT(at(pulling, {20.0, 20.0, 20.0, 50.0, 20.0}, 0.0).margin, helped);
}

TEST(InnerFields, SayWhatTheyNeed) {
  const Design plain = paper_finger();
  EXPECT_EQ(error_text([&] { (void)InnerFields(plain, assemble_or_throw(plain)); }),
            "magnets without a grade, or a coercivity and its coefficient, have no coercivity");
  EXPECT_EQ(error_text([&] {
              (void)at(graded("N52"), {20.0, 20.0}, 0.0);
            }),
            "temperatures: one per component, 3 here; got 2");
}

// A maker's sheet in place of a grade: the numbers alone decide, and the loss is that of the room below with the curve
// made by hand. 20 % more of HcJ, a rounder knee and another slope of both in the heat.
TEST(InnerFields, TakeTheNumbersThatADesignStates) {
  Design stated = paper_finger();
  stated.magnet.coercivity = 1050e3;
  stated.magnet.coercivity_coefficient = -0.0065;
  stated.magnet.remanence_coefficient = -0.0010;
  stated.magnet.recoil_permeability = 1.03;
  stated.magnet.squareness = 0.91;
  constexpr double temperature = 90.0;
  const Demagnetisation found = at(stated, {20.0, temperature, 20.0}, 0.0);
  const magnetics::CylinderSize size{.radius = 10e-3, .length = 6e-3};
  const magnetics::DemagnetisationCurve curve{
      .magnetisation = 1.44 * (1.0 - 0.0010 * 70.0) / magnetics::vacuum_permeability,
      .coercivity = 1050e3 * (1.0 - 0.0065 * 70.0),
      .susceptibility = 0.03,
      .squareness = 0.91};
  EXPECT_NEAR(found.irreversible_loss, magnetics::irreversible_loss(size, curve, {}), 1e-12);
  EXPECT_GT(found.irreversible_loss, 0.1);
  const double shape = magnetics::demagnetisation_factor(size);
  const double field = shape * curve.magnetisation / (1.0 + 0.03 * shape);
  EXPECT_NEAR(1.0 + found.margin, field < curve.coercivity ? 2.0 - field / curve.coercivity : curve.coercivity / field,
              1e-12);
  // A rounder knee begins to lose where a square one keeps all.
  Design round = graded("N52");
  const std::vector<double> cool(3, 20.0);
  EXPECT_EQ(at(round, cool, 0.0).irreversible_loss, 0.0);
  round.magnet.squareness = 0.85;
  EXPECT_GT(at(round, cool, 0.0).irreversible_loss, 0.005);
}

// A coercivity without its coefficient would promise in the heat what is known of the cold.
TEST(InnerFields, AreOfMagnetsWhoseCoercivityIsKnownInTheHeat) {
  MagnetDesign magnet;
  magnet.coercivity = 955e3;
  EXPECT_FALSE(magnet.has_coercivity());
  magnet.coercivity_coefficient = -0.006;
  EXPECT_TRUE(magnet.has_coercivity());
}

// Strengths scale the curves that are there: the same torques, to rounding, as those of magnets with that remanence.
TEST(MagnetStrengths, ScaleTheCurvesInsteadOfBuildingThemAnew) {
  const Design design = graded("N52", Configuration::C);
  const std::vector<double> hot(5, 75.0);
  const std::vector<double> strengths = magnet_strengths(design, hot);
  ASSERT_EQ(strengths.size(), 2u);
  EXPECT_NEAR(strengths[0], 1.0 - 0.0012 * 55.0, 1e-15);
  const Assembly cold = assemble_or_throw(design);
  Design weaker = design;
  weaker.magnet.remanence *= strengths[0];
  const Assembly rebuilt = assemble_or_throw(weaker);
  const mechanics::JointVector angles{{0.3, 0.1, 0.45, 0.2}};
  const CoilCurrents currents = cold.model.all_coils(0.9);
  const mechanics::JointVector scaled = cold.model.with_magnet_strengths(strengths).magnetic_torques(angles, currents);
  const mechanics::JointVector expected = rebuilt.model.magnetic_torques(angles, currents);
  EXPECT_LT((scaled - expected).norm(), 1e-12 * expected.norm());
  // The magnets' own pull goes with the square.
  const CoilCurrents off = cold.model.all_coils(0.0);
  const mechanics::JointVector pull = cold.model.with_magnet_strengths(strengths).magnetic_torques(angles, off);
  const mechanics::JointVector before = strengths[0] * strengths[0] * cold.model.magnetic_torques(angles, off);
  EXPECT_GT(pull.norm(), 0.0);
  EXPECT_LT((pull - before).norm(), 1e-12 * pull.norm());
}

TEST(MagnetStrengths, AreOneWithoutAGrade) {
  EXPECT_EQ(magnet_strengths(paper_finger(), std::vector<double>{20.0, 90.0, 20.0}), std::vector<double>{1.0});
}

}  // namespace
}  // namespace coilwright::actuator
