#include "measurement/records/worst_starts.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

#include "measurement/slider_model.hpp"

namespace coilwright::measurement::records {
namespace {

// A slide that starts as measured, and what a model leaves of it: so many times the noise in the first 15 samples, and
// in those after them.
bool is_named(double first, double rest, data::Start start = data::Start::measured, std::size_t aside = 0) {
  data::Run run = slide_run(200, {}, no_error);
  run.start = start;
  replay::PreparedRun prepared{.run = &run, .noise = {{.sigma = noise_sigma}}};
  std::vector<double> predictions = run.channels.front().values;
  for (std::size_t i = 0; i < predictions.size(); ++i) predictions[i] += noise_sigma * (i < 15 ? first : rest);
  std::vector<char> set_aside(predictions.size(), 0);
  for (std::size_t i = 0; i < aside; ++i) set_aside[i] = 1;
  prepared.set_aside = {set_aside};
  const std::vector<std::vector<double>> of_channels{predictions};
  return is_worst_at_start(prepared, of_channels);
}

TEST(WorstStarts, AreThoseOfRunsThatDoNotBeginAsTheyWereMeasured) {
  EXPECT_TRUE(is_named(40.0, 1.0));
  EXPECT_TRUE(is_named(3.1, 1.0));
  EXPECT_FALSE(is_named(1.0, 1.0));
  EXPECT_FALSE(is_named(2.9, 0.1));    // little
  EXPECT_FALSE(is_named(40.0, 20.0));  // nowhere right
  EXPECT_FALSE(is_named(40.0, 1.0, data::Start::free));
  EXPECT_FALSE(is_named(40.0, 1.0, data::Start::at_rest));
  EXPECT_FALSE(is_named(40.0, 1.0, data::Start::measured, 15));  // set aside
}

TEST(WorstStarts, AreNamedTogetherWithWhatToDo) {
  EXPECT_TRUE(worst_starts({}).empty());
  const std::vector<std::string> runs{"a.csv", "b.csv", "c.csv"};
  const std::vector<data::Warning> warnings = worst_starts(runs);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings.front().run, "a.csv");
  EXPECT_EQ(warnings.front().text,
            "what is left over is worst at the start, and so in b.csv, c.csv: it is not as the first samples say, as "
            "where the input jumps at t = 0. \"start\": \"free\" lets the fit find it");
}

}  // namespace
}  // namespace coilwright::measurement::records
