// Records as laboratories make them, by the independent simulation: what once led a diagnosis astray.

#include <gmock/gmock.h>

#include <algorithm>
#include <string>
#include <vector>

#include "coilwright/formats/data/dataset_file.hpp"
#include "coilwright/formats/data/declared_actuator.hpp"
#include "coilwright/measurement/diagnosis.hpp"
#include "temporary_folder.hpp"
#include "truth/laboratory/laboratory_set.hpp"

namespace coilwright::measurement {
namespace {

Diagnosis diagnosis_of(const truth::laboratory::Request& request) {
  const testing::TemporaryFolder folder;
  truth::laboratory::write_laboratory_set(truth::laboratory::make_laboratory_set(request), folder.path());
  const formats::DatasetFile set = formats::read_dataset(folder.path());
  const formats::DeclaredActuator declared = formats::read_declared_actuator(
      set.actuator.value(), {.names = set.calibrate, .file = set.file, .tolerances = set.tolerances});
  return diagnose(set.data, declared.model);
}

// Ids of the effects that are reported, and of those that stand in a set with one.
std::vector<std::string> named(const Diagnosis& diagnosis) {
  std::vector<std::string> out;
  for (const AddedEffect& each : diagnosis.effects) out.emplace_back(each.kind->id());
  for (const auto& set : diagnosis.indistinguishable)
    for (const actuator::EffectKind* each : set) out.emplace_back(each->id());
  return out;
}

// Three steps and a release, filmed at 60 Hz with the input beside the pictures: each edge lies anywhere between two.
// While edges ended at the samples, a saturation of the driver "explained" this lag of 5.2 ms.
TEST(LaboratorySets, ALagIsNamedAlthoughEdgesLieBetweenPictures) {
  const Diagnosis found = diagnosis_of({.hidden = {"coil_lag"},
                                        .seed = 3,
                                        .programme = truth::laboratory::Programme::few,
                                        .camera = {.frame_rate = 60.0},
                                        .weakest = 8.0});
  EXPECT_EQ(found.verdict, Verdict::explained);
  ASSERT_EQ(found.effects.size(), 1u);
  EXPECT_THAT(named(found), ::testing::Contains("coil_lag"));
}

// Hum of 50 Hz, and no record of a finger at rest: the hold of 15 s shows it.
TEST(LaboratorySets, HumIsNoMissingEffectWhereAHoldShowsIt) {
  const Diagnosis found = diagnosis_of({.seed = 2,
                                        .programme = truth::laboratory::Programme::hold,
                                        .camera = {.frame_rate = 120.0},
                                        .noise = {.colour = truth::laboratory::Colour::hum, .sigma_given = true}});
  EXPECT_EQ(found.verdict, Verdict::no_missing_effect);
}

// The tip's mass and the torque curve far outside of their tolerances: no effect is the name of both.
TEST(LaboratorySets, SeveralNumbersThatAreOffAreNotNamedAsAnEffect) {
  const Diagnosis found = diagnosis_of({.seed = 2,
                                        .programme = truth::laboratory::Programme::few,
                                        .deviation = truth::laboratory::Deviation::far,
                                        .tolerances = truth::laboratory::Tolerances::listed,
                                        .camera = {.frame_rate = 120.0}});
  EXPECT_EQ(found.verdict, Verdict::declared_numbers_off);
  EXPECT_THAT(named(found), ::testing::IsEmpty());
}

}  // namespace
}  // namespace coilwright::measurement
