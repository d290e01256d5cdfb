// Records of real rigs, which are not part of the project: read from $COILWRIGHT_RECORDS or ../shared/data; the tests
// are skipped if they are missing.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "coilwright/formats/data/dataset_file.hpp"
#include "coilwright/formats/data/declared_actuator.hpp"
#include "coilwright/measurement/diagnosis.hpp"

namespace coilwright::measurement {
namespace {

namespace fs = std::filesystem;

fs::path records(const std::string& name) {
  if (const char* elsewhere = std::getenv("COILWRIGHT_RECORDS")) return fs::path(elsewhere) / name;
  return fs::path(COILWRIGHT_SOURCE_DIR) / ".." / "shared" / "data" / name;
}

// The first `samples` of every `stride`-th sample: the sampling is finer than necessary.
void thin(data::Run& run, std::size_t stride, std::size_t samples) {
  const auto keep = [&](auto& values) {
    std::size_t at = 0;
    for (std::size_t i = 0; i < values.size() && at < samples; i += stride) values[at++] = values[i];
    values.resize(at);
  };
  // What is commanded between two samples that stay: the mean, so that no impulse is lost.
  for (std::size_t i = 0; i < run.inputs.size(); i += stride) {
    const std::size_t last = std::min(i + stride, run.inputs.size());
    for (std::size_t c = 0; c < run.inputs[i].size(); ++c) {
      double sum = 0.0;
      for (std::size_t k = i; k < last; ++k) sum += run.inputs[k][c];
      run.inputs[i][c] = sum / static_cast<double>(last - i);
    }
  }
  keep(run.times);
  keep(run.inputs);
  for (data::Channel& channel : run.channels) keep(channel.values);
}

struct Found {
  Diagnosis diagnosis;
  [[nodiscard]] const AddedEffect* effect(const std::string& id) const {
    for (const AddedEffect& each : diagnosis.effects)
      if (each.kind->id() == id) return &each;
    return nullptr;
  }
};

Found diagnosed(const fs::path& folder, std::size_t runs, std::size_t stride, std::size_t samples) {
  formats::DatasetFile set = formats::read_dataset(folder);
  const formats::DeclaredActuator declared = formats::read_declared_actuator(
      set.actuator.value(), {.names = set.calibrate, .file = set.file, .tolerances = set.tolerances});
  set.data.fit.resize(std::min(runs, set.data.fit.size()));
  for (data::Run& run : set.data.fit) thin(run, stride, samples);
  return {diagnose(set.data, declared.model, {.threads = 2})};
}

TEST(RealRecords, EmpsLacksDryFrictionAndMore) {
  const fs::path folder = records("emps");
  if (!fs::exists(folder)) GTEST_SKIP() << folder << " is not there";
  const Found found = diagnosed(folder, 1, 10, 600);
  EXPECT_EQ(found.diagnosis.verdict, Verdict::partly_explained);
  ASSERT_FALSE(found.diagnosis.effects.empty());
  EXPECT_EQ(found.diagnosis.effects.front().kind->id(), "dry_friction");
  // Published, from all of the record by inverse dynamics: 20.39 N, 203.5 N s/m, 95.11 kg.
  const auto holds = [](const identification::Estimate& number, double published) {
    return number.lower <= published && published <= number.upper;
  };
  const identification::Estimate& friction = found.diagnosis.effects.front().parameters.front();
  const identification::Estimate& mass = found.diagnosis.calibration.at(0);
  const identification::Estimate& damping = found.diagnosis.calibration.at(1);
  ASSERT_EQ(mass.key, "/links/0/mass_kg");
  ASSERT_EQ(damping.key, "/joints/0/damping_Nms_rad");
  EXPECT_TRUE(holds(friction, 20.39)) << friction.value << ", " << friction.lower << " to " << friction.upper;
  EXPECT_TRUE(holds(damping, 203.5)) << damping.value << ", " << damping.lower << " to " << damping.upper;
  EXPECT_TRUE(holds(mass, 95.11)) << mass.value << ", " << mass.lower << " to " << mass.upper;
  // Each takes up a part of the other; what both brake with at 0.1 m/s, the rate of most of the record, is known
  // better.
  constexpr double rate = 0.1;
  const double braking = friction.value + rate * damping.value;
  EXPECT_NEAR(braking, 20.39 + rate * 203.5, 0.03 * braking);
  EXPECT_EQ(found.diagnosis.effects.size(), 1u);
  EXPECT_EQ(found.effect("quadratic_drag"), nullptr);
  const ErrorComparison& held_out = found.diagnosis.validate_errors.front();
  RecordProperty("before_mm", std::to_string(1e3 * held_out.before.rmse));
  RecordProperty("after_mm", std::to_string(1e3 * held_out.after.rmse));
  EXPECT_LT(held_out.after.rmse, 0.5 * held_out.before.rmse);
}

}  // namespace
}  // namespace coilwright::measurement
