#include "coilwright/magnetics/axial_force.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <thread>
#include <vector>

#include "coilwright/magnetics/constants.hpp"
#include "filament_reference.hpp"
#include "magnetics/prototype.hpp"
#include "random_pairs.hpp"
#include "reference_cases.hpp"

namespace coilwright::magnetics {
namespace {

using testing::ThrowsMessage;

/// A current sheet is the magnet of remanence mu0 K.
CylinderMagnet sheet(double radius, double length, double surface_current) {
  return CylinderMagnet({.radius = radius, .length = length, .remanence = vacuum_permeability * surface_current});
}

double force_of(const nlohmann::json& c) {
  const std::string kind = c["kind"];
  const double z = c["z"];
  if (kind == "coil_magnet")
    return axial_force(reference::coil(c["coil"], c["coil_model"]), c["coil"]["I"], reference::magnet(c["magnet"]), z);
  if (kind == "magnet_magnet") return axial_force(reference::magnet(c["magnet1"]), reference::magnet(c["magnet2"]), z);
  if (kind == "coil_coil")
    return axial_force(reference::coil(c["coil1"], c["coil_model"]), c["coil1"]["I"],
                       reference::coil(c["coil2"], c["coil_model"]), c["coil2"]["I"], z);
  return axial_force(sheet(c["r1"], c["l1"], c["K1"]), sheet(c["r2"], c["l2"], c["K2"]), z);
}

// Golden values of an independent program (tests/data/magnetics_SOURCES.md), given to 2e-15, coil-coil to 1e-12.
TEST(AxialForce, AgreesWithTheIndependentReferenceInEveryCase) {
  const auto data = reference::load("coaxial.json");
  ASSERT_EQ(data["cases"].size(), 56U);
  for (const auto& c : data["cases"]) {
    const double expected = c["Fz_on_2"];
    const double relative = std::abs(force_of(c) / expected - 1.0);
    EXPECT_LT(relative, 1e-10) << c["id"];
  }
}

const ThickCoil other({.inner_radius = 4.1e-3,
                       .outer_radius = 7.3e-3,
                       .length = 8.7e-3,
                       .turns_radial = 9,
                       .turns_axial = 22,
                       .winding = CurrentDistribution::paper_shells});

// Second route: Maxwell's loops, Boost, adaptive quadrature, good to about 1e-11 where its long doubles do not cancel.
// Random sizes such as a search meets, from overlapping to 60 mm apart, magnet radius inside the winding or out.
TEST(AxialForce, AgreesWithLoopsIntegratedAdaptivelyOnRandomPairs) {
  random_pairs::Generator random(20260101);
  for (int i = 0; i < 12; ++i) {
    const ThickCoil coil = random_pairs::coil(random, CurrentDistribution::uniform);
    const CylinderMagnet target = random_pairs::magnet(random);
    const double z = random_pairs::log_uniform(random, 2e-3, 60e-3);
    const long double mean = filament_reference::thick_force(coil.inner_radius(), coil.outer_radius(), coil.length(),
                                                             target.radius(), target.length(), z);
    const double expected = static_cast<double>(mean * target.remanence() * coil.turns() / coil.length());
    EXPECT_NEAR(axial_force(coil, 1.0, target, z) / expected, 1.0, 1e-10)
        << "inner " << coil.inner_radius() << " outer " << coil.outer_radius() << " length " << coil.length()
        << " magnet " << target.radius() << " x " << target.length() << " at " << z;
  }
}

// Mirror and third law together: which of two coils is called the first cannot matter. One is uniform, the other made
// of shells, so that different rules meet; 1e-11 is ten times the error the radial rules are allowed.
TEST(AxialForce, DoesNotDependOnWhichCoilIsCalledTheFirst) {
  for (const double z : {-31e-3, 3.3e-3, 10.9e-3, 47e-3}) {
    const double forward = axial_force(prototype, 0.8, other, 1.3, z);
    EXPECT_NEAR(axial_force(other, 1.3, prototype, 0.8, z) / forward, 1.0, 1e-11) << z;
  }
}

TEST(AxialForce, IsOddInTheDistanceAndZeroAtTheCentre) {
  EXPECT_EQ(axial_force(prototype, 1.1, prototype_magnet, 0.0), 0.0);
  EXPECT_EQ(axial_force(prototype, 1.1, other, 0.7, 0.0), 0.0);
  for (const double z : {0.7e-3, 9.3e-3, 140e-3})
    EXPECT_DOUBLE_EQ(axial_force(prototype, 1.1, prototype_magnet, -z),
                     -axial_force(prototype, 1.1, prototype_magnet, z));
}

// F = -3 mu0 m1 m2 / (2 pi z^4) for two dipoles; finite sizes add terms of relative size (size / z)^2, here below
// 5 * (12 mm / 3 m)^2 = 8e-5.
TEST(AxialForce, BecomesThatOfTwoDipolesFarAway) {
  const double z = 3.0;
  const double r1 = 3e-3;
  const double r2 = 9.5e-3;
  const double coil_moment =
      prototype.turns() * std::numbers::pi * (r1 * r1 + r1 * r2 + r2 * r2) / 3.0;  // mean of r^2, per ampere
  const double magnet_moment = 1.44 / vacuum_permeability * std::numbers::pi * 10e-3 * 10e-3 * 6e-3;
  const double expected =
      -3.0 * vacuum_permeability * coil_moment * magnet_moment / (2.0 * std::numbers::pi * z * z * z * z);
  EXPECT_NEAR(axial_force(prototype, 1.0, prototype_magnet, z) / expected, 1.0, 8e-5);
}

// All lengths times s at the same remanence and turns: sheet current of the coil 1/s, of the magnet 1, area s^2.
// Two magnets: s^2. To rounding, times the cancellation of up to 500 that the closed form is allowed.
TEST(AxialForce, ScalesWithSizeAsTheFormulaSays) {
  const double s = 1.73;
  const ThickCoil large({.inner_radius = 3e-3 * s,
                         .outer_radius = 9.5e-3 * s,
                         .length = 12e-3 * s,
                         .turns_radial = 15,
                         .turns_axial = 30});
  const CylinderMagnet large_magnet({.radius = 10e-3 * s, .length = 6e-3 * s, .remanence = 1.44});
  EXPECT_NEAR(axial_force(large, 1.0, large_magnet, 11e-3 * s) / axial_force(prototype, 1.0, prototype_magnet, 11e-3),
              s, 1e-12);
  EXPECT_NEAR(
      axial_force(large_magnet, large_magnet, 11e-3 * s) / axial_force(prototype_magnet, prototype_magnet, 11e-3),
      s * s, 1e-12);
}

// The closed form gives way to loops where it cancels. A smooth force has smooth logarithms: on a grid of ratio 1.002
// the fifth difference of log|F| is below 1e-11 by itself, so it shows a jump or noise of 1e-10 / 32.
TEST(AxialForce, IsSmoothAcrossTheSwitchToLoops) {
  const CylinderMagnet small({.radius = 2e-3, .length = 2e-3, .remanence = 1.44});
  const CylinderMagnet flat({.radius = 11e-3, .length = 0.3e-3, .remanence = 1.1});
  const auto check = [](auto force) {
    std::vector<double> logs;
    for (double z = 12.5e-3; z < 0.6; z *= 1.002) logs.push_back(std::log(-force(z)));
    for (std::size_t i = 0; i + 5 < logs.size(); ++i) {
      const double fifth =
          logs[i + 5] - 5 * logs[i + 4] + 10 * logs[i + 3] - 10 * logs[i + 2] + 5 * logs[i + 1] - logs[i];
      ASSERT_LT(std::abs(fifth), 1e-10) << "at step " << i;
    }
  };
  check([&](double z) { return axial_force(small, small, z); });
  check([&](double z) { return axial_force(flat, small, z); });
  check([&](double z) { return axial_force(prototype, 1.0, prototype_magnet, z); });
  check([&](double z) { return axial_force(other, 1.0, flat, z); });
}

TEST(AxialForce, GivesTheSameBitsInABatchAndOnAnyThread) {
  std::vector<double> distances;
  for (double z = -20e-3; z < 60e-3; z += 0.77e-3) distances.push_back(z);
  std::vector<double> single(distances.size());
  for (std::size_t i = 0; i < distances.size(); ++i)
    single[i] = axial_force(other, 1.0, prototype_magnet, distances[i]);
  std::vector<std::vector<double>> batches(3, std::vector<double>(distances.size()));
  std::vector<std::thread> threads;
  for (auto& batch : batches)
    threads.emplace_back([&] { axial_force_per_ampere(other, prototype_magnet, distances, batch); });
  for (auto& thread : threads) thread.join();
  for (const auto& batch : batches) EXPECT_EQ(batch, single);
}

// One layer: the mean radius in both conventions of shells. Many layers: the sum over layer centres is a midpoint rule,
// whose error falls as 1 / layers^2, so by 16 from 8 to 32 layers (10 % for the next order).
TEST(AxialForce, OfLayerCentresTendsToThatOfUniformCurrent) {
  const auto coil = [](int layers, CurrentDistribution winding) {
    return ThickCoil({.inner_radius = 3e-3,
                      .outer_radius = 9.5e-3,
                      .length = 12e-3,
                      .turns_radial = layers,
                      .turns_axial = 30,
                      .winding = winding});
  };
  EXPECT_EQ(axial_force(coil(1, CurrentDistribution::paper_shells), 1.0, prototype_magnet, 9.9e-3),
            axial_force(coil(1, CurrentDistribution::layer_centres), 1.0, prototype_magnet, 9.9e-3));
  const auto error = [&](int layers) {
    return axial_force(coil(layers, CurrentDistribution::layer_centres), 1.0, prototype_magnet, 9.9e-3) /
               axial_force(coil(layers, CurrentDistribution::uniform), 1.0, prototype_magnet, 9.9e-3) -
           1.0;
  };
  EXPECT_NEAR(error(8) / error(32), 16.0, 1.6);
  // More shells than one block of the vector code holds.
  EXPECT_NEAR(error(32) / error(128), 16.0, 1.6);
}

// Over ten decades of size ratios, level faces and equal radii included, the force is finite and attracts.
TEST(AxialForce, IsFiniteAndAttractiveWhateverTheSizes) {
  random_pairs::Generator random(11);
  const auto length = [&] { return random_pairs::log_uniform(random, 1e-6, 10.0); };
  for (int i = 0; i < 20000; ++i) {
    const double inner = length();
    const double outer = inner * (1.0 + random_pairs::log_uniform(random, 1e-6, 1e3));
    const double height = length();
    const double radius = i % 3 == 0 ? inner : (i % 3 == 1 ? outer : length());
    const double thickness = i % 5 == 0 ? height : length();
    const double z = i % 2 == 0 ? 0.5 * (height + thickness) : length();
    const ThickCoil coil({.inner_radius = inner,
                          .outer_radius = outer,
                          .length = height,
                          .turns_radial = 1 + i % 20,
                          .turns_axial = 7,
                          .winding = i % 4 < 2 ? CurrentDistribution::uniform : CurrentDistribution::paper_shells});
    const double force =
        axial_force(coil, 1.0, CylinderMagnet({.radius = radius, .length = thickness, .remanence = 1.2}), z);
    ASSERT_TRUE(std::isfinite(force)) << i << " " << inner << " " << outer << " " << height << " " << radius << " "
                                      << thickness << " " << z;
  }
}

TEST(AxialForce, RefusesWhatIsNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT([&] { (void)axial_force(prototype_magnet, prototype_magnet, nan); },
              ThrowsMessage<std::invalid_argument>("distance must be finite; got nan"));
  EXPECT_THAT([&] { (void)axial_force(prototype, nan, prototype_magnet, 0.01); },
              ThrowsMessage<std::invalid_argument>("current must be finite; got nan"));
  EXPECT_THAT([&] { (void)axial_force(prototype, nan, other, 1.0, 0.01); },
              ThrowsMessage<std::invalid_argument>("first_current must be finite; got nan"));
  EXPECT_THAT([&] { (void)axial_force(prototype, 1.0, other, nan, 0.01); },
              ThrowsMessage<std::invalid_argument>("second_current must be finite; got nan"));
  const std::vector<double> three(3, 0.01);
  std::vector<double> two(2);
  EXPECT_THAT([&] { axial_force_per_ampere(prototype, prototype_magnet, three, two); },
              ThrowsMessage<std::invalid_argument>("forces must be as many as distances (3); got 2"));
}

}  // namespace
}  // namespace coilwright::magnetics
