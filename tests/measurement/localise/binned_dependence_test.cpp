#include "measurement/localise/binned_dependence.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "measurement/random_numbers.hpp"

namespace coilwright::measurement::localise {
namespace {

SampleBlocks blocks_of(std::size_t count, std::size_t size) {
  SampleBlocks blocks;
  for (std::size_t i = 0; i < count; ++i) blocks.number.push_back(i / size);
  return blocks;
}

TEST(BinnedDependence, ExplainsNothingOfNoise) {
  for (int seed = 1; seed <= 20; ++seed) {
    Normal normal(seed);
    std::vector<double> variable, torque;
    for (int i = 0; i < 2000; ++i) {
      variable.push_back(normal());
      torque.push_back(normal());
    }
    EXPECT_LT(binned_dependence("x", variable, torque, blocks_of(2000, 20)).explained, 0.01);
  }
}

TEST(BinnedDependence, ExplainsAFunctionOfTheVariable) {
  Normal normal(1);
  std::vector<double> variable, torque;
  for (int i = 0; i < 4000; ++i) {
    variable.push_back(2.0 * normal.uniform() - 1.0);
    torque.push_back(variable.back() * variable.back() + 0.1 * normal());
  }
  const Dependence found = binned_dependence("x", variable, torque, blocks_of(4000, 20));
  EXPECT_EQ(found.variable, "x");
  ASSERT_EQ(found.at.size(), 20u);
  // x^2 has variance 1/3 * 4/15 = 0.0889, the noise 0.01; bins of 0.1 leave 0.1^2 / 12 * E(4 x^2) = 0.0011 inside.
  EXPECT_NEAR(found.explained, 1.0 - (0.01 + 0.0011) / 0.0989, 0.02);
  for (std::size_t b = 0; b < 20; ++b) {
    EXPECT_NEAR(found.at[b], -0.95 + 0.1 * static_cast<double>(b), 0.06);  // a quantile of 4000: 0.016
    EXPECT_NEAR(found.residual[b], found.at[b] * found.at[b], 0.03);       // 200 samples: 0.007
  }
}

TEST(BinnedDependence, HasOneBinPerValueIfThereAreFew) {
  const std::vector<double> variable{1, 1, 3, 3, 1, 1, 3, 3};
  const std::vector<double> torque{5, 5, 9, 9, 5, 5, 9, 9};
  const Dependence found = binned_dependence("x", variable, torque, blocks_of(8, 4));
  EXPECT_EQ(found.at, (std::vector<double>{1, 3}));
  EXPECT_EQ(found.residual, (std::vector<double>{5, 9}));
  EXPECT_EQ(found.explained, 1.0);
}

TEST(BinnedDependence, InterpolatesBinsThatAreEmptyInOneHalf) {
  // A straight line over a variable that rises with the blocks: every bin is in one half only.
  std::vector<double> variable, torque;
  for (int i = 0; i < 400; ++i) {
    variable.push_back(i);
    torque.push_back(0.01 * i);
  }
  EXPECT_GT(binned_dependence("x", variable, torque, blocks_of(400, 20)).explained, 0.97);
}

TEST(BinnedDependence, OfAConstantIsNothing) {
  const std::vector<double> ones(10, 1.0);
  const std::vector<double> torque{1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
  const Dependence found = binned_dependence("x", ones, torque, blocks_of(10, 2));
  EXPECT_EQ(found.explained, 0.0);
  EXPECT_TRUE(found.at.empty());
}

}  // namespace
}  // namespace coilwright::measurement::localise
