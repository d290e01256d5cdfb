#include "measurement/records/suspect_records.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "measurement/random_numbers.hpp"

namespace coilwright::measurement::records {
namespace {

// A motion at 120 pictures a second with noise of this many resolutions.
data::Run filmed(double noise_over_resolution) {
  constexpr double resolution = 1e-4;  // rad
  Normal normal(1);
  data::Run run{.name = "a.csv", .kind = data::RunKind::transient};
  run.channels = {{.name = "bending_angle_deg", .kind = data::ChannelKind::bending_angle, .values = {}}};
  for (int i = 0; i < 400; ++i) {
    const double time = i / 120.0;
    run.times.push_back(time);
    const double value = 0.4 * std::sin(2.0 * time) + noise_over_resolution * resolution * normal();
    run.channels.front().values.push_back(std::round(value / resolution) * resolution);
  }
  return run;
}

void freeze(data::Run& run, std::size_t first, std::size_t count) {
  std::vector<double>& values = run.channels.front().values;
  std::fill_n(values.begin() + static_cast<std::ptrdiff_t>(first), count, values[first]);
}

TEST(FrozenPictures, AreNamedWithTheirTimeWhereNoiseWouldShow) {
  data::Run run = filmed(20.0);
  EXPECT_FALSE(stalled_frames(run));
  freeze(run, 60, 9);
  EXPECT_FALSE(stalled_frames(run));
  freeze(run, 240, 30);
  const auto warning = stalled_frames(run);
  ASSERT_TRUE(warning);
  EXPECT_EQ(warning->run, "a.csv");
  EXPECT_EQ(
      warning->text,
      "bending_angle_deg is exactly the same in 30 samples from 2 s on, where its noise would show: the camera or "
      "the tracker stopped there. Leave them out of the record: they look like a finger that sticks");
}

// Half of the record frozen takes away nothing of the noise that the other half shows.
TEST(FrozenPictures, AreNamedWhereTheyAreMost) {
  data::Run run = filmed(20.0);
  freeze(run, 100, 250);
  EXPECT_TRUE(stalled_frames(run));
}

TEST(FrozenPictures, AreNoneWhereTheResolutionHidesTheNoise) {
  data::Run run = filmed(0.2);
  freeze(run, 240, 30);
  EXPECT_FALSE(stalled_frames(run));
}

}  // namespace
}  // namespace coilwright::measurement::records
