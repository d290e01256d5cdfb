#include "coilwright/formats/data/diagnosis_tables.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <numbers>
#include <sstream>

#include "error_text.hpp"

namespace coilwright::formats {
namespace {

using measurement::Replay;
using measurement::data::ChannelKind;

// As the reader turns a file's degrees into radians: with one rounding for the factor, so that they come back.
constexpr double degrees_read(double value) {
  return value * std::numbers::pi / 180.0;
}

std::string table_of(const std::vector<Replay>& replays) {
  std::ostringstream out;
  write_residuals(out, replays);
  return out.str();
}

TEST(ResidualTable, HasAColumnMoreWhereThereIsANamelessCorrection) {
  const Replay bare{.run = "a.csv",
                    .kind = ChannelKind::torque,
                    .channel = "torque_Nmm",
                    .at = {0.0},
                    .measured = {0.5 / 1e3},
                    .declared = {1.0 / 1e3},
                    .before = {2.0 / 1e3},
                    .after = {4.0 / 1e3}};
  Replay corrected = bare;
  corrected.run = "b.csv";
  corrected.corrected = {8.0 / 1e3};
  EXPECT_EQ(table_of({bare, corrected}),
            "run,role,channel,time_s,angle_deg,current_A,left_out,measured,declared,before,after,corrected\n"
            "a.csv,fit,torque_Nmm,,0,,0,0.5,1,2,4,\n"
            "b.csv,fit,torque_Nmm,,0,,0,0.5,1,2,4,8\n");
}

TEST(ResidualTable, HasARowASampleInTheUnitOfItsChannel) {
  const std::vector<Replay> replays = {{.run = "step.csv",
                                        .validate = false,
                                        .kind = ChannelKind::bending_angle,
                                        .channel = "bending_angle_deg",
                                        .at = {0.0, 0.002},
                                        .measured = {degrees_read(30.0), degrees_read(30.02)},
                                        .declared = {degrees_read(31.0), degrees_read(31.5)},
                                        .before = {degrees_read(30.5), degrees_read(30.25)},
                                        .after = {degrees_read(30.1), std::numeric_limits<double>::quiet_NaN()},
                                        .left_out = {0, 1}},
                                       {.run = "bench.csv",
                                        .validate = true,
                                        .kind = ChannelKind::torque,
                                        .channel = "torque_Nmm",
                                        .at = {degrees_read(20.0)},
                                        .measured = {12.3 / 1e3},
                                        .declared = {12.1 / 1e3},
                                        .before = {12.2 / 1e3},
                                        .after = {12.4 / 1e3}},
                                       {.run = "wall, firm.csv",
                                        .validate = false,
                                        .kind = ChannelKind::force,
                                        .channel = "force_N",
                                        .at = {1.4},
                                        .measured = {1.19},
                                        .declared = {1.0},
                                        .before = {1.1},
                                        .after = {1.2}},
                                       {.run = "hot.csv",
                                        .validate = false,
                                        .kind = ChannelKind::temperature,
                                        .channel = "temperature_degC",
                                        .at = {60.0},
                                        .measured = {80.5},
                                        .declared = {70.0},
                                        .before = {75.0},
                                        .after = {80.0}}};
  EXPECT_EQ(table_of(replays),
            "run,role,channel,time_s,angle_deg,current_A,left_out,measured,declared,before,after\n"
            "step.csv,fit,bending_angle_deg,0,,,0,30,31,30.5,30.1\n"
            "step.csv,fit,bending_angle_deg,0.002,,,1,30.02,31.5,30.25,\n"
            "bench.csv,validate,torque_Nmm,,20,,0,12.3,12.1,12.2,12.4\n"
            "\"wall, firm.csv\",fit,force_N,,,1.4,0,1.19,1,1.1,1.2\n"
            "hot.csv,fit,temperature_degC,60,,,0,80.5,70,75,80\n");
}

TEST(ResidualTable, HasNoNegativeZero) {
  const std::vector<Replay> replays = {{.run = "a.csv",
                                        .kind = ChannelKind::bending_angle,
                                        .channel = "bending_angle_deg",
                                        .at = {-0.0},
                                        .measured = {-0.0},
                                        .declared = {degrees_read(-0.5)},
                                        .before = {-0.0},
                                        .after = {0.0}}};
  EXPECT_THAT(table_of(replays), ::testing::EndsWith("\na.csv,fit,bending_angle_deg,0,,,0,0,-0.5,0,0\n"));
}

TEST(ResidualTable, RefusesVectorsOfUnequalLengthBeforeItWrites) {
  std::ostringstream out;
  const std::vector<Replay> replays = {{.run = "a.csv", .channel = "force_N", .at = {1.0}, .measured = {1.0, 2.0}}};
  EXPECT_EQ(error_text([&] { write_residuals(out, replays); }),
            "replay of force_N in a.csv: vectors must be 2 long; got 1");
  const std::vector<Replay> flagged = {{.run = "a.csv",
                                        .channel = "force_N",
                                        .at = {1.0},
                                        .measured = {1.0},
                                        .declared = {1.0},
                                        .before = {1.0},
                                        .after = {1.0},
                                        .left_out = {0, 1}}};
  EXPECT_EQ(error_text([&] { write_residuals(out, flagged); }),
            "replay of force_N in a.csv: left_out must be empty or 1 long; got 2");
  EXPECT_EQ(out.str(), "");
}

}  // namespace
}  // namespace coilwright::formats
