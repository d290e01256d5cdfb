#include "attribution/laboratory/visible_strength.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "attribution/laboratory/program_run.hpp"
#include "temporary_folder.hpp"

namespace attribution::laboratory {
namespace {

const std::string planned = R"({"format": "experiment-plan/1", "effects": [
  {"id": "dry_friction", "visible": true, "strength": "torque_Nmm", "smallest": {"torque_Nmm": 0.02}},
  {"id": "force_gain", "visible": true, "strength": "gain", "smallest": {"gain": 0.99}},
  {"id": "driver_saturation", "visible": true, "strength": "current_A", "smallest": {"current_A": 1.39}},
  {"id": "measurement_delay", "visible": true, "strength": "delay_ms", "smallest": {"delay_ms": 20}},
  {"id": "coil_coil_force", "visible": false, "strength": null, "strongest_tried": {}},
  {"id": "backlash", "visible": false, "strength": "gap_deg", "strongest_tried": {"gap_deg": 10}},
  {"id": "end_stop", "visible": true, "strength": "angle_deg", "smallest": {"angle_deg": 40}}]})";

TEST(VisibleStrength, IsFiveTimesThePlansFromAbsentAndWithinTheBound) {
  EXPECT_NEAR(*five_times_visible(planned, "dry_friction"), 0.1, 1e-12);
  EXPECT_NEAR(*five_times_visible(planned, "stribeck_friction"), 0.1, 1e-12);
  EXPECT_NEAR(*five_times_visible(planned, "force_gain"), 0.95, 1e-12);
  EXPECT_NEAR(*five_times_visible(planned, "driver_saturation"), 1.35, 1e-12);
  EXPECT_NEAR(*five_times_visible(planned, "measurement_delay"), 60.0, 1e-12);
  for (const char* name : {"coil_coil_force", "backlash", "end_stop", "hysteresis"})
    EXPECT_FALSE(five_times_visible(planned, name)) << name;
}

TEST(ProgramRun, GivesTheWordsAlsoOfAFailure) {
  const coilwright::testing::TemporaryFolder folder;
  EXPECT_EQ(words_of("echo hello", folder.path() / "words.txt"), "hello\n");
  try {
    (void)words_of("echo no such set; false", folder.path() / "words.txt");
    ADD_FAILURE();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "no such set\n");
  }
}

}  // namespace
}  // namespace attribution::laboratory
