#include <gtest/gtest.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <vector>

#include "coilwright/thermal/chain.hpp"
#include "coilwright/thermal/steady_state.hpp"
#include "error_text.hpp"
#include "thermal/sample_networks.hpp"

namespace coilwright::thermal {
namespace {

// With two coils alike, and another film.
HeatChain finger(double film) {
  HeatChain out = prototype_finger();
  out.heat_transfer = film;
  out.segments.back() = out.segments.front();
  return out;
}

// A core in the section of a body, its surface at 1 and the air at 0: the temperature in squares of `cell`, heat by
// differences of neighbours. Gives the hottest place of the outer surface.
double hottest_surface(const HeatChain& chain, double core_radius, double cell = 0.25e-3) {
  const double below = chain.axis_offset + 0.5 * chain.hinge_layer;
  const int columns = static_cast<int>(std::lround(chain.width / cell));
  const int rows = static_cast<int>(std::lround(chain.height / cell));
  const auto x = [&](int i) { return (i + 0.5) * cell - 0.5 * chain.width; };
  const auto y = [&](int j) { return (j + 0.5) * cell - below; };
  const double conductivity = chain.silicone_conductivity;
  std::vector<int> place(static_cast<std::size_t>(columns * rows), -1);
  int count = 0;
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j)
      if (std::hypot(x(i), y(j)) > core_radius) place[static_cast<std::size_t>(i * rows + j)] = count++;
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd heat = Eigen::VectorXd::Zero(count);
  const auto add = [&](int here, double conductance) { entries.emplace_back(here, here, conductance); };
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j) {
      const int here = place[static_cast<std::size_t>(i * rows + j)];
      if (here < 0) continue;
      for (const auto& [di, dj] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
        const int p = i + di;
        const int q = j + dj;
        if (p < 0 || p >= columns || q < 0 || q >= rows) {
          add(here, 1.0 / (0.5 / conductivity + 1.0 / (chain.heat_transfer * cell)));
          continue;
        }
        const int there = place[static_cast<std::size_t>(p * rows + q)];
        if (there >= 0) {
          add(here, conductivity);
          entries.emplace_back(here, there, -conductivity);
          continue;
        }
        // To the circle along the line of the two centres.
        const double other = di == 0 ? x(i) : y(j);
        const double along = std::sqrt(std::max(0.0, core_radius * core_radius - other * other));
        const double gap = std::max(0.1 * cell, std::abs(std::abs(di == 0 ? y(j) : x(i)) - along));
        add(here, conductivity * cell / gap);
        heat[here] += conductivity * cell / gap;
      }
    }
  }
  Eigen::SparseMatrix<double> matrix(count, count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::VectorXd warm = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(heat);
  double hottest = 0.0;
  const auto see = [&](int i, int j) {
    const double inside = 2.0 * conductivity / cell;
    const int here = place[static_cast<std::size_t>(i * rows + j)];
    if (here >= 0) hottest = std::max(hottest, warm[here] * inside / (inside + chain.heat_transfer));
  };
  for (int i = 0; i < columns; ++i) see(i, 0), see(i, rows - 1);
  for (int j = 0; j < rows; ++j) see(0, j), see(columns - 1, j);
  return hottest;
}

// Rise of the skin over that of cores and silicone, all of which are as warm: then a core's surface is, too.
double skin_over_core(const HeatChain& chain) {
  const NodeVector warm = NodeVector::Constant(build_network(chain).size(), chain.ambient + 100.0);
  return (skin_temperature(chain, warm) - chain.ambient) / 100.0;
}

// Beside the magnet, whose wall is thinner than the coils'. The cells err by some tenths of a per cent.
TEST(SkinTemperature, IsThatOfFiniteDifferencesWhereWallsAreThin) {
  for (const double film : {18.0, 50.0, 155.8}) {
    const HeatChain chain = finger(film);
    EXPECT_NEAR(skin_over_core(chain) / hottest_surface(chain, 10e-3), 1.0, 0.01) << film;
  }
}

// In thick walls heat turns towards the nearest surface, which the law leaves out.
TEST(SkinTemperature, OfThickWallsIsSomePerCentLow) {
  HeatChain chain = finger(50.0);
  chain.width = 34e-3;
  chain.height = 36e-3;
  chain.axis_offset = 17e-3;
  const double excess = skin_over_core(chain) / hottest_surface(chain, 10e-3) - 1.0;
  EXPECT_LT(excess, -0.02);
  EXPECT_GT(excess, -0.06);
}

TEST(SkinTemperature, LiesBetweenTheAirAndTheCoilAndRisesWithTheCurrent) {
  const HeatChain chain = finger(50.0);
  const Network network = build_network(chain);
  double before = chain.ambient;
  for (const double current : {0.3, 0.5, 0.7}) {
    const SteadyState state = steady_state(network, same_in_every_coil(network, current * current));
    const double skin = skin_temperature(chain, state.temperatures);
    EXPECT_GT(skin, before);
    EXPECT_LT(skin, state.temperatures.maxCoeff());
    before = skin;
  }
  // Mean of what the surface sheds over film and area is below its hottest place.
  const SteadyState state = steady_state(network, same_in_every_coil(network, 0.49));
  const double area = 2.0 * (chain.width + chain.height) * (2 * 12.6e-3 + 7.2e-3 + 40e-3);
  EXPECT_LT(chain.ambient + state.heat.sum() / (50.0 * area), before);
}

TEST(SkinTemperature, SeesABottomLayerOfAnotherSilicone) {
  HeatChain chain = finger(50.0);
  const double one = skin_over_core(chain);
  chain.bottom = BottomLayer{.conductivity = 0.2, .heat_capacity = 1130.0 * 1300.0};
  EXPECT_NEAR(skin_over_core(chain), one, 1e-12);  // the same silicone is no other
  const Network same = build_network(chain);
  chain.bottom.reset();
  const Network plain = build_network(chain);
  EXPECT_LT((same.conductance() - plain.conductance()).norm(), 1e-12 * plain.conductance().norm());
  // Under a body whose other walls are thicker the underside is the warmest: the better its layer conducts, the more.
  chain.axis_offset = 10.5e-3;
  chain.height = 26e-3;
  chain.width = 26e-3;
  double before = 0.0;
  for (const double conductivity : {0.1, 0.2, 0.4, 1.0}) {
    chain.bottom = BottomLayer{.conductivity = conductivity, .heat_capacity = 1130.0 * 1300.0};
    const double skin = skin_over_core(chain);
    EXPECT_GT(skin, before) << conductivity;
    before = skin;
  }
}

TEST(SkinTemperature, WantsATemperatureForEachNode) {
  EXPECT_EQ(error_text([] { (void)skin_temperature(finger(50.0), NodeVector::Constant(3, 25.0)); }),
            "temperatures: must be 8 in number; got 3");
}

}  // namespace
}  // namespace coilwright::thermal
