#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include "actuator/paper_finger.hpp"
#include "coilwright/actuator/assemble.hpp"

namespace coilwright::actuator {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

using Change = std::function<void(Design&)>;

ConstructionFaults faults_after(const Change& change) {
  Design design = paper_geometry();
  change(design);
  return construction_faults(design);
}

// All rules that one change breaks, joined.
std::string rules_after(const Change& change) {
  std::string all;
  for (const ConstructionFault& fault : faults_after(change)) all += (all.empty() ? "" : " | ") + fault.rule;
  return all;
}

TEST(ConstructionFaults, AreNoneForThePrototype) {
  EXPECT_EQ(rules_after([](Design&) {}), "");
}

TEST(ConstructionFaults, NameEverySizeThatIsNotPositive) {
  const auto expect = [](const Change& change, const std::string& rule) { EXPECT_EQ(rules_after(change), rule); };
  expect([](Design& d) { d.coil.inner_radius = -2.5e-3; },
         "coil inner radius must be from 0.05 to 1000 mm; got -2.5 mm");
  expect([](Design& d) { d.magnet.radius = 0.0; }, "magnet radius must be from 0.05 to 1000 mm; got 0 mm");
  expect([](Design& d) { d.magnet.length = infinity; }, "magnet length must be from 0.05 to 1000 mm; got inf mm");
  expect([](Design& d) { d.magnet.remanence = not_a_number; }, "remanence must be finite and > 0; got nan T");
  expect([](Design& d) { d.magnet.remanence = 14.4; },
         "remanence must be at most 2 T, which no magnet reaches; got 14.4 T");
  expect([](Design& d) { d.magnet.density = -7.0; }, "magnet density must be finite and > 0; got -7 kg/m3");
  expect([](Design& d) { d.magnet.coercivity = 875.0; }, "coercivity in kA/m must lie in 10 to 5000; got 0.875");
  expect([](Design& d) { d.magnet.remanence_coefficient = -0.12; },
         "remanence coefficient in %/K must lie in -2 to 2; got -12");
  expect([](Design& d) { d.magnet.coercivity_coefficient = not_a_number; },
         "coercivity coefficient in %/K must lie in -2 to 2; got nan");
  expect([](Design& d) { d.magnet.recoil_permeability = 0.97; }, "recoil permeability must lie in 1 to 1.2; got 0.97");
  expect([](Design& d) { d.magnet.squareness = 1.0; }, "squareness must lie in 0.6 to 0.99; got 1");
  expect([](Design& d) { d.body.gap = -0.3e-3; }, "gap must be from 0.05 to 1000 mm; got -0.3 mm");
  expect([](Design& d) { d.body.bottom_layer = 0.0; }, "bottom layer must be from 0.05 to 1000 mm; got 0 mm");
  expect([](Design& d) { d.body.side_wall = -1e-3; }, "side wall must be from 0.05 to 1000 mm; got -1 mm");
  expect([](Design& d) { d.body.bottom_wall = 0.0; }, "bottom wall must be from 0.05 to 1000 mm; got 0 mm");
  expect([](Design& d) { d.body.top_wall = 0.0; }, "top wall must be from 0.05 to 1000 mm; got 0 mm");
  expect([](Design& d) { d.body.front_length = 0.0; }, "front length must be from 0.05 to 1000 mm; got 0 mm");
  expect([](Design& d) { d.body.rear_length = 0.0; }, "rear length must be from 0.05 to 1000 mm; got 0 mm");
  expect([](Design& d) { d.body.hinge_length = 0.0; }, "hinge length must be from 0.05 to 1000 mm; got 0 mm");
  expect([](Design& d) { d.body.loss_time = -4e-3; }, "loss time must be finite and >= 0; got -4 ms");
  expect([](Design& d) { d.body.slot_width = -0.2e-3; }, "slot width must be finite and >= 0; got -0.2 mm");
  expect([](Design& d) { d.body.poisson_ratio = 0.52; }, "Poisson's ratio must lie in 0 to 0.5; got 0.52");
  expect([](Design& d) { d.body.loss_factor = -0.1; }, "loss factor must be finite and >= 0; got -0.1");
  expect([](Design& d) { d.body.constant_damping = infinity; },
         "constant damping must be finite and >= 0; got inf N mm s/rad");
  expect([](Design& d) { d.body.density = 0.0; }, "silicone density must be finite and > 0; got 0 kg/m3");
  expect([](Design& d) { d.body.heat_capacity = 0.0; },
         "silicone heat capacity must be finite and > 0; got 0 J/(kg K)");
  expect([](Design& d) { d.body.conductivity = 0.0; }, "silicone conductivity must be finite and > 0; got 0 W/(m K)");
  expect([](Design& d) { d.surroundings.heat_transfer = 0.0; }, "heat transfer must be finite and > 0; got 0 W/(m2 K)");
}

TEST(ConstructionFaults, NameTurnsThatNobodyWinds) {
  EXPECT_EQ(rules_after([](Design& d) { d.coil.turns_radial = 0; }), "turns_radial must be at least 1; got 0");
  EXPECT_EQ(rules_after([](Design& d) { d.coil.turns_axial = std::numeric_limits<int>::min(); }),
            "turns_axial must be at least 1; got -2147483648");
  EXPECT_EQ(rules_after([](Design& d) {
              d.coil.turns_radial = std::numeric_limits<int>::max();
              d.coil.turns_axial = 10'001;
            }),
            "turns_radial must be at most 10000; got 2147483647 | turns_axial must be at most 10000; got 10001");
}

TEST(ConstructionFaults, NameWireThatIsNoneOrDoesNotGoRoundItsBore) {
  EXPECT_EQ(rules_after([](Design& d) { d.coil.wire_gauge = 9; }), "wire gauge must be AWG 10 to 50; got 9");
  EXPECT_EQ(rules_after([](Design& d) { d.coil.wire_gauge = 51; }), "wire gauge must be AWG 10 to 50; got 51");
  EXPECT_EQ(rules_after([](Design& d) { d.coil.wire_diameter = 6e-3; }),
            "wire diameter must be 0.018 to 5 mm; got 6 mm");
  EXPECT_EQ(rules_after([](Design& d) { d.coil.wire_diameter = not_a_number; }),
            "wire diameter must be 0.018 to 5 mm; got nan mm");
  EXPECT_EQ(rules_after([](Design& d) { d.coil.wire_overall = 0.3e-3; }),
            "wire over its enamel must be thicker than its copper, 0.3226 mm at most; got 0.3 mm");
  EXPECT_EQ(rules_after([](Design& d) {
              d.coil.wire_diameter = 1e-3;
              d.coil.inner_radius = 1.5e-3;
            }),
            "coil inner radius must be at least 1.593 mm for 1 mm; got 1.5 mm");
  // 1.5 insulated diameters of 0.3556 mm.
  EXPECT_EQ(rules_after([](Design& d) { d.coil.inner_radius = 0.5e-3; }),
            "coil inner radius must be at least 0.5334 mm for AWG 28; got 0.5 mm");
}

TEST(ConstructionFaults, NameMaterialsAndSurroundingsOutsideTheirRange) {
  EXPECT_EQ(rules_after([](Design& d) { d.body.shore_hardness = 81.5; }),
            "shore hardness must lie in 20 to 80; got 81.5");
  EXPECT_EQ(rules_after([](Design& d) { d.body.shore_hardness = not_a_number; }),
            "shore hardness must lie in 20 to 80; got nan");
  EXPECT_EQ(rules_after([](Design& d) { d.body.shore_hardness_00 = 80.0; }),
            "shore 00 hardness must lie in 10 to 70; got 80");
  EXPECT_EQ(rules_after([](Design& d) { d.body.young_modulus = 1.0; }),
            "Young's modulus in MPa must lie in 0.001 to 100; got 1e-06");
  EXPECT_EQ(rules_after([](Design& d) {
              d.bottom_silicone = d.body;
              d.bottom_silicone->density = -1.0;
            }),
            "bottom layer's silicone density must be finite and > 0; got -1 kg/m3");
  EXPECT_EQ(rules_after([](Design& d) { d.surroundings.gravity = -9.81; }),
            "gravity must lie in 0 to 100 m/s2; got -9.81");
  EXPECT_EQ(rules_after([](Design& d) { d.surroundings.gravity = 9810.0; }),
            "gravity must lie in 0 to 100 m/s2; got 9810");
  EXPECT_EQ(rules_after([](Design& d) { d.surroundings.base_tilt = infinity; }),
            "base tilt must be finite; got inf rad");
  EXPECT_EQ(rules_after([](Design& d) { d.surroundings.ambient = 250.0; }),
            "ambient must lie in -50 to 200 degC; got 250");
  EXPECT_EQ(rules_after([](Design& d) { d.surroundings.coil_limit = not_a_number; }),
            "coil temperature limit must be finite; got nan degC");
  EXPECT_EQ(rules_after([](Design& d) { d.magnet.temperature_limit = infinity; }),
            "magnet temperature limit must be finite; got inf degC");
}

TEST(ConstructionFaults, NameEveryCalibrationFactorThatIsNone) {
  const auto expect = [](double Calibration::*factor, const std::string& name) {
    EXPECT_EQ(rules_after([&](Design& d) { d.calibration.*factor = -0.5; }),
              "calibration factor of " + name + " must be finite and > 0; got -0.5");
  };
  expect(&Calibration::axial_pitch, "axial pitch");
  expect(&Calibration::radial_pitch, "radial pitch");
  expect(&Calibration::joint_stiffness, "joint stiffness");
  expect(&Calibration::joint_damping, "joint damping");
  EXPECT_EQ(rules_after([](Design& d) { d.calibration.constant_damping = -0.5; }),
            "calibration factor of constant damping must be finite and >= 0; got -0.5");
  expect(&Calibration::axis_offset, "axis offset");
  expect(&Calibration::magnet_segment_mass, "magnet segment mass");
  expect(&Calibration::coil_segment_mass, "coil segment mass");
  expect(&Calibration::tip_com, "tip centre of mass");
  expect(&Calibration::coil_resistance, "coil resistance");
  expect(&Calibration::heat_transfer, "heat transfer");
}

TEST(ConstructionFaults, NameAPitchBelowAnyPackingAndAnAxisInsideTheParts) {
  EXPECT_EQ(rules_after([](Design& d) { d.calibration.axial_pitch = 0.5; }),
            "packing.axial: must be finite and >= 1 (turns of a layer do not overlap); got 0.562429696287964");
  // h = 11.5 mm * 0.8, below the 10 mm of the magnet.
  EXPECT_EQ(rules_after([](Design& d) { d.calibration.axis_offset = 0.8; }),
            "hinge axis must lie below the parts, more than 10 mm from their centre; got 9.2 mm");
}

TEST(ConstructionFaults, NameALayoutThatIsNone) {
  EXPECT_EQ(rules_after([](Design& d) { d.layout.pop_back(), d.layout.pop_back(); }),
            "layout must have 2 to 17 components; got 1");
}

// A search is led back to what can be built by how far off it is.
TEST(ConstructionFaults, GrowWithTheDistanceFromWhatCanBeBuilt) {
  const auto excess = [](const Change& change) { return faults_after(change).front().excess; };
  const double near = excess([](Design& d) { d.coil.inner_radius = 0.5e-3; });
  const double far = excess([](Design& d) { d.coil.inner_radius = 0.3e-3; });
  EXPECT_GT(near, 0.0);
  EXPECT_GT(far, near);
  EXPECT_GT(excess([](Design& d) { d.body.gap = -2e-3; }), excess([](Design& d) { d.body.gap = -1e-3; }));
  EXPECT_GT(excess([](Design& d) { d.coil.wire_gauge = 55; }), excess([](Design& d) { d.coil.wire_gauge = 51; }));
}

TEST(Assemble, ReturnsTheMisfitsAndItsTwinThrowsTheFirst) {
  Design design = paper_geometry();
  design.body.gap = not_a_number;
  design.coil.turns_axial = 0;
  const auto result = assemble(design);
  ASSERT_TRUE(std::holds_alternative<ConstructionFaults>(result));
  EXPECT_EQ(std::get<ConstructionFaults>(result).size(), 2U);
  EXPECT_EQ(error_text([&] { (void)assemble_or_throw(design); }), "turns_axial must be at least 1; got 0");
}

// Shapes that no rule foresees come back as a fault too, in the words of the formula they are too extreme for.
TEST(Assemble, RefusesShapesOutsideItsFormulas) {
  Design pancake = paper_geometry();
  pancake.coil = {.inner_radius = 3e-3, .turns_radial = 10'000, .turns_axial = 1, .wire_gauge = 40};
  const auto result = assemble(pancake);
  ASSERT_TRUE(std::holds_alternative<ConstructionFaults>(result));
  EXPECT_THAT(std::get<ConstructionFaults>(result).front().rule,
              testing::StartsWith("shape too extreme to compute: length: must be between 1e-4 and 1e4 outer radii"));
}

bool all_finite(const Assembly& a) {
  const Dimensions& d = a.dimensions;
  bool finite = std::isfinite(a.mass() + a.rest_force_per_ampere + a.coil.inductance + a.coil.resistance +
                              d.coil_outer_radius + d.axis_offset + d.tip_length + d.closing_angle);
  for (const Segment& s : a.segments)
    finite = finite && std::isfinite(s.mass + s.com_along + s.com_offset + s.inertia + s.heat_capacity) && s.mass > 0.0;
  for (const Hinge& h : a.model.hinges())
    finite = finite && std::isfinite(h.stiffness + h.damping + h.contact.stiffness + h.contact.damping);
  return finite;
}

// Whatever is written down, assemble answers: a model of finite numbers or rules that are broken.
TEST(Assemble, NeverThrowsWhateverTheDesign) {
  std::mt19937 random(20240607);
  const auto pick = [&](double value) {
    std::uniform_real_distribution<double> decades(-4.0, 4.0);
    switch (random() % 40) {
      case 0:
        return not_a_number;
      case 1:
        return infinity;
      case 2:
        return -value;
      case 3:
        return 0.0;
      case 4:
        return std::numeric_limits<double>::denorm_min();
      case 5:
        return std::numeric_limits<double>::max();
      case 6:
        return value * std::pow(10.0, decades(random));
      default:
        return value * std::pow(10.0, 0.1 * decades(random));
    }
  };
  const auto pick_int = [&](int value) {
    const int extremes[] = {0, 1, -1, std::numeric_limits<int>::max(), std::numeric_limits<int>::min(), 65536, 10'000};
    if (random() % 20 == 0) return extremes[random() % 7];
    return static_cast<int>(random() % static_cast<unsigned>(2 * value)) + 1;
  };
  int built = 0;
  for (int i = 0; i < 3000; ++i) {
    Design d = paper_geometry();
    d.layout = layout_of(static_cast<Configuration>(random() % 4));
    d.coil = {.inner_radius = pick(3e-3),
              .turns_radial = pick_int(15),
              .turns_axial = pick_int(30),
              .wire_gauge = random() % 20 == 0 ? pick_int(30) : 20 + static_cast<int>(random() % 21)};
    d.magnet.radius = pick(10e-3);
    d.magnet.length = pick(6e-3);
    d.magnet.remanence = pick(1.44);
    d.body.gap = pick(0.9e-3);
    d.body.bottom_layer = pick(2.5e-3);
    d.body.front_length = pick(8.6e-3);
    d.calibration.axis_offset = random() % 10 == 0 ? pick(1.0) : 1.0;
    const auto result = assemble(d);
    if (const auto* assembly = std::get_if<Assembly>(&result)) {
      ++built;
      ASSERT_TRUE(all_finite(*assembly)) << "design " << i;
    } else {
      const ConstructionFaults& broken = std::get<ConstructionFaults>(result);
      ASSERT_FALSE(broken.empty());
      for (const ConstructionFault& fault : broken) {
        ASSERT_FALSE(fault.rule.empty());
        ASSERT_GT(fault.excess, 0.0) << fault.rule;
      }
    }
  }
  EXPECT_GT(built, 200);  // or the test would test nothing but refusals
}

}  // namespace
}  // namespace coilwright::actuator
