#include "coilwright/measurement/whiteness/whiteness_test.hpp"

#include <gmock/gmock.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "coilwright/measurement/whiteness/correlation_time.hpp"
#include "error_text.hpp"
#include "measurement/random_numbers.hpp"

namespace coilwright::measurement::whiteness {
namespace {

using std::numbers::pi;
using testing::HasSubstr;

constexpr double interval = 0.002;

ScaledResidual white(int samples, Normal& normal, const std::string& run = "run.csv") {
  ScaledResidual residual{.run = run};
  for (int i = 0; i < samples; ++i) {
    residual.times.push_back(interval * i);
    residual.values.push_back(normal());
  }
  return residual;
}

std::vector<ScaledResidual> white_set(int runs, int samples, Normal& normal) {
  std::vector<ScaledResidual> set;
  for (int r = 0; r < runs; ++r) set.push_back(white(samples, normal, "run" + std::to_string(r) + ".csv"));
  return set;
}

void add(ScaledResidual& residual, const std::function<double(double)>& structure) {
  for (std::size_t i = 0; i < residual.values.size(); ++i)
    residual.values[i] += structure(interval * static_cast<double>(i));
}

// Gauss-Markov structure of rms 1 whose correlation falls to 1/e over `samples`.
std::vector<double> markov(std::size_t count, double samples, Normal& normal) {
  const double keep = std::exp(-1.0 / samples);
  std::vector<double> values{normal()};
  while (values.size() < count) values.push_back(keep * values.back() + std::sqrt(1.0 - keep * keep) * normal());
  return values;
}

double found(int sets, const std::function<std::vector<ScaledResidual>(Normal&)>& draw) {
  int count = 0;
  for (int seed = 1; seed <= sets; ++seed) {
    Normal normal(seed);
    count += adequacy_of(draw(normal), 0).noise_only() ? 0 : 1;
  }
  return static_cast<double>(count) / sets;
}

// Failing more often than 4 times in 400 would have a chance of 5 % at the promised 1 in 200; 0 to 1 are usual.
constexpr double false_alarms = 4.0 / 400.0;

TEST(Adequacy, LetsWhiteNoisePass) {
  EXPECT_LE(found(400, [](Normal& normal) { return white_set(10, 600, normal); }), false_alarms);
  EXPECT_LE(found(400, [](Normal& normal) { return white_set(1, 3000, normal); }), false_alarms);
  EXPECT_LE(found(400, [](Normal& normal) { return white_set(7, 64, normal); }), false_alarms);
}

TEST(Adequacy, LetsNoiseOfAnotherLevelPass) {
  // An estimated sigma that is wrong by a quarter is no structure.
  for (const double factor : {0.8, 1.25})
    EXPECT_LE(found(200,
                    [&](Normal& normal) {
                      std::vector<ScaledResidual> set = white_set(10, 600, normal);
                      for (ScaledResidual& run : set)
                        for (double& value : run.values) value *= factor;
                      return set;
                    }),
              false_alarms);
}

TEST(Adequacy, LetsNoisePassThatAFitHasAbsorbed) {
  constexpr int runs = 6;
  constexpr int samples = 500;
  constexpr int parameters = 10;
  // Sensitivities as a fit has them: slow waves that differ from run to run.
  Eigen::MatrixXd jacobian(runs * samples, parameters);
  for (int r = 0; r < runs; ++r)
    for (int i = 0; i < samples; ++i)
      for (int p = 0; p < parameters; ++p)
        jacobian(r * samples + i, p) = std::sin(0.4 * (p + 1.0) * i / 60.0 + r * (p % 3)) + 0.1 * (p % 4);
  const Eigen::HouseholderQR<Eigen::MatrixXd> factors(jacobian);
  const Eigen::MatrixXd basis = factors.householderQ() * Eigen::MatrixXd::Identity(runs * samples, parameters);
  EXPECT_LE(found(400,
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

TEST(Adequacy, LetsShortBenchesPass) {
  for (const bool given : {false, true})
    EXPECT_LE(found(400,
                    [&](Normal& normal) {
                      std::vector<ScaledResidual> set;
                      for (const int samples : {5, 9, 12, 20, 30}) {
                        set.push_back(white(samples, normal));
                        set.back().times.clear();
                        set.back().sigma_given = given;
                      }
                      return set;
                    }),
              false_alarms);
}

// 12,000 samples with structure a tenth of the noise: 120 units of chi-square among some 200 slow coefficients, whose
// own spread is 20, against a limit of about 75.
TEST(Adequacy, FindsWeakSlowStructureInManySamples) {
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
  EXPECT_GE(found(100, with(0.10, 100.0)), 0.70);
  EXPECT_GE(found(100, with(0.15, 100.0)), 0.99);
  EXPECT_LE(found(100, with(0.03, 100.0)), 0.02);  // allowed
}

TEST(Adequacy, FindsALineAndNamesItsFrequency) {
  Normal normal(1);
  std::vector<ScaledResidual> one = white_set(1, 12000, normal);
  add(one.front(), [](double t) { return 0.15 * std::sin(2.0 * pi * 7.0 * t + 0.4); });
  const Adequacy alone = adequacy_of(one, 4);
  EXPECT_GT(alone.structure, 1.0);
  EXPECT_THAT(alone.where, HasSubstr("run0.csv, line at 7"));

  std::vector<ScaledResidual> several = white_set(10, 1200, normal);
  for (ScaledResidual& run : several) {
    const double phase = 6.0 * normal.uniform();
    add(run, [=](double t) { return 0.2 * std::sin(2.0 * pi * 50.0 * t + phase); });
  }
  const Adequacy together = adequacy_of(several, 4);
  EXPECT_GT(together.structure, 1.0);
  EXPECT_THAT(together.where, HasSubstr("all runs, line at 50"));
}

TEST(Adequacy, FindsWhatIsShortAndInOnePlace) {
  Normal normal(2);
  std::vector<ScaledResidual> set = white_set(10, 1200, normal);
  add(set[3], [](double t) { return t >= 1.0 && t < 1.04 ? 2.5 : 0.0; });
  const Adequacy adequacy = adequacy_of(set, 4);
  EXPECT_GT(adequacy.structure, 1.0);
  EXPECT_THAT(adequacy.where, HasSubstr("run3.csv, 32 ms from"));
}

TEST(Adequacy, FindsAnOffsetOfOneRun) {
  Normal normal(3);
  std::vector<ScaledResidual> set = white_set(10, 1200, normal);
  add(set[6], [](double) { return 0.3; });
  const Adequacy adequacy = adequacy_of(set, 4);
  EXPECT_GT(adequacy.structure, 1.0);
  EXPECT_THAT(adequacy.where, HasSubstr("run6.csv"));
}

TEST(Adequacy, FindsABowOnABenchWhoseNoiseIsKnown) {
  const auto bent = [](bool given) {
    return [=](Normal& normal) {
      ScaledResidual bench = white(15, normal, "bench.csv");
      bench.times.clear();
      bench.sigma_given = given;
      for (int i = 0; i < 15; ++i) bench.values[i] += 4.0 * std::cos(pi * (i + 0.5) / 15.0);
      return std::vector{bench};
    };
  };
  // 120 units in one coefficient; where the noise had to be estimated from the same 15 samples, its measure is weak.
  EXPECT_GE(found(100, bent(true)), 0.99);
  EXPECT_GE(found(100, bent(false)), 0.5);
}

TEST(Adequacy, LevelIsRootMeanSquareOverWhatIsFree) {
  const std::vector<ScaledResidual> set{{.run = "a", .values = {3.0, -4.0}}, {.run = "b", .values = {0.0, 5.0, 0.0}}};
  EXPECT_DOUBLE_EQ(adequacy_of(set, 0).level, std::sqrt(50.0 / 5.0));
  EXPECT_DOUBLE_EQ(adequacy_of(set, 3).level, std::sqrt(50.0 / 2.0));
  EXPECT_DOUBLE_EQ(adequacy_of(set, 5).level, std::sqrt(50.0 / 5.0));  // nothing is free: no correction
  EXPECT_EQ(adequacy_of({}, 0).level, 0.0);
  EXPECT_TRUE(adequacy_of({}, 0).noise_only());
}

TEST(Adequacy, OfAModelWithoutAnyResidualIsNoise) {
  const std::vector<ScaledResidual> set{{.run = "a", .values = std::vector<double>(500, 0.0)}};
  EXPECT_TRUE(adequacy_of(set, 2).noise_only());
}

TEST(Adequacy, RefusesWhatIsNoResidual) {
  const auto text = [](const ScaledResidual& residual) {
    return error_text([&] { (void)adequacy_of(std::vector{residual}, 0); });
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
  EXPECT_EQ(error_text([] { (void)adequacy_of({}, -1); }), "fitted_parameters must be >= 0; got -1");
}

TEST(CorrelationTime, OfWhiteNoiseIsOne) {
  for (int seed = 1; seed <= 5; ++seed) {
    Normal normal(seed);
    // Five lags of correlations +-1/sqrt(12000) each, twice: 0.04.
    EXPECT_NEAR(correlation_time(white_set(10, 1200, normal)), 1.0, 0.12);
  }
}

TEST(CorrelationTime, OfAGaussMarkovProcessIsKnown) {
  for (const double samples : {5.0, 30.0}) {
    Normal normal(4);
    const ScaledResidual one{.run = "a", .values = markov(60000, samples, normal)};
    const double keep = std::exp(-1.0 / samples);
    const double exact = (1.0 + keep) / (1.0 - keep);
    // Relative standard error sqrt(2 (2 W + 1) / n) with W = 5 tau (Sokal): 10 % at tau = 60.
    EXPECT_NEAR(correlation_time(std::vector{one}) / exact, 1.0, 3.0 * std::sqrt(20.0 * exact / 60000.0)) << samples;
  }
}

TEST(CorrelationTime, DoesNotReachAcrossAWindow) {
  // Windows of constants with signs that change at random: alike inside, strangers across.
  Normal normal(5);
  ScaledResidual residual{.run = "a", .starts = {}};
  for (std::size_t w = 0; w < 200; ++w) {
    residual.starts.push_back(10 * w);
    residual.values.insert(residual.values.end(), 10, normal() < 0.0 ? -1.0 : 1.0);
  }
  // 1 + 2 sum over lags 1 to 9 of (10 - lag) / 10 = 10: a window counts as one sample.
  EXPECT_NEAR(correlation_time(std::vector{residual}), 10.0, 1e-9);
}

TEST(CorrelationTime, OfAnOffsetIsTheRun) {
  const ScaledResidual residual{.run = "a", .values = std::vector<double>(400, 2.0)};
  EXPECT_NEAR(correlation_time(std::vector{residual}), 400.0, 1e-9);
  EXPECT_EQ(correlation_time(std::vector<ScaledResidual>{{.run = "a", .values = {0.0, 0.0}}}), 1.0);
}

}  // namespace
}  // namespace coilwright::measurement::whiteness
