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

TEST(HtmlTable, SetsColumnsOfNumbersApartAndLetsNamesBreak) {
  EXPECT_EQ(html_table({"mass_g", "n", "at"}, {{"1.5", "", "2"}, {"-2e-05", "", "2 <mm"}}, "A & B"),
            "<table>\n<caption>A &amp; B</caption>\n<thead><tr><th scope=\"col\" class=\"number\">mass_<wbr>g</th>"
            "<th scope=\"col\">n</th><th scope=\"col\">at</th></tr></thead>\n<tbody>\n"
            "<tr><td class=\"number\">1.5</td><td></td><td>2</td></tr>\n"
            "<tr><td class=\"number\">-2e-05</td><td></td><td>2 &lt;mm</td></tr>\n</tbody>\n</table>\n");
}

TEST(HtmlTable, OfManyColumnsCarriesTheirHeadingsInEachCell) {
  const std::string table = html_table({"a", "b", "\"c\"", "d"}, {{"1", "2", "3", "x"}});
  EXPECT_TRUE(table.starts_with("<table class=\"stack\">\n<thead>"));
  EXPECT_NE(table.find("<td class=\"number\" data-label=\"&quot;c&quot;\">3</td>"), std::string::npos);
}

TEST(ScriptJson, CannotEndTheElementThatItStandsIn) {
  EXPECT_EQ(script_json("{\n  \"a\": \"</script>  <!--\",\n  \"b\": [1, 2]\n}\n"),
            "{\"a\": \"\\u003c/script>  \\u003c!--\",\"b\": [1, 2]}");
}

}  // namespace
}  // namespace coilwright::text
