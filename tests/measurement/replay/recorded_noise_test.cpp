#include "measurement/replay/recorded_noise.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <iterator>
#include <numbers>
#include <span>
#include <vector>

#include "measurement/fit/hypothesis.hpp"
#include "measurement/slider_model.hpp"

namespace coilwright::measurement::replay {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

// White noise through a filter of first order, of standard deviation `sigma`.
std::vector<double> filtered_noise(std::size_t samples, double r, double sigma, std::uint64_t seed) {
  Normal normal(seed);
  std::vector<double> out{sigma * normal()};
  while (out.size() < samples) out.push_back(r * out.back() + sigma * std::sqrt(1.0 - r * r) * normal());
  return out;
}

data::Run still_run(std::vector<double> values) {
  data::Run run{.name = "still.csv", .kind = data::RunKind::still};
  run.channels = {{.name = "theta1_rad", .kind = data::ChannelKind::joint_angle, .values = std::move(values)}};
  for (std::size_t i = 0; i < run.channels.front().values.size(); ++i)
    run.times.push_back(interval * static_cast<double>(i));
  return run;
}

struct Told {
  PreparedRun prepared{};
  const signals::NoiseLevel& level() const { return prepared.noise.front(); }
};

// What a motion whose sigma is not given takes over from a model and, where that was fitted, what it shows.
Told told_by(const DeclaredModel& declared, const data::Run& run, const std::vector<data::Run>& still,
             const std::vector<double>& shown = {}) {
  const fit::Hypothesis hypothesis(declared, {});
  const actuator::Model model = hypothesis.model_at(hypothesis.start());
  Told out{.prepared = prepare_run(run, declared, model)};
  give_recorded_noise(out.prepared, still, std::span(&run, 1), model);
  if (shown.empty()) return out;
  const Eigen::VectorXd motion = Eigen::Map<const Eigen::VectorXd>(shown.data(), std::ssize(shown));
  const std::vector<double> before = out.prepared.lines;
  const bool other =
      give_recorded_noise(std::span(&out.prepared, 1), still, std::span(&run, 1), model, std::span(&motion, 1));
  EXPECT_TRUE(other || before == out.prepared.lines);
  return out;
}

Told told(const data::Run& run, const std::vector<data::Run>& still, const std::vector<double>& shown = {}) {
  return told_by(slide(true_mass, true_damping), run, still, shown);
}

data::Run motion() {
  Normal normal(9);
  data::Run run = slide_run(300, {}, [&] { return noise_sigma * normal(); });
  run.sigma.reset();
  return run;
}

TEST(RecordedNoise, IsTakenAsWhiteWhereNothingShowsIt) {
  const data::Run run = motion();
  const Told none = told(run, {});
  EXPECT_EQ(none.level().colour,
            "taken as white: there is no still run, and the parts at rest are too short to show its colour");
  EXPECT_TRUE(none.level().from_the_run);
  EXPECT_EQ(none.prepared.whiteners.front(), nullptr);
}

struct Recorded {
  data::Run run{};
  std::vector<double> motion{};  // without noise
};

// A slide that is pushed by a constant force for 9 s, under hum of that amplitude.
Recorded long_push(double hum) {
  Normal normal(10);
  Recorded out{.run = slide_run(1000, {}, [&] { return noise_sigma * normal(); })};
  Place place{};
  for (std::size_t i = 0; i < out.run.samples(); ++i) {
    out.run.inputs[i] = {i < 100 ? 0.0 : 2.0};
    const double wave = hum * std::sin(2.0 * std::numbers::pi * 20.0 * out.run.times[i] + 0.3);
    out.motion.push_back(place.position);
    out.run.channels.front().values[i] = place.position + wave + noise_sigma * normal();
    place = slid(place, out.run.inputs[i][0], interval);
  }
  out.run.sigma.reset();
  out.run.start = data::Start::free;  // no part of it is at rest
  return out;
}

TEST(RecordedNoise, HumShowsUnderAConstantInput) {
  const Recorded with = long_push(noise_sigma);
  const Told found = told(with.run, {}, with.motion);
  EXPECT_EQ(found.level().colour,
            "taken as white but for hum at 20 Hz, which the parts under a constant input show: no still run");
  ASSERT_EQ(found.prepared.lines.size(), 1u);
  EXPECT_NEAR(found.prepared.lines.front(), 20.0, 0.02);
  EXPECT_NEAR(found.prepared.line_sizes.front(), noise_sigma, 0.2 * noise_sigma);
  EXPECT_EQ(found.prepared.whiteners.front(), nullptr);
  // What drifts there is the motion, not its noise.
  const Recorded without = long_push(0.0);
  EXPECT_THAT(told(without.run, {}, without.motion).prepared.lines, ::testing::IsEmpty());
  // A constant input is no proof of rest: that takes a model.
  EXPECT_THAT(told(with.run, {}).prepared.lines, ::testing::IsEmpty());
}

// A mass on a spring that swings by itself at that frequency.
struct Swing {
  double frequency{};       // Hz
  double damping_ratio{};   // of the critical one
  double picture_interval;  // s
  double duration{};        // s
  double amplitude = 100.0 * noise_sigma;

  [[nodiscard]] double at(double time) const {
    const double rate = 2.0 * std::numbers::pi * frequency;
    return amplitude * std::exp(-damping_ratio * rate * time) *
           std::cos(rate * std::sqrt(1.0 - damping_ratio * damping_ratio) * time);
  }

  [[nodiscard]] DeclaredModel model() const {
    DeclaredModel out = slide(true_mass, true_damping);
    const double rate = 2.0 * std::numbers::pi * frequency;
    out.build = [free = out.build, rate, ratio = damping_ratio](std::span<const double> values) {
      actuator::ModelSpec spec = free(values);
      spec.hinges.front().stiffness = true_mass * rate * rate;
      spec.hinges.front().damping = 2.0 * ratio * true_mass * rate;
      return spec;
    };
    return out;
  }

  // Let go without an input, beside noise and hum of that amplitude and frequency.
  [[nodiscard]] Recorded recorded(double hum, double hum_frequency) const {
    Normal normal(11);
    Recorded out{.run = slide_run(0, {}, no_error)};
    for (int i = 0; i * picture_interval <= duration; ++i) {
      const double time = picture_interval * i;
      out.run.times.push_back(time);
      out.run.inputs.push_back({0.0});
      out.motion.push_back(at(time));
      out.run.channels.front().values.push_back(
          at(time) + hum * std::sin(2.0 * std::numbers::pi * hum_frequency * time) + noise_sigma * normal());
    }
    out.run.sigma = noise_sigma;
    out.run.start = data::Start::free;
    return out;
  }
};

// A free swing hardly damped, one that rings down, a fast one that rare pictures show at another frequency, in all
// units of time.
const Swing swings[] = {
    {0.87, 1e-3, 1.0 / 30.0, 30.0}, {8.0, 2e-3, 0.01, 20.0}, {8.7, 1e-4, 0.1, 60.0}, {870.0, 1e-3, 1e-3 / 30.0, 0.03}};

TEST(RecordedNoise, OfASwingUnderAConstantInputHasNoHumAtItsFrequency) {
  for (const Swing& swing : swings) {
    const Recorded free = swing.recorded(0.0, 0.0);
    EXPECT_THAT(told_by(swing.model(), free.run, {}, free.motion).prepared.lines, ::testing::IsEmpty());
    // Where the model stands still as well: something shakes what is there lightly.
    Swing light = swing;
    light.amplitude = noise_sigma;
    const Recorded shaken = light.recorded(0.0, 0.0);
    const std::vector<double> still(shaken.motion.size(), 0.0);
    EXPECT_THAT(told_by(swing.model(), shaken.run, {}, still).prepared.lines, ::testing::IsEmpty());
    // Its true frequency is not the model's: nothing else hides the line.
    EXPECT_THAT(told(shaken.run, {}, still).prepared.lines, ::testing::SizeIs(1));
  }
}

TEST(RecordedNoise, OfASwingThatHasDiedAwayHasTheHumThatIsThere) {
  const Swing swing{.frequency = 8.0, .damping_ratio = 0.1, .picture_interval = 0.01, .duration = 20.0};
  const Recorded hums = swing.recorded(noise_sigma, 30.0);
  const Told found = told_by(swing.model(), hums.run, {}, hums.motion);
  ASSERT_EQ(found.prepared.lines.size(), 1u);
  EXPECT_NEAR(found.prepared.lines.front(), 30.0, 0.01);
}

TEST(RecordedNoise, OfAStillRunThatSwingsHasNoHumThere) {
  const Swing swing{.frequency = 8.0, .damping_ratio = 0.02, .picture_interval = interval, .duration = 5.0};
  std::vector<double> values = filtered_noise(2000, 0.0, 0.003, 5);
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] += 0.002 * std::sin(2.0 * std::numbers::pi * 8.3 * interval * static_cast<double>(i)) +
                 0.002 * std::sin(2.0 * std::numbers::pi * 30.0 * interval * static_cast<double>(i));
  const Told found = told_by(swing.model(), swing.recorded(0.0, 0.0).run, {still_run(values)});
  ASSERT_EQ(found.prepared.lines.size(), 1u);
  EXPECT_NEAR(found.prepared.lines.front(), 30.0, 0.01);
  EXPECT_THAT(found.level().colour, StartsWith("white, as the still run"));
}

// It was declared to start at rest, and has been pushed before.
TEST(RecordedNoise, OfWhatSwingsBeforeItsInputChangesIsNotThatOfRest) {
  const Swing swing{
      .frequency = 8.0, .damping_ratio = 2e-3, .picture_interval = interval, .duration = 6.0, .amplitude = 5e-3};
  Recorded pushed = swing.recorded(0.0, 0.0);
  for (std::size_t i = 400; i < pushed.run.samples(); ++i) pushed.run.inputs[i] = {1.0};
  pushed.run.start = data::Start::at_rest;
  pushed.run.sigma.reset();
  const Told found = told_by(swing.model(), pushed.run, {});
  EXPECT_THAT(found.level().colour,
              StartsWith("taken as white: what comes before the input changes swings at 8 Hz, as the model does"));
  EXPECT_THAT(found.prepared.lines, ::testing::IsEmpty());
  EXPECT_EQ(found.prepared.whiteners.front(), nullptr);
  EXPECT_TRUE(found.level().from_the_run);
}

TEST(RecordedNoise, OfAWhiteStillRunIsItsLevel) {
  const data::Run run = motion();
  const Told white = told(run, {still_run(filtered_noise(2000, 0.0, 0.003, 1))});
  EXPECT_THAT(white.level().colour, StartsWith("white, as the still run"));
  EXPECT_THAT(white.level().source, StartsWith("the still run, 1999 samples"));
  EXPECT_NEAR(white.level().sigma, 0.003, 4.0 * 0.003 / std::sqrt(4000.0));
  EXPECT_FALSE(white.level().from_the_run);
  EXPECT_EQ(white.prepared.whiteners.front(), nullptr);
}

TEST(RecordedNoise, OfAColouredStillRunIsWhitened) {
  const data::Run run = motion();
  const Told coloured = told(run, {still_run(filtered_noise(4000, 0.8, 0.003, 2))});
  EXPECT_THAT(coloured.level().colour, StartsWith("coloured, its spectrum from the still run in "));
  ASSERT_NE(coloured.prepared.whiteners.front(), nullptr);
  const std::vector<double> other = filtered_noise(1000, 0.8, 1.0, 3);
  Eigen::VectorXd white = Eigen::Map<const Eigen::VectorXd>(other.data(), 1000);
  coloured.prepared.whiteners.front()->apply(white);
  // Neighbours were alike by 0.8.
  EXPECT_NEAR(white.head(999).dot(white.tail(999)) / white.squaredNorm(), 0.0, 4.0 / std::sqrt(1000.0));
  EXPECT_NEAR(white.norm() / std::sqrt(1000.0), 1.0, 0.1);
}

TEST(RecordedNoise, ASigmaOfTheRunKeepsItsLevel) {
  data::Run run = motion();
  run.sigma = 0.002;
  const Told given = told(run, {still_run(filtered_noise(2000, 0.8, 0.003, 4))});
  EXPECT_EQ(given.level().sigma, 0.002);
  EXPECT_THAT(given.level().colour, StartsWith("coloured"));
}

TEST(RecordedNoise, OfHumIsALineOfTheRun) {
  const data::Run run = motion();
  std::vector<double> values = filtered_noise(2000, 0.0, 0.003, 5);
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] += 0.002 * std::sin(2.0 * std::numbers::pi * 13.0 * interval * static_cast<double>(i));
  const Told hum = told(run, {still_run(values)});
  EXPECT_THAT(hum.level().colour, HasSubstr(", hum at 13 Hz"));
  ASSERT_EQ(hum.prepared.lines.size(), 1u);
  EXPECT_NEAR(hum.prepared.lines.front(), 13.0, 0.01);
  EXPECT_NEAR(hum.prepared.line_sizes.front(), 0.002, 0.0004);
}

// Two seconds of rest before the slide is pushed, under coloured noise of 0.003 rad.
data::Run rested_run() {
  data::Run run = slide_run(300, {}, no_error);
  run.sigma.reset();
  std::vector<double>& values = run.channels.front().values;
  values.insert(values.begin(), 200, 0.0);
  run.inputs.insert(run.inputs.begin(), 200, {0.0});
  const std::vector<double> noise = filtered_noise(values.size(), 0.9, 0.003, 6);
  run.times.clear();
  for (std::size_t i = 0; i < values.size(); ++i) {
    run.times.push_back(interval * static_cast<double>(i));
    values[i] += noise[i];
  }
  return run;
}

TEST(RecordedNoise, OfThePartsAtRestCountsWhereItIsColoured) {
  const data::Run run = rested_run();
  const Told rest = told(run, {});
  EXPECT_THAT(rest.level().colour, StartsWith("coloured, its spectrum from the parts at rest"));
  EXPECT_THAT(rest.level().source, StartsWith("the parts at rest"));
  EXPECT_NE(rest.prepared.whiteners.front(), nullptr);
}

// A film's compression freezes what is still.
TEST(RecordedNoise, OfPartsAtRestThatAreFarQuieterThanTheSetSaysIsNotThatOfAMotion) {
  data::Run run = rested_run();
  run.sigma = 0.004;
  EXPECT_THAT(told(run, {}).level().colour, StartsWith("coloured, its spectrum from the parts at rest"));
  run.sigma = 0.008;
  const Told frozen = told(run, {});
  EXPECT_THAT(frozen.level().colour, StartsWith("taken as white: the parts at rest scatter by 0."));
  EXPECT_EQ(frozen.prepared.whiteners.front(), nullptr);
}

}  // namespace
}  // namespace coilwright::measurement::replay
