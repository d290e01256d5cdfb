#include "coilwright/page/page_html.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <string>

namespace coilwright::page {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* hostile = "</script><script>alert(1)</script>\"'&";

Page hostile_page() {
  Page page{.title = hostile, .verdict = hostile, .origin = hostile, .inputs = {hostile}, .sections = {}, .data = {}};
  Figure figure{
      .id = "f", .title = hostile, .description = hostile, .content = text::Json::object({{"title", hostile}})};
  figure.table = {.header = {hostile}, .rows = {{hostile}}};
  page.sections.push_back({.id = "s", .title = hostile, .blocks = {Lines{hostile}, Lines{hostile}, figure}});
  page.data.push_back({.id = "d", .json = text::Json::object({{"name", hostile}}).text()});
  return page;
}

std::string html_of(const Page& page) {
  const std::array<Script, 1> scripts{{{.name = "own", .text = "let ours;", .licence = "MIT <of it>"}}};
  return to_html(page, {.scripts = scripts, .style = "p{}"}, [](std::string_view) { return std::string("n0nce"); });
}

TEST(PageHtml, LeavesNothingOfATextAsMarkup) {
  const std::string html = html_of(hostile_page());
  EXPECT_THAT(html, Not(HasSubstr("<script>alert")));
  EXPECT_THAT(html, Not(HasSubstr("</script><script>")));
  EXPECT_THAT(html, HasSubstr("\\u003c/script>\\u003cscript>alert(1)"));
  EXPECT_THAT(html, HasSubstr("MIT &lt;of it&gt;"));
}

// The first stop of the keyboard.
TEST(PageHtml, HasTheNavigationBeforeTheListOfFiles) {
  const std::string html = html_of(hostile_page());
  const std::size_t files = html.find("<summary>The files that it is made of (1)");
  ASSERT_NE(files, std::string::npos);
  EXPECT_LT(html.find("<nav"), files);
}

TEST(PageHtml, LetsOnlyItsOwnScriptsRun) {
  const std::string html = html_of(hostile_page());
  EXPECT_THAT(html, HasSubstr("default-src 'none'; script-src 'nonce-n0nce'; style-src 'nonce-n0nce'; img-src data:"));
  EXPECT_THAT(html, HasSubstr("<script nonce=\"n0nce\">let ours;"));
  for (const char* loose : {"unsafe-inline", "unsafe-eval", "http://", "<link", "<iframe", "src=\"//"})
    EXPECT_THAT(html, Not(HasSubstr(loose)));
}

TEST(PageHtml, HasAHeadingATextAndATableForEachFigure) {
  Page page{.title = "t", .verdict = "v", .origin = "o", .sections = {}, .data = {}};
  Figure figure{.id = "f", .title = "The figure", .description = "What is seen.", .content = text::Json::object()};
  figure.table = {.header = {"a", "b"}, .rows = {{"1.5", "word"}}, .note = "one row in 2"};
  page.sections.push_back({.id = "s", .title = "S", .blocks = {figure}});
  const std::string html = html_of(page);
  EXPECT_THAT(html, HasSubstr("<h3>The figure</h3>"));
  EXPECT_THAT(html, HasSubstr("id=\"f-plot\" role=\"img\" aria-label=\"What is seen.\""));
  EXPECT_THAT(html, HasSubstr("(1 rows, one row in 2)"));
  EXPECT_THAT(html, HasSubstr("<td class=\"number\">1.5</td><td>word</td>"));
}

}  // namespace
}  // namespace coilwright::page
