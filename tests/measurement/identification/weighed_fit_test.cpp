#include "measurement/identification/weighed_fit.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <numbers>
#include <vector>

#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "measurement/identification/rig_scale.hpp"
#include "measurement/identification/slide_fits.hpp"
#include "measurement/random_numbers.hpp"
#include "measurement/slider_model.hpp"

namespace coilwright::measurement::identification {
namespace {

const actuator::EffectKind& zero_of_the_angle = *actuator::standard_effects().find("angle_offset");

// Where nothing declared may move.
replay::DeclaredModel fixed_slide() {
  replay::DeclaredModel declared = slide(true_mass, true_damping);
  declared.calibration.clear();
  declared.build = [](std::span<const double> /*values*/) {
    return slide(true_mass, true_damping).build(std::vector{true_mass, true_damping});
  };
  return declared;
}

struct WeighedSlide {
  WeighedSlide(replay::DeclaredModel model, data::Run recorded)
      : declared(std::move(model)),
        run(std::move(recorded)),
        runs{replay::prepare_run(run, declared, model_of(declared))} {}

  [[nodiscard]] WeighedFit weighed_with(std::vector<actuator::Effect> effects) const {
    return weighed(runs, fitted_to(runs, declared, std::move(effects)), rig_scale(runs, model_of(declared)));
  }
  replay::DeclaredModel declared;
  data::Run run;
  std::vector<replay::PreparedRun> runs;
};

// A log-normal magnitude of a typical degree, on both sides of zero, as the catalogue's starts have it.
double density_of_zero(double offset) {
  const double spread = std::log(10.0);
  const double u = std::log(std::abs(offset) / (std::numbers::pi / 180.0)) / spread;
  return 0.5 * std::exp(-0.5 * u * u) / (std::sqrt(2.0 * std::numbers::pi) * spread * std::abs(offset));
}

Eigen::MatrixXd covariance_of(Eigen::Index samples, double deviation, double length) {
  Eigen::MatrixXd out = Eigen::MatrixXd::Identity(samples, samples);
  for (Eigen::Index i = 0; i < samples; ++i)
    for (Eigen::Index k = 0; k < samples; ++k) {
      const double w = std::sqrt(3.0) * std::abs(static_cast<double>(i - k)) / length;
      out(i, k) += deviation * deviation * (1.0 + w) * std::exp(-w);
    }
  return out;
}

// By a second route: dense covariances, integrated over a finer grid of discrepancies and, with an effect, over its
// number, for residuals that are all the same. `shift` in deviations of the noise.
double log_evidence_by_integration(Eigen::Index samples, double shift, bool with_zero) {
  constexpr int deviations = 60, lengths = 12, offsets = 4000;
  const double ratio = std::log(1e4) / deviations;
  const double longest = static_cast<double>(samples) / 3.0;
  double sum = 0.0;
  const auto add = [&](double weight, double deviation, double length) {
    const Eigen::LLT<Eigen::MatrixXd> whole(covariance_of(samples, deviation, length));
    const double information = whole.solve(Eigen::VectorXd::Ones(samples)).sum();
    const double log_determinant = 2.0 * whole.matrixLLT().diagonal().array().log().sum();
    double likelihood = std::exp(-0.5 * information * shift * shift);
    if (with_zero) {
      likelihood = 0.0;
      const double step = 4.0 * shift / offsets;
      for (int i = 1; i <= offsets; ++i) {
        const double at = i * step;  // over the noise, like the shift
        likelihood += step * noise_sigma * density_of_zero(at * noise_sigma) *
                      std::exp(-0.5 * information * (shift - at) * (shift - at));
      }
    }
    sum += weight * likelihood * std::exp(-0.5 * log_determinant);
  };
  add(0.5, 0.0, 1.0);
  for (int d = 0; d < deviations; ++d)
    for (int l = 0; l < lengths; ++l) {
      const double deviation = 0.02 * std::exp((d + 0.5) * ratio);
      const double length = 2.0 * std::pow(longest / 2.0, (l + 0.5) / lengths);
      add(0.5 * 2.0 / std::numbers::pi * deviation * ratio / (1.0 + deviation * deviation) / lengths, deviation,
          length);
    }
  return std::log(sum);
}

// Residuals that are all half a deviation of the noise: a zero that is off, or a discrepancy as long as the run.
TEST(WeighedFit, HasTheEvidenceOfTheWholeCovarianceIntegrated) {
  constexpr Eigen::Index readings = 100;
  constexpr double shift = 0.5;
  const WeighedSlide slid(fixed_slide(), slide_run(readings, {}, [] { return shift * noise_sigma; }));
  const WeighedFit without = slid.weighed_with({});
  const WeighedFit with = slid.weighed_with({{.kind = &zero_of_the_angle, .values = {0.01}}});
  // What the grid and Laplace's approximation leave out.
  constexpr double tolerance = 0.3;
  EXPECT_NEAR(without.log_evidence, log_evidence_by_integration(readings, shift, false), tolerance);
  EXPECT_NEAR(with.log_evidence, log_evidence_by_integration(readings, shift, true), tolerance);
  EXPECT_GT(with.probability_of_noise, 0.9);
  EXPECT_LT(without.probability_of_noise, 0.1);
}

TEST(WeighedFit, FindsNothingMissingInNoise) {
  int noise = 0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    Normal normal(100 + seed);
    const WeighedSlide slid(fixed_slide(), slide_run(400, {}, [&] { return noise_sigma * normal(); }));
    noise += slid.weighed_with({}).probability_of_noise > 0.5 ? 1 : 0;
  }
  EXPECT_GE(noise, 19);
}

// A wave of twice the noise with a period of 80 samples.
TEST(WeighedFit, MeasuresWhatIsMissing) {
  Normal normal(3);
  int sample = 0;
  const WeighedSlide slid(
      fixed_slide(), slide_run(400, {}, [&] {
        return noise_sigma * (normal() + 2.0 * std::sqrt(2.0) * std::sin(2.0 * std::numbers::pi * sample++ / 80.0));
      }));
  const WeighedFit found = slid.weighed_with({});
  EXPECT_LT(found.probability_of_noise, 1e-6);
  EXPECT_NEAR(std::log(found.discrepancy.deviation / 2.0), 0.0, std::log(2.0));
  EXPECT_GE(found.discrepancy.length, 16.0);
}

// Ten tolerances off: Student's t lets the mass go where the records have it, and holds its neighbour as before.
TEST(WeighedFit, LetsOneDeclaredNumberBeFarOff) {
  constexpr double tolerance = 0.02;  // kg
  replay::DeclaredModel declared = slide(true_mass + 10.0 * tolerance, true_damping);
  for (replay::CalibrationParameter& number : declared.calibration) {
    number.tolerance = replay::Tolerance{.deviation = tolerance * number.declared / true_mass};
    number.scale = number.tolerance->deviation;
    number.calibrated = false;
  }
  Normal normal(11);
  const WeighedSlide slid(declared, slide_run(400, {}, [&] { return noise_sigma * normal(); }));
  const WeighedFit found = slid.weighed_with({});
  const double deviation = std::sqrt(found.covariance(0, 0));
  EXPECT_LT(deviation, tolerance);
  EXPECT_NEAR(found.values[0], true_mass, 4.0 * deviation);
}

// Of the deviation that is stated, from a filter of the first order: noise, unless a record of it at rest has told that
// it is white.
TEST(WeighedFit, TakesWhatIsAsLargeAsStatedForColouredNoiseWhereNoRecordTellsItsColour) {
  constexpr double kept = 0.6;  // of a value by the next
  Normal normal(7);
  double filtered = normal();
  WeighedSlide slid(fixed_slide(), slide_run(800, {}, [&] {
                      filtered = kept * filtered + std::sqrt(1.0 - kept * kept) * normal();
                      return noise_sigma * filtered;
                    }));
  EXPECT_LT(slid.weighed_with({}).probability_of_noise, 1e-3);
  slid.runs.front().noise.front().colour_unknown = true;
  const WeighedFit found = slid.weighed_with({});
  EXPECT_GT(found.probability_of_noise, 0.99);
  EXPECT_EQ(found.discrepancy.deviation, 0.0);
}

// The wave of twice the noise again, and one as large as the noise.
TEST(WeighedFit, TakesNothingForColouredNoiseThatIsLargerThanStated) {
  for (const double size : {1.0, 2.0}) {
    Normal normal(3);
    int sample = 0;
    WeighedSlide slid(fixed_slide(), slide_run(400, {}, [&] {
                        return noise_sigma * (normal() + size * std::numbers::sqrt2 *
                                                             std::sin(2.0 * std::numbers::pi * sample++ / 80.0));
                      }));
    slid.runs.front().noise.front().colour_unknown = true;
    EXPECT_LT(slid.weighed_with({}).probability_of_noise, 1e-3) << size;
  }
}

// A number that no record tells anything of, where it is declared and beyond the end of its prior: the evidence of each
// has the integral of the prior there, by the midpoint rule.
TEST(WeighedFit, IntegratesThePriorOfAnIdleNumberOverWhereItIs) {
  replay::DeclaredModel declared = fixed_slide();
  declared.calibration = {{.key = "idle",
                           .declared = 0.0,
                           .lower = -45.0,
                           .upper = 45.0,
                           .scale = 1.0,
                           .tolerance = replay::Tolerance{.deviation = 1.0},
                           .calibrated = false,
                           .other_start = -45.0}};
  Normal normal(5);
  const WeighedSlide slid(declared, slide_run(200, {}, [&] { return noise_sigma * normal(); }));
  const auto log_evidence_from = [&](double start) {
    PlannedFit plan{.hypothesis = fit::Hypothesis(slid.declared, {})};
    plan.start = plan.hypothesis.start();
    plan.start[0] = start;
    const auto fitted = fit_exactly(slid.runs, plan);
    return weighed(slid.runs, fitted.value(), {}).log_evidence;
  };
  const auto prior_between = [](double from, double to) {
    constexpr int parts = 1000;
    double sum = 0.0;
    for (int i = 0; i < parts; ++i) {
      const double distance = std::min(3.0, std::abs(from + (to - from) * (i + 0.5) / parts));
      sum += (to - from) / parts * std::pow(1.0 + 0.25 * distance * distance, -2.5);
    }
    return sum;
  };
  // Near the declared value the parabola lacks the tails.
  EXPECT_NEAR(log_evidence_from(-45.0) - log_evidence_from(0.0),
              std::log(prior_between(-45.0, -3.0) / prior_between(-3.0, 3.0)), 0.2);
}

}  // namespace
}  // namespace coilwright::measurement::identification
