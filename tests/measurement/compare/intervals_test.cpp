#include "measurement/compare/intervals.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "coilwright/actuator/effect_catalogue.hpp"
#include "measurement/random_numbers.hpp"
#include "measurement/slide.hpp"

namespace coilwright::measurement::compare {
namespace {

using actuator::standard_effects;

// Where the slide is stopped, rad, and how stiff, N m/rad: pressed in by as much as the noise.
constexpr double stop = 0.2;
constexpr double stop_stiffness = 2000.0;

// The slide against a stop of Kelvin and Voigt, by the midpoint rule in steps of 0.1 ms.
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

// The slide with a stop whose fit ended, after so many iterations, where `start` led it.
struct Stopped {
  Stopped(std::vector<double> start, int iterations) : declared(slide(true_mass, true_damping)), run(stopped_run()) {
    fit::Hypothesis hypothesis(declared, {{.kind = standard_effects().find("end_stop"), .values = std::move(start)}});
    const fit::Hypothesis plain(declared, {});
    records.push_back(replay::prepare(run, declared, plain.model_at(plain.start())));
    auto found = fit::fit({.hypothesis = &hypothesis,
                           .records = records,
                           .start = hypothesis.start(),
                           .effort = {.iterations = iterations, .tolerance = 1e-5}});
    EXPECT_TRUE(found);
    scored = compare::scored(records, std::move(hypothesis), std::move(*found));
  }
  replay::DeclaredModel declared;
  data::Run run;
  std::vector<replay::Record> records;
  std::optional<Scored> scored;
};

// From a stiffness a thousand times too high the slope says nothing; what the data allow begins decades below.
TEST(Intervals, ReachOverDecadesOfAMagnitude) {
  Stopped rigid({stop, 1000.0 * stop_stiffness, 1.0}, 0);
  const std::vector<Estimate> all = estimates(rigid.records, *rigid.scored, 1.0);
  ASSERT_EQ(all.size(), 4U);
  const Estimate& stiffness = all[3];
  EXPECT_GT(stiffness.lower, 0.05 * stop_stiffness);
  EXPECT_LT(stiffness.lower, stop_stiffness);
  EXPECT_GT(stiffness.upper, stop_stiffness);
  EXPECT_TRUE(stiffness.determined);
  EXPECT_LT(all[2].lower, stop);
  EXPECT_GT(all[2].upper, stop);
}

TEST(Intervals, LeadOutOfAPoorFit) {
  Stopped poor({0.7 * stop, 0.1 * stop_stiffness, 1.0}, 1);
  Stopped good({stop, stop_stiffness, 1.0}, 25);
  const double start = poor.scored->fit.chi_square;
  ASSERT_GT(start, good.scored->fit.chi_square + 10.0);
  const std::vector<Estimate> all = estimates(poor.records, *poor.scored, 1.0);
  EXPECT_NEAR(poor.scored->fit.chi_square, good.scored->fit.chi_square, 0.5);
  EXPECT_EQ(all[2].value, poor.scored->fit.values[2]);
  EXPECT_LT(all[2].lower, stop);
  EXPECT_GT(all[2].upper, stop);
}

}  // namespace
}  // namespace coilwright::measurement::compare
