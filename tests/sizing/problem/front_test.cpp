#include "coilwright/sizing/problem/front.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "sizing/expect_error.hpp"

namespace coilwright::sizing {
namespace {

using testing::expect_error;

std::vector<Objectives> random_points(std::size_t count, std::size_t objectives, std::uint64_t seed) {
  std::mt19937_64 random{seed};
  std::uniform_real_distribution<double> uniform{0.0, 1.0};
  std::vector<Objectives> points(count, Objectives(objectives));
  for (Objectives& point : points) {
    for (double& value : point) value = uniform(random);
  }
  return points;
}

// Share of random points of the unit box below (1, ..., 1) that some point dominates.
double monte_carlo_hypervolume(const std::vector<Objectives>& points, int samples) {
  std::size_t hits = 0;
  for (const Objectives& at : random_points(static_cast<std::size_t>(samples), points[0].size(), 99)) {
    hits += std::ranges::any_of(points, [&](const Objectives& point) {
      for (std::size_t i = 0; i < at.size(); ++i) {
        if (point[i] > at[i]) return false;
      }
      return true;
    });
  }
  return static_cast<double>(hits) / samples;
}

TEST(Hypervolume, OfOnePointIsTheProductOfItsDistances) {
  EXPECT_DOUBLE_EQ(hypervolume({{2, 3}}, std::vector<double>{7, 5}), 10);
  EXPECT_DOUBLE_EQ(hypervolume({{2, 3, 1}}, std::vector<double>{7, 5, 4}), 30);
  EXPECT_DOUBLE_EQ(hypervolume({{2.5}, {4}}, std::vector<double>{7}), 4.5);
}

// By hand: 2-D staircase 3*1 + 2*1 + 1*2 = 7 with corners (1,4), (2,3), (3,1) below (4,5); the duplicate, the dominated
// point and those outside the reference add nothing.
TEST(Hypervolume, OfAStaircaseIsTheSumOfItsSteps) {
  const std::vector<Objectives> points{{3, 1}, {1, 4}, {2, 3}, {2, 3}, {3, 3.5}, {0.5, 5}, {9, 0}};
  EXPECT_DOUBLE_EQ(hypervolume(points, std::vector<double>{4, 5}), 7);
}

// By inclusion and exclusion: boxes of volume 4*3*2 = 24 and 2*4*4 = 32 overlap in 2*3*2 = 12.
TEST(Hypervolume, OfTwoBoxesIsTheirUnion) {
  EXPECT_DOUBLE_EQ(hypervolume({{1, 2, 3}, {3, 1, 1}}, std::vector<double>{5, 5, 5}), 44);
}

TEST(Hypervolume, AgreesWithMonteCarloInTwoAndThreeDimensions) {
  for (const std::size_t objectives : {std::size_t{2}, std::size_t{3}}) {
    for (const std::uint64_t seed : {3U, 4U, 5U}) {
      const auto points = random_points(objectives == 2 ? 7 : 15, objectives, seed);
      // 200 000 samples: standard deviation at most 0.5 / sqrt(200 000) = 1.1e-3; four of them
      EXPECT_NEAR(hypervolume(points, std::vector<double>(objectives, 1.0)), monte_carlo_hypervolume(points, 200'000),
                  4.5e-3);
    }
  }
}

TEST(Hypervolume, DoesNotDependOnTheOrderOfPoints) {
  auto points = random_points(40, 3, 17);
  const std::vector<double> reference(3, 0.9);
  const double before = hypervolume(points, reference);
  std::ranges::reverse(points);
  // sums of the same 40 slabs in another order: 40 roundings
  EXPECT_NEAR(hypervolume(points, reference), before, 40 * 2.3e-16);
}

TEST(Hypervolume, RejectsWhatItCannotMeasure) {
  expect_error<std::invalid_argument>([] { (void)hypervolume({}, std::vector<double>(4, 1.0)); },
                                      "reference: must have 1, 2 or 3 objectives; got 4");
  expect_error<std::invalid_argument>(
      [] {
        (void)hypervolume({{0.5, 0.5, 0.5}}, std::vector<double>(2, 1.0));
      },
      "points: must have 2 objectives each; got 3");
}

TEST(NonDominated, KeepsExactlyWhatNoOtherPointDominates) {
  for (const std::size_t objectives : {std::size_t{2}, std::size_t{3}}) {
    auto points = random_points(60, objectives, 8);
    for (Objectives& point : points) {
      for (double& value : point) value = std::round(value * 8);  // many ties
    }
    const std::vector<std::size_t> kept = non_dominated(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const bool beaten = std::ranges::any_of(points, [&](const auto& other) { return dominates(other, points[i]); });
      const bool repeated = std::find(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(i), points[i]) !=
                            points.begin() + static_cast<std::ptrdiff_t>(i);
      EXPECT_EQ(std::ranges::binary_search(kept, i), !beaten && !repeated) << i;
    }
  }
}

TEST(Frame, SpansTheFrontAndIgnoresDominatedPoints) {
  const FrontFrame frame = frame_of({{1, 7}, {2, 5}, {6, 4}, {8, 8}});
  EXPECT_EQ(frame.ideal, (Objectives{1, 4}));
  EXPECT_EQ(frame.nadir, (Objectives{6, 7}));
  expect_error<std::invalid_argument>([] { (void)frame_of({}); }, "points: must hold at least one; got none");
}

// Ideal at (0, 0): 1.1 * 1.1.
TEST(NormalisedHypervolume, IsTheSameInAnyUnits) {
  const FrontFrame frame{.ideal = {-3, 200}, .nadir = {5, 700}};
  EXPECT_DOUBLE_EQ(normalised_hypervolume({{-3, 200}}, frame), 1.1 * 1.1);
  // (1, 450) is (0.5, 0.5): 0.6 * 0.6
  EXPECT_NEAR(normalised_hypervolume({{1, 450}}, frame), 0.36, 1e-15);
}

}  // namespace
}  // namespace coilwright::sizing
