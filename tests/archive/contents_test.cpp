// What an archive is of, and what may be answered from it.
#include "coilwright/archive/contents.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "sizing/small_study.hpp"

namespace coilwright::archive {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

Contents of(const sizing::Study& study) {
  return {.command = "pareto",
          .study = study.name,
          .program = {.version = "0.1.0", .commit = "abcdef0123", .build = ""},
          .inputs = {{.file = "study.json", .sha256 = "1111111111", .text = "{}"}},
          .changes = {},
          .question = "q",
          .physics = {.actuator = "a", .operation = "o", .systems = ""},
          .algorithm = "automatic",
          .seed = 5,
          .columns = columns_of(study)};
}

TEST(Columns, AreUniqueWhateverTheCaseOfTheirLetters) {
  sizing::Study study = sizing::testing::small_study();
  simulation::ResultQuantity mine = sizing::testing::quantity("mass_g");
  mine.name = "MASS_g";
  study.quantities = study.quantities.with(mine);
  mine.name = "gap_mm";  // a variable too
  study.quantities = study.quantities.with(mine);
  mine.name = "status";  // of every archive
  study.quantities = study.quantities.with(mine);
  const std::vector<Column> columns = columns_of(study);
  const auto column = [&](Role role, const std::string& name) {
    return std::ranges::find_if(columns, [&](const Column& each) { return each.role == role && each.name == name; })
        ->column;
  };
  EXPECT_EQ(column(Role::quantity, "mass_g"), "mass_g");
  EXPECT_EQ(column(Role::quantity, "MASS_g"), "MASS_g_2");
  EXPECT_EQ(column(Role::variable, "gap_mm"), "gap_mm");
  EXPECT_EQ(column(Role::quantity, "gap_mm"), "gap_mm_2");
  EXPECT_EQ(column(Role::quantity, "status"), "status_2");
  EXPECT_EQ(column(Role::constraint, "mass_g <= 66"), "constraint_1");
  EXPECT_EQ(column(Role::objective, "mass_g"), "objective_2");
}

TEST(Differences, SayWhatKeepsARunFromGoingOn) {
  const Contents found = of(sizing::testing::small_study());
  EXPECT_THAT(differences(found, found), IsEmpty());
  Contents asked = found;
  asked.command = "size";
  asked.seed = 6;
  EXPECT_THAT(differences(found, asked), ElementsAre("command pareto, not size", "seed 5, not seed 6"));
  asked = found;
  asked.seed = std::nullopt;
  asked.algorithm = "";
  EXPECT_THAT(differences(found, asked), ElementsAre("algorithm automatic, not none", "seed 5, not no seed"));
  asked = found;
  asked.inputs[0].sha256 = "2222222222";
  asked.changes = {"gap_mm=1", "duty=0.5"};
  EXPECT_THAT(differences(found, asked), ElementsAre("study.json with another content (SHA-256 11111111, not 22222222)",
                                                     "no --set, not --set gap_mm=1 --set duty=0.5"));
  asked = found;
  asked.program.commit = "fedcba9876";
  EXPECT_THAT(differences(found, asked),
              ElementsAre("coilwright 0.1.0 (commit abcdef0), not 0.1.0 (commit fedcba9), whose numbers may differ"));
  asked = found;
  asked.physics.operation = "p";
  EXPECT_THAT(differences(found, asked), ElementsAre("other columns or physics, though its inputs are the same"));
}

TEST(DifferencesForReuse, AllowOtherGoalsAndRangesOfTheSameVariables) {
  sizing::Study study = sizing::testing::small_study();
  const Contents found = of(study);
  study.objectives.pop_back();
  study.limits.clear();
  std::ranges::reverse(study.variables);
  Contents asked = of(study);
  asked.command = "size";
  asked.seed = 9;
  asked.inputs[0].sha256 = "2222222222";
  EXPECT_THAT(differences_for_reuse(found, asked), IsEmpty());
}

TEST(DifferencesForReuse, SayWhatDoesNotMatch) {
  sizing::Study study = sizing::testing::small_study();
  const Contents found = of(study);
  study.variables.pop_back();
  simulation::ResultQuantity mine = sizing::testing::quantity("mass_g");
  mine.name = "mine";
  study.quantities = study.quantities.with(mine);
  Contents asked = of(study);
  asked.physics = {.actuator = "b", .operation = "p", .systems = "q"};
  EXPECT_THAT(differences_for_reuse(found, asked),
              ElementsAre("another actuator", "another operating point",
                          "another study of what is built from the actuator (gripper, crawler, driver, spread)",
                          "variables configuration, gap_mm, turns_radial, wire_gauge_AWG, not configuration, gap_mm, "
                          "turns_radial",
                          "no quantity mine as this study has it"));
}

}  // namespace
}  // namespace coilwright::archive
