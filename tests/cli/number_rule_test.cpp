#include "cli/number_rule.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace coilwright::cli
