#include "coilwright/measurement/data/repeated_runs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include "measurement/random_numbers.hpp"

namespace coilwright::measurement::data {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr double turn = 2.0 * std::numbers::pi;

// Two seconds at 200 pictures a second, with noise of 0.3 deg that differs from one record to the next.
Run motion(const std::function<double(double)>& input, const std::function<double(double)>& angle_deg) {
  static Normal normal(11);
  Run out{.name = "a.csv", .kind = RunKind::transient};
  Channel channel{.name = "bending_angle_deg", .kind = ChannelKind::bending_angle};
  for (int i = 0; i < 400; ++i) {
    const double time = 0.005 * i;
    out.times.push_back(time);
    out.inputs.push_back({input(time)});
    channel.values.push_back(degree * (angle_deg(time) + 0.3 * normal()));
  }
  out.channels = {std::move(channel)};
  return out;
}

Run step(double size, double begin) {
  return motion([=](double time) { return time >= begin ? size : 0.0; },
                [=](double time) {
                  return 20.0 + (time >= begin ? 30.0 * size * (1.0 - std::exp((begin - time) / 0.05)) : 0.0);
                });
}

Run sine(double rate, double begin) {
  return motion([=](double time) { return 0.7 + 0.5 * std::sin(turn * rate * (time - begin)); },
                [=](double time) { return 45.0 + 20.0 * std::sin(turn * rate * (time - begin) - 0.4); });
}

Run release(double from, double begin) {
  return motion([](double) { return 0.0; },
                [=](double time) { return 20.0 + from * (time >= begin ? std::exp((begin - time) / 0.3) : 1.0); });
}

TEST(RepeatedRuns, AreOneExperimentWhereverItBegins) {
  EXPECT_TRUE(is_repeated(step(0.7, 0.3), step(0.7, 0.42)));
  EXPECT_TRUE(is_repeated(sine(1.0, 0.0), sine(1.0, 0.1)));
  EXPECT_TRUE(is_repeated(release(40.0, 0.2), release(40.0, 0.5)));
  data::Run slower_camera = step(0.7, 0.3);
  for (std::size_t i = 0; 2 * i < slower_camera.times.size(); ++i) {
    slower_camera.times[i] = slower_camera.times[2 * i];
    slower_camera.inputs[i] = slower_camera.inputs[2 * i];
    slower_camera.channels[0].values[i] = slower_camera.channels[0].values[2 * i];
  }
  slower_camera.times.resize(200);
  slower_camera.inputs.resize(200);
  slower_camera.channels[0].values.resize(200);
  EXPECT_TRUE(is_repeated(step(0.7, 0.3), slower_camera));
}

TEST(RepeatedRuns, AreNoneOfAnotherSizeRateRigOrStart) {
  EXPECT_FALSE(is_repeated(step(0.7, 0.3), step(1.0, 0.3)));
  EXPECT_FALSE(is_repeated(sine(1.0, 0.0), sine(3.0, 0.0)));
  EXPECT_FALSE(is_repeated(sine(1.0, 0.0), step(0.7, 0.3)));
  EXPECT_FALSE(is_repeated(release(40.0, 0.2), release(20.0, 0.2)));
  data::Run heavy = step(0.7, 0.3);
  heavy.rig.tip_mass = 0.005;
  EXPECT_FALSE(is_repeated(step(0.7, 0.3), heavy));
  const data::Run copied = step(0.7, 0.3);
  EXPECT_FALSE(is_repeated(copied, copied));
}

TEST(RepeatedRuns, ShareTheFirstOneThatTheyRepeat) {
  const std::vector<data::Run> runs{step(0.7, 0.3), sine(1.0, 0.0), step(0.7, 0.4),
                                    sine(3.0, 0.0), sine(1.0, 0.1), step(0.7, 0.2)};
  EXPECT_EQ(experiments_of(runs), (std::vector<std::size_t>{0, 1, 0, 3, 1, 0}));
}

TEST(StillRuns, AreThoseInWhichNothingMoves) {
  const auto none = [](double) { return 0.0; };
  EXPECT_TRUE(nothing_moves(motion(none, [](double) { return 20.0; })));
  EXPECT_TRUE(nothing_moves(motion([](double) { return 1.4; }, [](double) { return 60.0; })));
  EXPECT_FALSE(nothing_moves(step(0.7, 0.3)));
  EXPECT_FALSE(nothing_moves(release(40.0, 0.2)));
  EXPECT_FALSE(nothing_moves(release(3.0, 0.2)));
  EXPECT_FALSE(
      nothing_moves(motion(none, [](double time) { return 20.0 + 3.0 * std::exp(-time) * std::sin(40.0 * time); })));
  EXPECT_FALSE(nothing_moves(motion([](double time) { return time < 1.0 ? 0.0 : 0.1; }, [](double) { return 20.0; })));
}

}  // namespace
}  // namespace coilwright::measurement::data
