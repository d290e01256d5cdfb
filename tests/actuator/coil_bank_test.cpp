#include "coilwright/actuator/coil_bank.hpp"

#include <gtest/gtest.h>

#include "actuator/paper_finger.hpp"
#include "error_text.hpp"

namespace coilwright::actuator {
namespace {

using drive::BankWiring;

constexpr double vacuum_permeability = 1.25663706212e-6;

TEST(CoilBank, HasTheResistanceOfEachCoilWhereItIsWarm) {
  const Design design = paper_finger();
  const Assembly assembly = assemble_or_throw(design);
  const drive::CoilBank bank = coil_bank(design, assembly, BankWiring::series, Eigen::Vector2d(20.0, 71.0));
  EXPECT_DOUBLE_EQ(bank.resistances[0], assembly.coil.resistance);
  EXPECT_NEAR(bank.resistances[1] / assembly.coil.resistance, (234.5 + 71.0) / 254.5, 1e-4);  // IEC 60028's other form
}

TEST(CoilBank, CouplesItsCoilsAsDipolesThatFarApart) {
  // A long magnet keeps the coils 114 mm apart: dipoles, to (R / d)^2 and (l / d)^2 of about 1 %.
  Design design = paper_finger();
  design.magnet.length = 0.1;
  const Assembly assembly = assemble_or_throw(design);
  const drive::CoilBank bank = coil_bank(design, assembly, BankWiring::series, Eigen::Vector2d::Constant(20.0));
  const Dimensions& size = assembly.dimensions;
  const double distance = 2.0 * (size.coil_half_pitch + size.magnet_half_pitch);
  const double R = size.coil_outer_radius, r = design.coil.inner_radius;
  const double moment = design.coil.turns_radial * design.coil.turns_axial * 3.14159265 * (R * R + R * r + r * r) / 3.0;
  const double dipoles = vacuum_permeability * moment * moment / (2.0 * 3.14159265 * distance * distance * distance);
  EXPECT_NEAR(bank.inductances(0, 1) / dipoles, 1.0, 0.01);
  EXPECT_EQ(bank.inductances(0, 1), bank.inductances(1, 0));
  EXPECT_EQ(bank.inductances(1, 1), assembly.coil.inductance);
}

TEST(CoilBank, TurnsTheSignOfTheCouplingWithAPolarity) {
  Design design = paper_finger();
  const Eigen::Vector2d cold = Eigen::Vector2d::Constant(20.0);
  const drive::CoilBank like = coil_bank(design, assemble_or_throw(design), BankWiring::series, cold);
  design.layout.back().polarity = -1;
  const drive::CoilBank unlike = coil_bank(design, assemble_or_throw(design), BankWiring::series, cold);
  EXPECT_GT(like.inductances(0, 1), 0.0);
  EXPECT_EQ(unlike.inductances(0, 1), -like.inductances(0, 1));
  EXPECT_LT(reduce(unlike).circuit.inductance, reduce(like).circuit.inductance);
}

TEST(CoilBank, WantsATemperatureForEachCoil) {
  const Design design = paper_finger();
  const Assembly assembly = assemble_or_throw(design);
  EXPECT_EQ(
      error_text([&] { (void)coil_bank(design, assembly, BankWiring::parallel, Eigen::Vector3d::Constant(20.0)); }),
      "temperatures: one a coil is needed, 2 here; got 3");
}

}  // namespace
}  // namespace coilwright::actuator
