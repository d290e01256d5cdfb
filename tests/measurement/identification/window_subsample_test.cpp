#include "measurement/identification/window_subsample.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <set>
#include <vector>

#include "measurement/random_numbers.hpp"
#include "measurement/slider_model.hpp"

namespace coilwright::measurement::identification {
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

TEST(WindowSubsample, AreAsManyAsTheSearchNeeds) {
  const data::Run run = run_in_windows(12000);
  std::vector<replay::PreparedRun> all{prepared(run)};
  auto some = WindowSubsample::of(all);
  ASSERT_TRUE(some);
  ASSERT_EQ(some->runs().size(), 1U);
  const replay::PreparedRun& kept = some->runs().front();
  EXPECT_EQ(kept.windows.size(), 40U);  // of 120: 4,000 samples
  EXPECT_EQ(kept.run, &run);
  EXPECT_EQ(kept.noise.front().sigma, all.front().noise.front().sigma);
  EXPECT_EQ(some->text(), "40 of 120 windows");
  EXPECT_EQ(all.front().windows.size(), 120U);
}

TEST(WindowSubsample, AreOneOfEachBlockAtUnevenPlaces) {
  const data::Run run = run_in_windows(12000);
  std::vector<replay::PreparedRun> all{prepared(run)};
  auto some = WindowSubsample::of(all);
  ASSERT_TRUE(some);
  const replay::PreparedRun& kept = some->runs().front();
  std::set<std::size_t> places;
  for (std::size_t block = 0; block < kept.windows.size(); ++block) {
    const std::size_t window = kept.windows[block].range.first / 100;
    EXPECT_EQ(window / 3, block);
    places.insert(window % 3);
  }
  EXPECT_EQ(places.size(), 3U);
}

TEST(WindowSubsample, AreSixOfARunAtLeastAndAllOfShortRecords) {
  const data::Run short_record = run_in_windows(3000);
  std::vector<replay::PreparedRun> short_run{prepared(short_record)};
  EXPECT_FALSE(WindowSubsample::of(short_run));

  const data::Run long_record = run_in_windows(12000);
  const data::Run few_windows = run_in_windows(1300);
  std::vector<replay::PreparedRun> all{prepared(long_record), prepared(few_windows)};
  auto some = WindowSubsample::of(all);
  ASSERT_TRUE(some);
  EXPECT_EQ(some->runs()[0].windows.size(), 40U);
  EXPECT_EQ(some->runs()[1].windows.size(), 7U);  // blocks of two
}

TEST(WindowSubsample, TellAllOfTheirOutliers) {
  const data::Run run = run_in_windows(12000);
  std::vector<replay::PreparedRun> all{prepared(run)};
  auto some = WindowSubsample::of(all);
  ASSERT_TRUE(some);
  some->runs().front().set_aside = {std::vector<char>(12000, 0)};
  some->runs().front().set_aside.front()[17] = 1;
  some->runs().front().noise.front().sigma *= 0.5;
  const double sigma = some->runs().front().noise.front().sigma;
  some->hand_on_outliers();
  EXPECT_TRUE(all.front().is_set_aside(0, 17));
  EXPECT_FALSE(all.front().is_set_aside(0, 18));
  EXPECT_EQ(all.front().noise.front().sigma, sigma);
}

}  // namespace
}  // namespace coilwright::measurement::identification
