#include "coilwright/text/json/json.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <stdexcept>

#include "coilwright/text/json/document.hpp"

namespace coilwright::text {
namespace {

using ::testing::ThrowsMessage;

TEST(Json, KeepsTheOrderOfKeysAndPutsPlainArraysOnOneLine) {
  const std::array angles = {12.5, -3.25};
  auto result = Json::object({{"mass_g", 12.5}, {"turns", 14}, {"feasible", true}, {"note", nullptr}});
  result.set("angles_deg", Json::numbers(angles)).set("a", Json::object({{"names", Json::array({"x", "y"})}}));
  result.set("rows", Json::array({Json::object({{"k", 2}}), Json::array()}));
  EXPECT_EQ(result.text(), R"({
  "mass_g": 12.5,
  "turns": 14,
  "feasible": true,
  "note": null,
  "angles_deg": [12.5, -3.25],
  "a": {
    "names": ["x", "y"]
  },
  "rows": [
    {
      "k": 2
    },
    []
  ]
}
)");
}

TEST(Json, IsReadBackBitForBitByOurReader) {
  const std::array values = {0.1, 1.0 / 3.0, 5e-324, 1.7976931348623157e308, -2.5e-7, 123456789.125, 3.0};
  const auto document = text::parse_json(Json::object({{"a/b", Json::numbers(values)}}).text(), "x.json");
  const auto read = document.root().find("a/b")->numbers();
  EXPECT_TRUE(std::equal(values.begin(), values.end(), read.begin(), read.end()));
}

TEST(Json, EscapesTextAndReplacesWhatIsNotUtf8) {
  EXPECT_EQ(Json("a\"b\\c\nλ\x01").text(), "\"a\\\"b\\\\c\\nλ\\u0001\"\n");
  EXPECT_EQ(Json("a\xff").text(), "\"a\xef\xbf\xbd\"\n");
}

TEST(Json, BreaksLongArrays) {
  const std::string word(50, 'x');
  EXPECT_EQ(Json::array({word.c_str(), word.c_str(), word.c_str()}).text(),
            "[\n  \"" + word + "\",\n  \"" + word + "\",\n  \"" + word + "\"\n]\n");
}

TEST(Json, RefusesNumbersThatAreNotFiniteNamingTheirPlace) {
  const auto json = Json::object({{"a", Json::array({2.5, std::numeric_limits<double>::infinity()})}});
  EXPECT_THAT([&] { (void)json.text(); }, ThrowsMessage<std::invalid_argument>("/a/1 must be finite; got inf"));
  EXPECT_THAT(
      [&] {
        (void)Json::object({{"b", std::numeric_limits<double>::quiet_NaN()}}).text();
      },
      ThrowsMessage<std::invalid_argument>("/b must be finite; got nan"));
}

TEST(Json, RefusesAKeySetTwice) {
  EXPECT_THAT(
      [] {
        (void)Json::object({{"a", 2}, {"a", 3}});
      },
      ThrowsMessage<std::invalid_argument>("key a must not be set twice"));
}

}  // namespace
}  // namespace coilwright::text
