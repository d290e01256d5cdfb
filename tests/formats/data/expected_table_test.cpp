#include "coilwright/formats/data/diagnosis_tables.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <stdexcept>

#include "degree.hpp"
#include "error_text.hpp"

namespace coilwright::formats {
namespace {

using measurement::data::ChannelKind;
using measurement::planning::NextExperiment;

std::string table_of(const NextExperiment& next) {
  std::ostringstream out;
  write_expected_readings(out, next);
  return out.str();
}

TEST(ExpectedTable, HasAColumnForEachExplanationInTheUnitOfTheChannel) {
  const NextExperiment next{.explanations = {{"base_tilt", "dry_friction"}, {"angle_offset"}, {}, {"angle_offset"}},
                            .expected = {{.run = "next_release.csv",
                                          .channel = "bending_angle_deg",
                                          .kind = ChannelKind::bending_angle,
                                          .noise = 0.5 * degree,
                                          .at = {0.0, 0.25},
                                          .values = {{1.0 * degree, 2.0 * degree},
                                                     {3.0 * degree, 4.0 * degree},
                                                     {0.0, 0.0},
                                                     {-8.0 * degree, 16.0 * degree}}},
                                         {.run = "next_torque.csv",
                                          .channel = "torque_Nmm",
                                          .kind = ChannelKind::torque,
                                          .noise = 0.5 / 1e3,
                                          .at = {5.0 * degree},
                                          .values = {{1.0 / 1e3}, {2.0 / 1e3}, {4.0 / 1e3}, {8.0 / 1e3}}}}};
  EXPECT_EQ(table_of(next),
            "run,channel,time_s,angle_deg,noise,base_tilt+dry_friction,angle_offset,no effect,angle_offset (2)\n"
            "next_release.csv,bending_angle_deg,0,,0.5,1,3,0,-8\n"
            "next_release.csv,bending_angle_deg,0.25,,0.5,2,4,0,16\n"
            "next_torque.csv,torque_Nmm,,5,0.5,1,2,4,8\n");
}

TEST(ExpectedTable, WantsAValueOfEachExplanationForEachSample) {
  const NextExperiment next{.explanations = {{"base_tilt"}, {"angle_offset"}},
                            .expected = {{.run = "next_release.csv",
                                          .channel = "bending_angle_deg",
                                          .kind = ChannelKind::bending_angle,
                                          .noise = 0.0,
                                          .at = {0.0, 1.0},
                                          .values = {{1.0, 2.0}, {3.0}}}}};
  EXPECT_EQ(error_text([&] { (void)table_of(next); }),
            "readings of bending_angle_deg in next_release.csv: each of 2 explanations must have 2 values");
}

}  // namespace
}  // namespace coilwright::formats
