#include "attribution/summary.hpp"

#include <gmock/gmock.h>

#include "attribution/made_diagnosis.hpp"

namespace attribution {
namespace {

using coilwright::measurement::Verdict;
using testing::HasSubstr;
using testing::Not;

std::vector<Outcome> a_few() {
  std::vector<Outcome> outcomes{
      outcome_of(Category::one, {"force_gain"}, diagnosed(Verdict::explained, {"force_gain"})),
      outcome_of(Category::one, {"force_gain"}, diagnosed(Verdict::explained, {"coil_lag"})),
      outcome_of(Category::one, {"base_tilt"},
                 diagnosed(Verdict::explained, {"rest_angle"}, {{"rest_angle", "base_tilt"}})),
      outcome_of(Category::nothing, {}, diagnosed(Verdict::no_missing_effect, {})),
      outcome_of(Category::nothing, {}, diagnosed(Verdict::unexplained, {})),
      outcome_of(Category::two, {"base_tilt", "coil_lag"}, diagnosed(Verdict::partly_explained, {"coil_lag"})),
      outcome_of(Category::outsider, {"shaken_base"}, diagnosed(Verdict::unexplained, {})),
      outcome_of(Category::outsider, {"mains_hum"}, diagnosed(Verdict::explained, {"coil_lag"})),
  };
  outcomes[0].error_over_floor = 1.02;
  outcomes[1].error_over_floor = 1.3;
  outcomes[2].error_over_floor = 1.1;
  outcomes[0].effect_intervals = {.hits = 1, .of = 1};
  outcomes[2].answer.hidden[0].confounders = {"rest_angle"};
  outcomes[2].determined = false;
  return outcomes;
}

Count count_of(const std::vector<Aim>& all, std::string_view text) {
  for (const Aim& aim : all)
    if (aim.text.find(text) != std::string::npos) return aim.count;
  ADD_FAILURE() << text;
  return {};
}

TEST(Aims, CountTheSetsThatTheyName) {
  const auto all = aims(a_few());
  const auto expect = [&](std::string_view text, int hits, int of) {
    const Count count = count_of(all, text);
    EXPECT_EQ(count.hits, hits) << text;
    EXPECT_EQ(count.of, of) << text;
  };
  expect("false alarms", 1, 2);
  expect("hidden effect first", 2, 3);
  expect("alone and right", 1, 2);
  expect("both of two", 0, 1);
  expect("outsiders", 1, 2);
  expect("error after", 2, 4);  // the explained outsider has none
  expect("true effect parameters", 1, 1);
}

TEST(Aims, AreReachedOnTheirBound) {
  EXPECT_TRUE((Aim{.text = "", .count = {.hits = 1, .of = 20}, .share = 0.05, .at_most = true}.reached()));
  EXPECT_FALSE((Aim{.text = "", .count = {.hits = 2, .of = 20}, .share = 0.05, .at_most = true}.reached()));
  EXPECT_TRUE((Aim{.text = "", .count = {.hits = 54, .of = 60}, .share = 0.9}.reached()));
  EXPECT_FALSE((Aim{.text = "", .count = {.hits = 53, .of = 60}, .share = 0.9}.reached()));
}

TEST(Summary, ListsOnlySetsInWhichSomethingWentWrong) {
  const std::string text = summary(a_few());
  EXPECT_THAT(text, HasSubstr("8 sets"));
  EXPECT_THAT(text, HasSubstr("<- false alarm"));
  EXPECT_THAT(text, HasSubstr("<- not found"));
  EXPECT_THAT(text, HasSubstr("<- outsider explained"));
  EXPECT_THAT(text, Not(HasSubstr("shaken_base")));
  EXPECT_THAT(text, Not(HasSubstr("not alone")));  // base_tilt has a confounder in those data
}

TEST(Confusion, HasHiddenRowsAndReportedColumns) {
  const std::string csv = confusion_csv(a_few());
  const auto cell = [&](const std::string& row, const std::string& column) {
    const auto cells = [](std::string line) {
      std::vector<std::string> out;
      for (std::size_t at = 0; (at = line.find(',')) != std::string::npos; line.erase(0, at + 1))
        out.push_back(line.substr(0, at));
      out.push_back(line);
      return out;
    };
    const auto header = cells(csv.substr(0, csv.find('\n')));
    const auto begin = csv.find("\n" + row + ",") + 1;
    const auto values = cells(csv.substr(begin, csv.find('\n', begin) - begin));
    for (std::size_t i = 0; i < header.size(); ++i)
      if (header[i] == column) return values.at(i);
    return std::string("no such column");
  };
  EXPECT_EQ(cell("force_gain", "force_gain"), "1");
  EXPECT_EQ(cell("force_gain", "coil_lag"), "1");
  EXPECT_EQ(cell("base_tilt", "rest_angle"), "1");
  EXPECT_EQ(cell("base_tilt", "coil_lag"), "0");  // one of two is not in the matrix
  EXPECT_EQ(cell("nothing", "no_missing_effect"), "1");
  EXPECT_EQ(cell("nothing", "unexplained"), "1");
  EXPECT_EQ(cell("mains_hum", "coil_lag"), "1");
}

TEST(SetsCsv, HasOneLinePerSet) {
  const std::string csv = sets_csv(a_few());
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 9);
  EXPECT_THAT(csv, HasSubstr("one,base_tilt,0.00,0.00,0,explained,rest_angle,rest_angle=base_tilt,1,0,1.100,"));
}

}  // namespace
}  // namespace attribution
