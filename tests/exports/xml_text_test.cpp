#include "exports/chain/bodies.hpp"

#include <gtest/gtest.h>

namespace coilwright::exports {
namespace {

// A comment may hold no two hyphens in a row and must not end with one: XML 1.0, production 15.
TEST(CommentText, HasNoTwoHyphensInARowAndNoneAtTheEnd) {
  for (const char* text : {"--set gap_mm=1", "a---b", "----", "ends-", "-"}) {
    const std::string made = comment_text(text);
    EXPECT_EQ(made.find("--"), std::string::npos) << made;
    EXPECT_NE(made.back(), '-') << made;
  }
  EXPECT_EQ(comment_text("a - b, c-d"), "a - b, c-d");
  EXPECT_EQ(comment_text(""), "");
}

TEST(XmlText, ReadsBackWhateverANameHas) {
  const std::string name = "a \"b\" <c> & 'd' \xC3\xA9";
  pugi::xml_document document;
  add(document, "actuator", {{"name", name}});
  set(document.child("actuator"), {{"mass", 0.1 + 0.2}});
  pugi::xml_document read;
  ASSERT_TRUE(read.load_string(text_of(document).c_str()));
  EXPECT_EQ(read.child("actuator").attribute("name").value(), name);
  EXPECT_EQ(read.child("actuator").attribute("mass").as_double(), 0.1 + 0.2);
}

}  // namespace
}  // namespace coilwright::exports
