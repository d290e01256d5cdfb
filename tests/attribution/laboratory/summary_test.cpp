#include "attribution/laboratory/summary.hpp"

#include <gmock/gmock.h>

#include <fstream>

#include "attribution/laboratory/outcome_file.hpp"
#include "temporary_folder.hpp"

namespace attribution::laboratory {
namespace {

using testing::HasSubstr;
using testing::Not;

Outcome outcome(int number, const std::string& category, const std::vector<std::string>& hidden,
                const std::string& verdict) {
  Outcome out;
  out.number = number;
  out.category = category;
  out.conditions = {"clocks"};
  out.hidden = hidden;
  out.verdict = verdict;
  return out;
}

std::vector<Outcome> a_few() {
  std::vector<Outcome> all{
      outcome(0, "nothing", {}, "no_missing_effect"),         outcome(1, "nothing", {}, "explained"),
      outcome(2, "one", {"base_tilt"}, "explained"),          outcome(3, "one", {"coil_lag"}, "explained"),
      outcome(4, "two", {"coil_lag", "drag"}, "unexplained"), outcome(5, "outsider", {"gusts"}, "partly_explained"),
      outcome(6, "colour_unknown", {}, "unexplained"),        outcome(7, "far", {}, "declared_numbers_off")};
  all[0].right_verdict = true;
  all[1].false_name = all[1].explained_wrong = all[1].invented = true;
  all[1].reported = {"creep"};
  all[2].found = true;
  all[2].after_over_noise = 1.05;
  all[2].effect_intervals = {.hits = 1, .of = 2};
  all[3].invented = all[3].explained_wrong = all[3].clear_missed = true;
  all[3].after_over_noise = 1.3;
  all[4].visible = false;
  all[5].corrected_over_before = 1.03;
  all[5].excess_left = 0.4;
  all[5].state_dependent = true;
  all[6].warned = true;
  all[7].right_verdict = true;
  all[7].conditions = {"far_numbers", "outliers"};
  return all;
}

TEST(LaboratoryFigures, CountTheSetsThatTheyName) {
  const auto all = figures(a_few());
  const auto expect = [&](const std::string& column, int hits, int of) {
    for (const Figure& figure : all) {
      if (figure.column != column) continue;
      EXPECT_EQ(figure.count.hits, hits) << column;
      EXPECT_EQ(figure.count.of, of) << column;
      return;
    }
    ADD_FAILURE() << column;
  };
  expect("false", 1, 3);
  expect("verdict", 1, 2);
  expect("far", 1, 1);
  expect("colour", 0, 1);
  expect("one", 1, 2);
  expect("further", 1, 2);
  expect("two", 0, 0);  // nobody could see them
  expect("outside", 0, 1);
  expect("wrong", 2, 8);
  expect("absent", 2, 8);
  expect("missed", 1, 8);
  expect("effect ci", 1, 2);
  expect("after", 1, 2);
  expect("corrected", 1, 1);
  expect("worse", 1, 1);
}

TEST(LaboratorySummary, TellsEachFigureByConditionAndWhatWentWrong) {
  const std::string text = summary(a_few());
  EXPECT_THAT(text, HasSubstr("8 sets"));
  EXPECT_THAT(text, HasSubstr("nothing hidden: a false name"));
  EXPECT_THAT(text, HasSubstr("   1 of 3     33.3 %  at most    3 %  MISSED"));
  EXPECT_THAT(text, HasSubstr("\nclocks                          7"));
  EXPECT_THAT(text, HasSubstr("\nin pairs                        1"));
  EXPECT_THAT(text, HasSubstr("<- false name"));
  EXPECT_THAT(text, HasSubstr("<- explained and wrong"));
  EXPECT_THAT(text, HasSubstr("<- correction worse"));
  EXPECT_THAT(text, Not(HasSubstr("base_tilt")));
  EXPECT_THAT(text, Not(HasSubstr("declared_numbers_off ")));
  EXPECT_THAT(text, Not(HasSubstr(" s\n")));  // no times
}

TEST(OutcomeFile, GivesBackWhatWasWritten) {
  const coilwright::testing::TemporaryFolder folder;
  const std::vector<Outcome> all = a_few();
  for (std::size_t i = all.size(); i-- > 0;)
    write_outcome(all[i], folder.path() / (std::to_string(all[i].number) + ".json"));
  const std::vector<Outcome> back = read_outcomes(folder.path());
  EXPECT_EQ(summary(back), summary(all));
  EXPECT_EQ(back[2].after_over_noise, all[2].after_over_noise);
  EXPECT_EQ(back[2].excess_left, std::nullopt);
  std::ofstream(folder.path() / "9.json") << "{\"number\": 9}";
  try {
    (void)read_outcomes(folder.path());
    ADD_FAILURE();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("9.json: must be an outcome of the benchmark"));
  }
}

}  // namespace
}  // namespace attribution::laboratory
