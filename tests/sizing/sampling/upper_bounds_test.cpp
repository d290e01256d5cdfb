#include "sizing/sampling/upper_bounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace coilwright::sizing {
namespace {

bool strictly_below(const Objectives& a, const Objectives& b) {
  return std::equal(a.begin(), a.end(), b.begin(), [](double x, double y) { return x < y; });
}

bool weakly_dominates(const Objectives& a, const Objectives& b) {
  return std::equal(a.begin(), a.end(), b.begin(), [](double x, double y) { return x <= y; });
}

std::vector<Objectives> points_with_ties(std::size_t count, std::size_t objectives) {
  std::mt19937_64 random{21};
  std::vector<Objectives> points(count, Objectives(objectives));
  for (Objectives& point : points) {
    for (double& value : point) value = static_cast<double>(random() % 12) + 0.25;
  }
  return points;
}

// The definition: somewhere is below a bound exactly if no point dominates it. (On a grid between the points' values.)
TEST(UpperBounds, CoverExactlyWhatIsNotDominated) {
  for (const std::size_t objectives : {std::size_t{1}, std::size_t{2}, std::size_t{3}}) {
    UpperBounds bounds{objectives};
    const auto points = points_with_ties(25, objectives);
    for (std::size_t i = 0; i < points.size(); ++i) bounds.add(points[i], i);
    std::mt19937_64 random{4};
    for (int trial = 0; trial < 2000; ++trial) {
      Objectives at(objectives);
      for (double& value : at) value = static_cast<double>(random() % 14) - 0.25;
      const bool dominated =
          std::ranges::any_of(points, [&](const auto& point) { return weakly_dominates(point, at); });
      const bool covered =
          std::ranges::any_of(bounds.all(), [&](const UpperBound& bound) { return strictly_below(at, bound.corner); });
      ASSERT_EQ(covered, !dominated);
    }
  }
}

TEST(UpperBounds, AreNeverBelowOneAnother) {
  UpperBounds bounds{3};
  const auto points = points_with_ties(40, 3);
  for (std::size_t i = 0; i < points.size(); ++i) bounds.add(points[i], i);
  for (std::size_t i = 0; i < bounds.all().size(); ++i) {
    for (std::size_t k = 0; k < bounds.all().size(); ++k) {
      if (i == k) continue;
      EXPECT_FALSE(weakly_dominates(bounds.all()[i].corner, bounds.all()[k].corner));
    }
  }
}

TEST(UpperBounds, NameThePointsThatSetThem) {
  UpperBounds bounds{2};
  EXPECT_TRUE(bounds.add({2, 5}, 7));
  EXPECT_TRUE(bounds.add({4, 3}, 9));
  EXPECT_FALSE(bounds.add({4, 6}, 11));
  const auto middle = std::ranges::find(bounds.all(), Objectives{4, 5}, &UpperBound::corner);
  ASSERT_NE(middle, bounds.all().end());
  EXPECT_EQ(middle->definers, (std::vector<std::size_t>{9, 7}));
}

}  // namespace
}  // namespace coilwright::sizing
