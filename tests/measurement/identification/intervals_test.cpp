#include "measurement/identification/intervals.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "measurement/random_numbers.hpp"
#include "measurement/slider_model.hpp"

namespace coilwright::measurement::identification {
namespace {

using actuator::standard_effects;

// Angle of the stop, rad, and its stiffness, N m/rad: it is pressed in by about the noise.
constexpr double stop = 0.2;
constexpr double stop_stiffness = 2000.0;

// The slide against a Kelvin-Voigt stop, by the midpoint rule in steps of 0.1 ms.
data::Run stopped_run() {
  data::Run run = slide_run(400, {}, no_error);
  run.inputs.front() = {0.0};  // at rest away from the stop
  const double damping = 0.6 * std::sqrt(stop_stiffness * true_mass);
  Normal normal(3);
  Place place;
  for (std::size_t i = 0; i < run.times.size(); ++i) {
    run.channels.front().values[i] = place.position + noise_sigma * normal();
    const auto acceleration = [&](const Place& at) {
      const double press = at.position < stop ? 0.0 : stop_stiffness * (at.position - stop) + damping * at.speed;
      return (run.inputs[i].front() - true_damping * at.speed - std::max(0.0, press)) / true_mass;
    };
    constexpr int parts = 100;
    for (int part = 0; part < parts; ++part) {
      const double step = interval / parts;
      const double now = acceleration(place);
      const Place middle{.position = place.position + 0.5 * step * place.speed,
                         .speed = place.speed + 0.5 * step * now};
      const double then = acceleration(middle);
      place = {.position = place.position + step * middle.speed, .speed = place.speed + step * then};
    }
  }
  return run;
}

// The slide with a stop, fitted from `start` in at most so many iterations.
struct Stopped {
  Stopped(std::vector<double> start, int iterations) : declared(slide(true_mass, true_damping)), run(stopped_run()) {
    fit::Hypothesis hypothesis(declared, {{.kind = standard_effects().find("end_stop"), .values = std::move(start)}});
    const fit::Hypothesis plain(declared, {});
    runs.push_back(replay::prepare_run(run, declared, plain.model_at(plain.start())));
    auto found = fit::fit({.hypothesis = &hypothesis,
                           .runs = runs,
                           .start = hypothesis.start(),
                           .effort = {.iterations = iterations, .tolerance = 1e-5}});
    EXPECT_TRUE(found);
    fitted = score(runs, std::move(hypothesis), std::move(*found));
  }
  replay::DeclaredModel declared;
  data::Run run;
  std::vector<replay::PreparedRun> runs;
  std::optional<FittedHypothesis> fitted;
};

// Declared as 1e-8 it is no measure of what it is fitted as.
TEST(Intervals, AreThoseOfANumberThatIsDeclaredAsNextToNothing) {
  Normal normal(7);
  const data::Run run = slide_run(400, {}, [&] { return noise_sigma * normal(); });
  std::vector<Estimate> of_damping;
  for (const double declared_damping : {1e-8, true_damping}) {
    const replay::DeclaredModel declared = slide(true_mass, declared_damping);
    fit::Hypothesis hypothesis(declared, {});
    const std::vector runs{replay::prepare_run(run, declared, hypothesis.model_at(hypothesis.start()))};
    auto found = fit::fit({.hypothesis = &hypothesis, .runs = runs, .start = hypothesis.start()});
    ASSERT_TRUE(found);
    const FittedHypothesis fitted = score(runs, std::move(hypothesis), std::move(*found));
    of_damping.push_back(estimated(runs, fitted, 1.0).estimates[1]);
  }
  EXPECT_TRUE(of_damping[0].determined);
  const double width = of_damping[1].upper - of_damping[1].lower;
  EXPECT_NEAR(of_damping[0].lower, of_damping[1].lower, 0.05 * width);
  EXPECT_NEAR(of_damping[0].upper, of_damping[1].upper, 0.05 * width);
}

// At a stiffness a thousand times too high the derivative vanishes; the interval that the data allow begins decades
// below.
TEST(Intervals, SpanDecadesOfAMagnitude) {
  const Stopped rigid({stop, 1000.0 * stop_stiffness, 1.0}, 0);
  const std::vector<Estimate> all = estimated(rigid.runs, *rigid.fitted, 1.0).estimates;
  ASSERT_EQ(all.size(), 4U);
  const Estimate& stiffness = all[3];
  EXPECT_GT(stiffness.lower, 0.05 * stop_stiffness);
  EXPECT_LT(stiffness.lower, stop_stiffness);
  EXPECT_GT(stiffness.upper, stop_stiffness);
  EXPECT_TRUE(stiffness.determined);
  EXPECT_LT(all[2].lower, stop);
  EXPECT_GT(all[2].upper, stop);
}

TEST(Intervals, CoverTheTrueValuesAtTheirNominalRate) {
  const replay::DeclaredModel declared = slide(2.2, 2.5);
  constexpr int draws = 100;
  int mass = 0;
  int damping = 0;
  for (int seed = 1; seed <= draws; ++seed) {
    Normal normal(static_cast<std::uint64_t>(seed));
    const auto run = slide_run(200, {}, [&] { return noise_sigma * normal(); });
    const fit::Hypothesis plain(declared, {});
    const std::vector runs{replay::prepare_run(run, declared, plain.model_at(plain.start()))};
    auto found = fit::fit({.hypothesis = &plain, .runs = runs, .start = plain.start()});
    ASSERT_TRUE(found);
    const std::vector<Estimate> all = estimated(runs, {.hypothesis = plain, .fit = std::move(*found)}, 1.0).estimates;
    ASSERT_EQ(all.size(), 2u);
    mass += all[0].lower <= true_mass && true_mass <= all[0].upper ? 1 : 0;
    damping += all[1].lower <= true_damping && true_damping <= all[1].upper ? 1 : 0;
  }
  EXPECT_GE(mass, 90);
  EXPECT_LE(mass, 99);
  EXPECT_GE(damping, 90);
  EXPECT_LE(damping, 99);
}

TEST(Intervals, AreTakenAtABetterOptimumThatAProfileReaches) {
  const Stopped poor({0.7 * stop, 0.1 * stop_stiffness, 1.0}, 1);
  const Stopped good({stop, stop_stiffness, 1.0}, 25);
  ASSERT_GT(poor.fitted->fit.chi_square, good.fitted->fit.chi_square + 10.0);
  const auto [moved, all] = estimated(poor.runs, *poor.fitted, 1.0);
  EXPECT_NEAR(moved.fit.chi_square, good.fitted->fit.chi_square, 0.5);
  EXPECT_EQ(all[2].value, moved.fit.values[2]);
  EXPECT_LT(all[2].lower, stop);
  EXPECT_GT(all[2].upper, stop);
}

}  // namespace
}  // namespace coilwright::measurement::identification
