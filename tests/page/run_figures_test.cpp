#include "page/run_figures.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "temporary_folder.hpp"

namespace coilwright::page {
namespace {

// A sine that fits the record: its amplitude at its line, nothing elsewhere, whatever the mean and whether the count is
// even or odd.
TEST(Spectrum, HasTheAmplitudeOfASine) {
  for (const int count : {120, 121}) {
    std::vector<double> values;
    for (int i = 0; i < count; ++i)
      values.push_back(7.0 + 0.3 * std::sin(2.0 * std::numbers::pi * 5.0 * i / count + 0.4));
    const Spectrum spectrum = spectrum_of(values, 0.01);
    ASSERT_EQ(spectrum.frequencies.size(), 60U);
    EXPECT_NEAR(spectrum.frequencies[4], 5.0 / (0.01 * count), 1e-12);
    for (std::size_t i = 0; i < spectrum.amplitudes.size(); ++i)
      EXPECT_NEAR(spectrum.amplitudes[i], i == 4 ? 0.3 : 0.0, 1e-12) << i;
  }
}

// Parseval: the squares of a record are those of its lines, with half of each sine's amplitude squared; the last line
// of an even record is no sine but its own mirror image.
TEST(Spectrum, KeepsTheSquares) {
  std::vector<double> values{0.3, -1.2, 2.2, 0.7, -0.4, 1.9, -2.5, 0.1, 0.8, -1.7};
  double mean = 0.0;
  for (const double value : values) mean += value / 10.0;
  double squares = 0.0;
  for (const double value : values) squares += (value - mean) * (value - mean) / 10.0;
  double lines = 0.0;
  const Spectrum spectrum = spectrum_of(values, 1.0);
  for (std::size_t i = 0; i < spectrum.amplitudes.size(); ++i)
    lines += (i + 1 == spectrum.amplitudes.size() ? 1.0 : 0.5) * spectrum.amplitudes[i] * spectrum.amplitudes[i];
  EXPECT_NEAR(lines, squares, 1e-14);
  EXPECT_TRUE(spectrum_of({1.0, 2.0}, 1.0).frequencies.empty());
}

TEST(Runs, AreReadWithWhatEachModelLeavesOver) {
  const coilwright::testing::TemporaryFolder folder;
  folder.file("residuals.csv",
              "run,role,channel,time_s,angle_deg,current_A,left_out,measured,declared,before,after\n"
              "a.csv,fit,theta_deg,0,,,0,1.5,1,1.25,1.25\n"
              "a.csv,fit,theta_deg,0.1,,,0,2.5,,2.25,2.25\n"
              "b.csv,validate,torque_Nmm,,30,,0,4,5,3,4.5\n");
  const std::vector<RunRecord> runs = read_runs(folder.path());
  ASSERT_EQ(runs.size(), 2U);
  EXPECT_EQ(runs[0].measured, (std::vector<double>{1.5, 2.5}));
  ASSERT_EQ(runs[0].predictions.size(), 2U);  // with effects: the same as fitted anew
  EXPECT_EQ(runs[0].predictions[0].x, (std::vector<double>{0.0}));
  EXPECT_EQ(runs[0].predictions[1].residual, (std::vector<double>{0.25, 0.25}));
  EXPECT_EQ(runs[1].axis, "angle_deg");
  ASSERT_EQ(runs[1].predictions.size(), 3U);
  EXPECT_EQ(runs[1].predictions[2].residual, (std::vector<double>{-0.5}));
}

TEST(Runs, BridgeOutliersInWhatIsLeftOver) {
  const coilwright::testing::TemporaryFolder folder;
  folder.file("residuals.csv",
              "run,role,channel,time_s,angle_deg,current_A,left_out,measured,declared,before,after\n"
              "a.csv,fit,theta_deg,0,,,1,9,1,1,1\n"
              "a.csv,fit,theta_deg,0.1,,,0,1.5,1,1,1\n"
              "a.csv,fit,theta_deg,0.2,,,1,-7,1,1,1\n"
              "a.csv,fit,theta_deg,0.3,,,0,2.5,1,1,1\n");
  const std::vector<RunRecord> runs = read_runs(folder.path());
  ASSERT_EQ(runs.size(), 1U);
  EXPECT_EQ(runs[0].outliers, 2U);
  EXPECT_EQ(runs[0].measured, (std::vector<double>{9.0, 1.5, -7.0, 2.5}));
  EXPECT_EQ(runs[0].predictions[0].residual, (std::vector<double>{0.5, 0.5, 1.0, 1.5}));
  EXPECT_THAT(run_figures(runs[0], 1)[1].description,
              ::testing::HasSubstr("Samples left out as outliers (2) are bridged."));
}

}  // namespace
}  // namespace coilwright::page
