// The program reads what the laboratory writes: both know the formats from their documents alone.

#include <gtest/gtest.h>

#include <set>

#include "attribution/laboratory/plan.hpp"
#include "coilwright/formats/data/dataset_file.hpp"
#include "coilwright/formats/data/declared_actuator.hpp"
#include "coilwright/formats/data/experiment_file.hpp"
#include "temporary_folder.hpp"
#include "truth/laboratory/laboratory_set.hpp"

namespace attribution::laboratory {
namespace {

namespace formats = coilwright::formats;

TEST(LaboratoryFormats, AreReadByTheProgram) {
  std::set<std::string> seen;
  for (Case& each : plan(PlanName::development)) {
    if (!seen.insert(joined(each.conditions)).second) continue;
    each.request.hidden.clear();
    each.request.values.clear();
    const coilwright::testing::TemporaryFolder folder;
    const auto set = truth::laboratory::make_laboratory_set(each.request);
    truth::laboratory::write_laboratory_set(set, folder.path() / "set");
    truth::laboratory::write_experiment(set, folder.path() / "experiment");
    const formats::DatasetFile read = formats::read_dataset(folder.path() / "set");
    EXPECT_EQ(read.data.still.size(), each.request.noise.still_run ? 1u : 0u) << joined(each.conditions);
    std::size_t fit = 0;
    for (const auto& run : set.runs) fit += run.planned.validate ? 0 : 1;
    EXPECT_EQ(read.data.fit.size(), fit) << joined(each.conditions);
    const auto declared = formats::read_declared_actuator(
        read.actuator.value(), {.names = read.calibrate, .file = read.file, .tolerances = read.tolerances});
    const bool exact = each.request.tolerances == truth::laboratory::Tolerances::exact;
    EXPECT_EQ(declared.model.calibration.size() == 2, exact) << joined(each.conditions);
    EXPECT_NO_THROW((void)formats::read_experiment(folder.path() / "experiment/experiment.json"))
        << joined(each.conditions);
  }
  EXPECT_GT(seen.size(), 40u);
}

}  // namespace
}  // namespace attribution::laboratory
