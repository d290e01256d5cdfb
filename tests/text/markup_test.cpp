#include "coilwright/text/markup.hpp"

#include <gtest/gtest.h>

namespace coilwright::text {
namespace {

TEST(Markup, HasNoSignOfItsOwnInAText) {
  EXPECT_EQ(escaped("<a href=\"x\">'&'</a>\x01"), "&lt;a href=&quot;x&quot;&gt;&#39;&amp;&#39;&lt;/a&gt;?");
}

TEST(Markup, KeepsLinesWhereTheyAreAskedFor) {
  EXPECT_EQ(escaped_lines("a\n\tb<\n"), "a\n\tb&lt;\n");
  EXPECT_EQ(escaped_lines(""), "");
}

TEST(ClassOfColumn, IsThatOfNumbersWhereThereIsNothingElse) {
  const std::vector<std::vector<std::string>> rows{{"1.5", "", "2", ""}, {"-2e-05", "3", "2 mm", ""}};
  EXPECT_EQ(class_of_column(rows, 0), " class=\"number\"");
  EXPECT_EQ(class_of_column(rows, 1), " class=\"number\"");
  EXPECT_EQ(class_of_column(rows, 2), "");
  EXPECT_EQ(class_of_column(rows, 3), "");
}

TEST(ScriptJson, CannotEndTheElementThatItStandsIn) {
  EXPECT_EQ(script_json("{\n  \"a\": \"</script>  <!--\",\n  \"b\": [1, 2]\n}\n"),
            "{\"a\": \"\\u003c/script>  \\u003c!--\",\"b\": [1, 2]}");
}

}  // namespace
}  // namespace coilwright::text
