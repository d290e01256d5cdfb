#include "measurement/compare/thinned_windows.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <set>
#include <vector>

#include "measurement/random_numbers.hpp"
#include "measurement/slider_model.hpp"

namespace coilwright::measurement::compare {
namespace {

data::Run run_in_windows(std::size_t samples) {
  Normal normal(4);
  data::Run run = slide_run(samples, {}, [&] { return noise_sigma * normal(); });
  run.start = data::Start::free;
  run.window = 1.0;  // s, 100 samples
  return run;
}

replay::PreparedRun prepared(const data::Run& run) {
  const replay::DeclaredModel declared = slide(true_mass, true_damping);
  const fit::Hypothesis plain(declared, {});
  return replay::prepare_run(run, declared, plain.model_at(plain.start()));
}

TEST(ThinnedWindows, KeepAsManySamplesAsTheSearchNeeds) {
  const data::Run run = run_in_windows(12000);
  const std::vector<replay::PreparedRun> runs{prepared(run)};
  const auto some = thinned(runs);
  ASSERT_TRUE(some);
  ASSERT_EQ(some->size(), 1U);
  EXPECT_EQ(some->front().windows.size(), 40U);  // of 120: 4,000 samples
  EXPECT_EQ(some->front().run, &run);
  EXPECT_EQ(some->front().noise.front().sigma, runs.front().noise.front().sigma);
}

TEST(ThinnedWindows, AreOneOfEachBlockAtUnevenPlaces) {
  const data::Run run = run_in_windows(12000);
  const std::vector<replay::PreparedRun> runs{prepared(run)};
  const auto some = thinned(runs);
  ASSERT_TRUE(some);
  std::set<std::size_t> places;
  for (std::size_t block = 0; block < some->front().windows.size(); ++block) {
    const std::size_t window = some->front().windows[block].range.first / 100;
    EXPECT_EQ(window / 3, block);
    places.insert(window % 3);
  }
  EXPECT_EQ(places.size(), 3U);
}

TEST(ThinnedWindows, LeaveSixWindowsOfARunAndShortRecordsAsTheyAre) {
  const data::Run short_record = run_in_windows(3000);
  EXPECT_FALSE(thinned(std::vector<replay::PreparedRun>{prepared(short_record)}));

  const data::Run long_record = run_in_windows(12000);
  const data::Run few_windows = run_in_windows(1300);
  const auto some = thinned(std::vector<replay::PreparedRun>{prepared(long_record), prepared(few_windows)});
  ASSERT_TRUE(some);
  EXPECT_EQ(some->front().windows.size(), 40U);
  EXPECT_EQ((*some)[1].windows.size(), 7U);  // blocks of two
}

}  // namespace
}  // namespace coilwright::measurement::compare
