#include "coilwright/measurement/signals/whiteness_test.hpp"

#include <gmock/gmock.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "error_text.hpp"
#include "measurement/signals/residual_draws.hpp"

namespace coilwright::measurement::signals {
namespace {

using std::numbers::pi;
using testing::HasSubstr;

void add(ScaledResidual& residual, const std::function<double(double)>& structure) {
  for (std::size_t i = 0; i < residual.values.size(); ++i)
    residual.values[i] += structure(interval * static_cast<double>(i));
}

double fraction_not_white(int sets, const std::function<std::vector<ScaledResidual>(Normal&)>& draw) {
  int count = 0;
  for (int seed = 1; seed <= sets; ++seed) {
    Normal normal(seed);
    count += whiteness_test(draw(normal), 0).is_white() ? 0 : 1;
  }
  return static_cast<double>(count) / sets;
}

// More than 4 failures in 400 would have a probability of 5 % at the stated rate of 1 in 200; 0 or 1 are usual.
constexpr double false_alarms = 4.0 / 400.0;

TEST(WhitenessTest, LetsWhiteNoisePass) {
  EXPECT_LE(fraction_not_white(400, [](Normal& normal) { return white_set(10, 600, normal); }), false_alarms);
  EXPECT_LE(fraction_not_white(400, [](Normal& normal) { return white_set(1, 3000, normal); }), false_alarms);
  EXPECT_LE(fraction_not_white(400, [](Normal& normal) { return white_set(7, 64, normal); }), false_alarms);
}

TEST(WhitenessTest, LetsNoiseOfAnotherLevelPass) {
  // An estimated sigma that is wrong by a quarter is no structure.
  for (const double factor : {0.8, 1.25})
    EXPECT_LE(fraction_not_white(200,
                                 [&](Normal& normal) {
                                   std::vector<ScaledResidual> set = white_set(10, 600, normal);
                                   for (ScaledResidual& run : set) {
                                     run.own_estimate = true;
                                     for (double& value : run.values) value *= factor;
                                   }
                                   return set;
                                 }),
              false_alarms);
}

TEST(WhitenessTest, FindsThatWhiteNoiseIsLargerThanTheNoiseThatIsKnown) {
  const auto at_level = [](double level, bool own_estimate) {
    Normal normal(4);
    std::vector<ScaledResidual> set = white_set(10, 600, normal);
    for (ScaledResidual& run : set) {
      run.own_estimate = own_estimate;
      for (double& value : run.values) value *= level;
    }
    return whiteness_test(set, 4);
  };
  EXPECT_GT(at_level(1.15, false).structure, 1.0);
  EXPECT_GT(at_level(1.6, true).structure, 1.0);
  EXPECT_LE(at_level(0.7, false).structure, 1.0);
}

TEST(WhitenessTest, LetsNoisePassOfWhichAFitHasAbsorbedPart) {
  constexpr int runs = 6;
  constexpr int samples = 500;
  constexpr int parameters = 10;
  // A Jacobian as fits have it: slow waves that differ from run to run.
  Eigen::MatrixXd jacobian(runs * samples, parameters);
  for (int r = 0; r < runs; ++r)
    for (int i = 0; i < samples; ++i)
      for (int p = 0; p < parameters; ++p)
        jacobian(r * samples + i, p) = std::sin(0.4 * (p + 1.0) * i / 60.0 + r * (p % 3)) + 0.1 * (p % 4);
  const Eigen::HouseholderQR<Eigen::MatrixXd> factors(jacobian);
  const Eigen::MatrixXd basis = factors.householderQ() * Eigen::MatrixXd::Identity(runs * samples, parameters);
  EXPECT_LE(fraction_not_white(400,
                               [&](Normal& normal) {
                                 std::vector<ScaledResidual> set = white_set(runs, samples, normal);
                                 Eigen::VectorXd all(runs * samples);
                                 for (int i = 0; i < all.size(); ++i) all[i] = set[i / samples].values[i % samples];
                                 all -= (basis * (basis.transpose() * all)).eval();
                                 for (int i = 0; i < all.size(); ++i) set[i / samples].values[i % samples] = all[i];
                                 return set;
                               }),
            false_alarms);
}

TEST(WhitenessTest, LetsShortBenchesPass) {
  for (const bool given : {false, true})
    EXPECT_LE(fraction_not_white(400,
                                 [&](Normal& normal) {
                                   std::vector<ScaledResidual> set;
                                   for (const int samples : {5, 9, 12, 20, 30}) {
                                     set.push_back(white(samples, normal));
                                     set.back().times.clear();
                                     set.back().own_estimate = !given;
                                     if (!given) set.back().freedom = 0.5 * samples;
                                   }
                                   return set;
                                 }),
              false_alarms);
}

// 12,000 samples with structure of a tenth of the noise: 120 units of chi-square in about 200 slow coefficients, whose
// standard deviation is 20; the limit is about 75.
TEST(WhitenessTest, FindsWeakSlowStructureInManySamples) {
  const auto with = [](double rms, double samples) {
    return [=](Normal& normal) {
      std::vector<ScaledResidual> set = white_set(10, 1200, normal);
      for (ScaledResidual& run : set) {
        const std::vector<double> slow = markov(run.values.size(), samples, normal);
        for (std::size_t i = 0; i < slow.size(); ++i) run.values[i] += rms * slow[i];
      }
      return set;
    };
  };
  EXPECT_GE(fraction_not_white(100, with(0.10, 100.0)), 0.70);
  EXPECT_GE(fraction_not_white(100, with(0.15, 100.0)), 0.99);
  EXPECT_LE(fraction_not_white(100, with(0.03, 100.0)), 0.02);  // allowed
}

TEST(WhitenessTest, FindsASpectralLineAndNamesItsFrequency) {
  Normal normal(1);
  std::vector<ScaledResidual> one = white_set(1, 12000, normal);
  add(one.front(), [](double t) { return 0.15 * std::sin(2.0 * pi * 7.0 * t + 0.4); });
  const WhitenessResult single = whiteness_test(one, 4);
  EXPECT_GT(single.structure, 1.0);
  EXPECT_THAT(single.where, HasSubstr("run0.csv, line at 7"));

  std::vector<ScaledResidual> several = white_set(10, 1200, normal);
  for (ScaledResidual& run : several) {
    const double phase = 6.0 * normal.uniform();
    add(run, [=](double t) { return 0.2 * std::sin(2.0 * pi * 50.0 * t + phase); });
  }
  const WhitenessResult pooled = whiteness_test(several, 4);
  EXPECT_GT(pooled.structure, 1.0);
  EXPECT_THAT(pooled.where, HasSubstr("all runs, line at 50"));
}

TEST(WhitenessTest, FindsAShortEvent) {
  Normal normal(2);
  std::vector<ScaledResidual> set = white_set(10, 1200, normal);
  add(set[3], [](double t) { return t >= 1.0 && t < 1.04 ? 2.5 : 0.0; });
  const WhitenessResult result = whiteness_test(set, 4);
  EXPECT_GT(result.structure, 1.0);
  EXPECT_THAT(result.where, HasSubstr("run3.csv, 32 ms from"));
}

TEST(WhitenessTest, FindsAnOffsetOfOneRun) {
  Normal normal(3);
  std::vector<ScaledResidual> set = white_set(10, 1200, normal);
  add(set[6], [](double) { return 0.3; });
  const WhitenessResult result = whiteness_test(set, 4);
  EXPECT_GT(result.structure, 1.0);
  EXPECT_THAT(result.where, HasSubstr("run6.csv"));
}

TEST(WhitenessTest, FindsCurvatureOnABenchWhoseNoiseIsKnown) {
  const auto bent = [](bool given) {
    return [=](Normal& normal) {
      ScaledResidual bench = white(15, normal, "bench.csv");
      bench.times.clear();
      if (!given) bench.freedom = 7.0;
      for (int i = 0; i < 15; ++i) bench.values[i] += 4.0 * std::cos(pi * (i + 0.5) / 15.0);
      return std::vector{bench};
    };
  };
  // 120 units in one coefficient; if the noise is estimated from the same 15 samples, the test is weak.
  EXPECT_GE(fraction_not_white(100, bent(true)), 0.99);
  EXPECT_GE(fraction_not_white(100, bent(false)), 0.5);
}

TEST(WhitenessTest, LevelIsTheRootMeanSquarePerDegreeOfFreedom) {
  const std::vector<ScaledResidual> set{{.run = "a", .values = {3.0, -4.0}}, {.run = "b", .values = {0.0, 5.0, 0.0}}};
  EXPECT_DOUBLE_EQ(whiteness_test(set, 0).level, std::sqrt(50.0 / 5.0));
  EXPECT_DOUBLE_EQ(whiteness_test(set, 3).level, std::sqrt(50.0 / 2.0));
  EXPECT_DOUBLE_EQ(whiteness_test(set, 5).level, std::sqrt(50.0 / 5.0));  // no degree of freedom: no correction
  EXPECT_EQ(whiteness_test({}, 0).level, 0.0);
  EXPECT_TRUE(whiteness_test({}, 0).is_white());
}

TEST(WhitenessTest, FindsNothingInZeros) {
  const std::vector<ScaledResidual> set{{.run = "a", .values = std::vector<double>(500, 0.0)}};
  EXPECT_TRUE(whiteness_test(set, 2).is_white());
}

TEST(WhitenessTest, RefusesAResidualThatBreaksARule) {
  const auto text = [](const ScaledResidual& residual) {
    return error_text([&] { (void)whiteness_test(std::vector{residual}, 0); });
  };
  EXPECT_EQ(text({.run = "a.csv", .values = {1.0, NAN}}), "a.csv: a residual must be finite; got nan");
  EXPECT_EQ(text({.run = "a.csv", .times = {0.0}, .values = {1.0, 2.0}}),
            "a.csv: a residual must have one time for each value; got 1");
  EXPECT_EQ(text({.run = "a.csv", .times = {0.0, 0.0}, .values = {1.0, 2.0}}),
            "a.csv: times of a residual must increase; got 0");
  EXPECT_EQ(text({.run = "a.csv", .values = {1.0, 2.0}, .starts = {0, 2}}),
            "a.csv: starts of windows must rise and stay inside the run; got 2");
  EXPECT_EQ(text({.run = "a.csv", .values = {1.0, 2.0}, .starts = {1}}),
            "a.csv: the first window must start at sample 0; got 1");
  EXPECT_EQ(error_text([] { (void)whiteness_test({}, -1); }), "fitted_parameters must be >= 0; got -1");
}

}  // namespace
}  // namespace coilwright::measurement::signals
