#include "coilwright/report/simulation/document.hpp"

#include <gmock/gmock.h>

#include <string>
#include <variant>

#include "coilwright/text/input_error.hpp"
#include "coilwright/text/json/document.hpp"

namespace coilwright::report {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Document document() {
  return {
      .title = "small: minimise mass_g",
      .verdict = "The smallest mass_g found is 61.25.",
      .cautions = {"BEWARE: it breaks\n  voltage_V 30, at most 24: it arcs\n"},
      .sections = {{.id = "limits",
                    .title = "Limits",
                    .blocks = {BarChart{.id = "margins",
                                        .title = "Margins",
                                        .description = "How far.",
                                        .value_title = "margin, %",
                                        .label_title = "limit",
                                        .bars = {{.label = "mass_g <= 70", .value = 12.5, .group = "kept"}},
                                        .symbols = true},
                               TableBlock{.caption = "Limits of the study",
                                          .table = {.header = {"limit", "value"}, .rows = {{"mass_g <= 70", "61.25"}}},
                                          .align = {TextTable::Align::left},
                                          .headed = false},
                               Lines{"One <p>\n  if it is: so\n    then worse\n  or so\nAnother\n"}}},
                   {.id = "empty", .title = "Of nothing"}}};
}

TEST(Document, IsALineABlockOnATerminal) {
  EXPECT_EQ(to_text(document()),
            "small: minimise mass_g\n"
            "\nThe smallest mass_g found is 61.25.\n"
            "\nBEWARE: it breaks\n  voltage_V 30, at most 24: it arcs\n"
            "\nLimits\n"
            "  mass_g <= 70  61.25\n"
            "One <p>\n  if it is: so\n    then worse\n  or so\nAnother\n");
}

TEST(Document, MakesListsOfLinesThatAreFurtherIn) {
  EXPECT_EQ(to_html(Lines{"One <p>\n  if so\n    worse\n\n  or so\nAnother\n        deep"}),
            "<p>One &lt;p&gt;</p>\n<ul><li>if so<ul><li>worse</li></ul>\n</li>\n<li>or so</li></ul>\n<p>Another</p>\n"
            "<ul><li>deep</li></ul>\n");
  EXPECT_EQ(to_html(Lines{}), "");
}

TEST(Document, HasItsTablesAndNoChartsInANotebook) {
  const std::string html = to_html(document());
  EXPECT_THAT(html, HasSubstr("<td>mass_<wbr>g &lt;= 70</td>"));
  EXPECT_THAT(html, HasSubstr("<li>voltage_V 30, at most 24: it arcs</li>"));
  EXPECT_THAT(html, Not(HasSubstr("Of nothing")));
}

TEST(Document, IsReadBackAsItWasWritten) {
  const std::string json = to_json(document()).text();
  const Document back = read_document(text::parse_json(json, "result.json").root());
  EXPECT_EQ(to_json(back).text(), json);
  EXPECT_EQ(std::get<BarChart>(back.sections[0].blocks[0]).bars[0].value, 12.5);
}

TEST(Document, IsRefusedWhereARowIsShort) {
  std::string json = to_json(document()).text();
  const std::string row = R"(["mass_g <= 70", "61.25"])";
  json.replace(json.find(row), row.size(), R"(["mass_g <= 70"])");
  EXPECT_THROW((void)read_document(text::parse_json(json, "result.json").root()), text::InputError);
}

}  // namespace
}  // namespace coilwright::report
