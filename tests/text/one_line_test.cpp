#include "coilwright/text/one_line.hpp"

#include <gtest/gtest.h>

#include "coilwright/text/input_error.hpp"
#include "coilwright/text/spelling.hpp"

namespace coilwright::text {
namespace {

TEST(OneLine, KeepsPlainTextAndLettersOfAnyAlphabet) {
  EXPECT_EQ(one_line("Länge λ 長 🧲"), "Länge λ 長 🧲");
}

TEST(OneLine, EscapesWhatWouldBreakTheLineOrMoveTheCursor) {
  EXPECT_EQ(one_line("a\nb\r\tc\x1b[2J\x7f"), "a\\nb\\r\\tc\\x1b[2J\\x7f");
  EXPECT_EQ(one_line("a\u2028b\u202ec\u0085d"), "a\\u2028b\\u202ec\\x85d");
}

TEST(OneLine, EscapesBytesThatAreNotUtf8) {
  EXPECT_EQ(one_line("\xff|\xc3|\xe2\x82|\xc0\x80|\xed\xa0\x80|\xf5\x80\x80\x80"),
            "\\xff|\\xc3|\\xe2\\x82|\\xc0\\x80|\\xed\\xa0\\x80|\\xf5\\x80\\x80\\x80");
}

TEST(OneLine, CutsLongTextBetweenLettersAndMarksTheCut) {
  EXPECT_EQ(one_line("abcdefgh", 8), "abcdefgh");
  EXPECT_EQ(one_line("abcdefghi", 8), "abcde...");
  EXPECT_EQ(one_line("abcäöüß", 8), "abcä...");
}

TEST(OneLine, ChangesNothingTheSecondTime) {
  for (const std::string text : {"a\nb", "\xff\xfe", "a text that is longer than twenty bytes", "plain"}) {
    const std::string once = one_line(text, 20);
    EXPECT_LE(once.size(), 20u);
    EXPECT_EQ(one_line(once, 20), once);
  }
}

TEST(InputError, IsOneLineOfFilePlaceRuleAndValue) {
  const InputError error(
      {.file = "study.json", .place = "/variables/gap_mm/upper", .rule = "must exceed lower (2)", .value = "1.5"});
  EXPECT_STREQ(error.what(), "study.json: /variables/gap_mm/upper: must exceed lower (2); got 1.5");
}

TEST(InputError, LeavesOutPlaceAndValueWhenThereIsNone) {
  EXPECT_STREQ(InputError({.file = "x.json", .rule = "cannot be opened: No such file or directory"}).what(),
               "x.json: cannot be opened: No such file or directory");
}

TEST(InputError, IsOneLineEvenWhenNamesHoldLineBreaks) {
  const InputError error({.file = "a\nb.json", .place = "/c\nd", .rule = "must be > 0", .value = "\"\n\""});
  EXPECT_STREQ(error.what(), "a\\nb.json: /c\\nd: must be > 0; got \"\\n\"");
}

TEST(Spelling, CountsInsertionsDeletionsReplacementsAndSwaps) {
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);  // the textbook pair
  EXPECT_EQ(edit_distance("evalute", "evaluate"), 1u);
  EXPECT_EQ(edit_distance("turns_radail", "turns_radial"), 1u);
  EXPECT_EQ(edit_distance("", "gap"), 3u);
}

TEST(Spelling, SuggestsTheNearestWordAndNothingFarOff) {
  const std::vector<std::string> words = {"evaluate", "validate", "pareto"};
  EXPECT_EQ(did_you_mean("evalute", words), "; did you mean \"evaluate\"?");
  EXPECT_EQ(did_you_mean("vaildate", words), "; did you mean \"validate\"?");
  EXPECT_EQ(did_you_mean("banana", words), "");
  EXPECT_EQ(did_you_mean("E", std::vector<std::string>{"A", "B"}), "");
}

TEST(Spelling, SuggestsWhatBeginsWithTheWord) {
  const std::vector<std::string> words = {"mass_g", "maximise", "--max-evaluations", "--json", "gap_mm", "gas_mm"};
  EXPECT_EQ(did_you_mean("mass", words), "; did you mean \"mass_g\"?");
  EXPECT_EQ(did_you_mean("--max", words), "; did you mean \"--max-evaluations\"?");
  EXPECT_EQ(did_you_mean("ga", words), "; did you mean \"gap_mm\" or \"gas_mm\"?");
  EXPECT_EQ(did_you_mean("mass_g", words), "");
}

TEST(Spelling, SuggestsWhatHasTheWordAmongItsWords) {
  const std::vector<std::string> words = {"temperature_ripple_K", "coil_temperature_degC", "peak_bending_speed_deg_s",
                                          "speeding_g"};
  EXPECT_EQ(did_you_mean("temperature", words),
            "; did you mean \"temperature_ripple_K\" or \"coil_temperature_degC\"?");
  EXPECT_EQ(did_you_mean("bending_speed", words), "; did you mean \"peak_bending_speed_deg_s\"?");
  EXPECT_EQ(did_you_mean("ending", words), "");
  const std::vector<std::string> options = {"--supply-voltage-V", "--cell-voltage-V", "--duty"};
  EXPECT_EQ(did_you_mean("--voltage-V", options), "; did you mean \"--supply-voltage-V\" or \"--cell-voltage-V\"?");
  EXPECT_EQ(did_you_mean("--", options), "");
}

TEST(Spelling, SuggestsAllThatAreEquallyNear) {
  EXPECT_EQ(did_you_mean("N55", std::vector<std::string>{"N35", "N35M", "N50", "N52"}),
            "; did you mean \"N35\", \"N50\" or \"N52\"?");
  EXPECT_EQ(did_you_mean("N55", std::vector<std::string>{"N35", "N45", "N50", "N52", "N58"}), "");
}

TEST(Spelling, SuggestsNothingThatBeginsWithOneLetterOrWithDashes) {
  const std::vector<std::string> words = {"--json", "maximise"};
  EXPECT_EQ(did_you_mean("--j", words), "");
  EXPECT_EQ(did_you_mean("m", words), "");
  EXPECT_EQ(did_you_mean("--", words), "");
}

TEST(Spelling, ListsNoMoreThanFourWords) {
  std::vector<std::string> words = {"angle_1", "angle_2", "angle_3", "angle_4"};
  EXPECT_EQ(did_you_mean("angle", words), "; did you mean \"angle_1\", \"angle_2\", \"angle_3\" or \"angle_4\"?");
  words.emplace_back("angle_of_the_base");
  EXPECT_EQ(did_you_mean("ang", words), "");
}

}  // namespace
}  // namespace coilwright::text
