#include "coilwright/measurement/data/data_quality.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <random>

#include "degree.hpp"

namespace coilwright::measurement::data {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

enum class Noise { none, some };

// A sine of 40 degrees at 2 Hz after half a second at rest, recorded at 500 Hz with the resolution of a camera, 0.02
// deg.
data::Run sine(Noise noise) {
  std::mt19937 random(20240311);  // any fixed seed
  std::normal_distribution<double> error(0.0, noise == Noise::some ? 0.3 : 0.0);
  data::Run run{.name = "sine.csv", .kind = RunKind::transient};
  Channel channel{.name = "bending_angle_deg", .kind = ChannelKind::bending_angle};
  for (int i = 0; i < 1500; ++i) {
    const double time = i / 500.0;
    const double phase = time < 0.5 ? 0.0 : std::sin(4.0 * std::numbers::pi * (time - 0.5));
    run.times.push_back(time);
    run.inputs.push_back({1.1 * phase});
    const double shown = 40.0 * phase + (noise == Noise::some ? error(random) : 0.0);
    channel.values.push_back(std::round(shown / 0.02) * 0.02 * degree);
  }
  run.channels.push_back(channel);
  return run;
}

auto only(const std::string& text) {
  return ElementsAre(AllOf(Field(&Warning::run, "sine.csv"), Field(&Warning::text, HasSubstr(text))));
}

TEST(DataQuality, FindsNothingInAGoodRun) {
  EXPECT_THAT(data_quality_warnings(sine(Noise::some)), IsEmpty());
  EXPECT_THAT(data_quality_warnings(sine(Noise::none)), IsEmpty());
}

TEST(DataQuality, AcceptsANoiselessStepThatComesToRest) {
  data::Run run = sine(Noise::none);
  for (std::size_t i = 0; i < run.samples(); ++i) {
    const double time = run.times[i];
    run.inputs[i] = {time < 0.1 ? 0.0 : 1.4};
    // Without noise it shows the very same number from the end of the motion on.
    const double shown = time < 0.1 ? 0.0 : 50.0 * (1.0 - std::exp(-(time - 0.1) / 0.05));
    run.channels[0].values[i] = std::round(shown / 0.02) * 0.02 * degree;
  }
  EXPECT_THAT(data_quality_warnings(run), IsEmpty());
}

TEST(DataQuality, NamesAConstantInput) {
  data::Run run = sine(Noise::some);
  run.inputs.assign(run.samples(), {0.7});
  EXPECT_THAT(data_quality_warnings(run), only("the input never moves"));
  run.start = Start::free;  // a release is driven by where it starts
  EXPECT_THAT(data_quality_warnings(run), IsEmpty());
}

TEST(DataQuality, NamesAChannelThatNeverChanges) {
  data::Run run = sine(Noise::some);
  run.channels[0].values.assign(run.samples(), 12.0 * degree);
  EXPECT_THAT(data_quality_warnings(run), only("bending_angle_deg is 12 deg in every sample"));
}

TEST(DataQuality, NamesASaturatedSensor) {
  for (const Noise noise : {Noise::none, Noise::some}) {
    data::Run run = sine(noise);
    for (double& angle : run.channels[0].values) angle = std::min(angle, 31.0 * degree);
    EXPECT_THAT(data_quality_warnings(run), only("stays at exactly 31 deg, its extreme"));
  }
}

TEST(DataQuality, NamesAGapInTheClock) {
  data::Run run = sine(Noise::some);
  for (std::size_t i = 700; i < run.samples(); ++i) run.times[i] += 0.5;
  EXPECT_THAT(data_quality_warnings(run),
              only("the clock jumps by 0.502 s after 1.398 s, 251 times the usual interval"));
}

TEST(DataQuality, NamesMillisecondsTakenForSeconds) {
  data::Run run = sine(Noise::some);
  for (double& time : run.times) time *= 1e3;
  EXPECT_THAT(data_quality_warnings(run),
              only("a sample every 2 s for 2998 s shows no motion of such a finger and is long to simulate: is the "
                   "unit right? time_ms are milliseconds"));
}

TEST(DataQuality, AcceptsUnevenSampling) {
  data::Run run = sine(Noise::some);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> interval(0.0005, 0.006);
  for (std::size_t i = 1; i < run.samples(); ++i) run.times[i] = run.times[i - 1] + interval(random);
  EXPECT_THAT(data_quality_warnings(run), IsEmpty());
}

TEST(DataQuality, NamesUnitsThatCannotBeRight) {
  data::Run run = sine(Noise::some);
  for (double& angle : run.channels[0].values) angle /= degree;
  EXPECT_THAT(data_quality_warnings(run), only("deg, more than two turns: is the unit right?"));
  run = sine(Noise::some);
  for (auto& sample : run.inputs) sample[0] *= 1e3;
  EXPECT_THAT(data_quality_warnings(run), only("a current of 1099.91 A is commanded"));
  run.drive = Drive::torque;
  EXPECT_THAT(data_quality_warnings(run), IsEmpty());
  const data::Run warm{
      .name = "sine.csv",
      .kind = RunKind::temperature,
      .times = {0.0, 1.0, 2.5},
      .inputs = {{0.7}, {0.7}, {0.7}},
      .channels = {{.name = "temperature_degC", .kind = ChannelKind::temperature, .values = {298.1, 305.2, 511.0}}}};
  EXPECT_THAT(data_quality_warnings(warm), only("temperature_degC goes from 298.1 to 511 degC"));
}

}  // namespace
}  // namespace coilwright::measurement::data
