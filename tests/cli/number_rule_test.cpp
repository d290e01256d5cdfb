#include "cli/options.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

namespace coilwright::cli {
namespace {

std::string complaint(const std::string& argument, const text::Rule& rule = text::finite) {
  CLI::App app;
  double value{};
  app.add_option("--current", value)->check(number_rule(rule));
  try {
    app.parse(std::vector<std::string>{argument, "--current"});  // CLI11 takes them last first
  } catch (const CLI::ParseError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(NumberRule, TakesNumbersThatTheRuleAllows) {
  EXPECT_EQ(complaint("-1.4"), "accepted");
  EXPECT_EQ(complaint("2.5e-3", text::positive), "accepted");
}

TEST(NumberRule, RefusesWhatIsNoFiniteNumber) {
  for (const std::string argument : {"nan", "inf", "-inf", "1e999", "abc", "1,5", "0x10", "3A"}) {
    EXPECT_EQ(complaint(argument), "--current: must be a finite number; got \"" + argument + "\"");
  }
}

TEST(NumberRule, RefusesWhatTheRuleForbids) {
  EXPECT_EQ(complaint("0", text::positive), "--current: must be > 0; got \"0\"");
  EXPECT_EQ(complaint("7", text::Rule::between(2, 5)), "--current: must be from 2 to 5; got \"7\"");
}

// The number that an integer option has after the argument, or the complaint.
std::string whole(const std::string& argument, const text::Rule& rule) {
  CLI::App app;
  std::int64_t value{};
  app.add_option("--pieces", value)->transform(whole_number_rule(rule));
  try {
    app.parse(std::vector<std::string>{argument, "--pieces"});
  } catch (const CLI::ParseError& error) {
    return error.what();
  }
  return std::to_string(value);
}

constexpr double exact = 9007199254740992.0;  // 2^53

TEST(WholeNumberRule, TakesWholeNumbersHoweverTheyAreWritten) {
  const text::Rule rule = text::Rule::between(-5, exact);
  EXPECT_EQ(whole("3", rule), "3");
  EXPECT_EQ(whole("-2", rule), "-2");
  EXPECT_EQ(whole("2e3", rule), "2000");
  EXPECT_EQ(whole("4.0", rule), "4");
  EXPECT_EQ(whole("010", rule), "10");  // and not eight
  EXPECT_EQ(whole("9007199254740991", rule), "9007199254740991");
  EXPECT_EQ(whole("9007199254740992", rule), "9007199254740992");
}

TEST(WholeNumberRule, RefusesWithOptionRuleAndValue) {
  const text::Rule rule = text::Rule::between(1, 6);
  for (const std::string argument : {"2.5", "abc", "", "nan", "1e999", "3A", "0x3"})
    EXPECT_EQ(whole(argument, rule), "--pieces: must be a whole number; got \"" + argument + "\"");
  EXPECT_EQ(whole("7", rule), "--pieces: must be from 1 to 6; got \"7\"");
}

TEST(WholeNumberRule, DoesNotRoundWhatIsTooLarge) {
  EXPECT_EQ(whole("9007199254740993", text::Rule::between(0, exact)),
            "--pieces: must be from 0 to 9007199254740992; got \"9007199254740993\"");
}

}  // namespace
}  // namespace coilwright::cli
