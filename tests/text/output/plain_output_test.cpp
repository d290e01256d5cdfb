// What a terminal gets of text that is a stranger's.
#include "coilwright/text/output/plain_output.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <string_view>

namespace coilwright::text {
namespace {

// What arrives where a text is printed in pieces of so many bytes.
std::string arrived(std::string_view text, bool to_terminal, std::size_t piece = 1000) {
  std::ostringstream out;
  {
    const PlainOutput plain(out, to_terminal);
    for (; !text.empty(); text.remove_prefix(std::min(piece, text.size()))) out << text.substr(0, piece);
  }
  return out.str();
}

TEST(PlainOutput, ShowsWhatATerminalWouldObeyHoweverItIsCutIntoPieces) {
  const std::string text =
      "\x1b[31mred\x07\r\xc2\x9b"
      "2J\x7f\xff\xe2\x80\xae caf\xc3\xa9 \xe2\x89\xa4 \xf0\x9f\x98\x80\t|\n";
  const std::string shown =
      "\\x1b[31mred\\x07\\r\\x9b2J\\x7f\\xff\\u202e caf\xc3\xa9 \xe2\x89\xa4 \xf0\x9f\x98\x80\t|\n";
  for (std::size_t piece = 1; piece <= text.size(); ++piece) EXPECT_EQ(arrived(text, true, piece), shown) << piece;
}

TEST(PlainOutput, KeepsElsewhereWhatJsonMayHold) {
  EXPECT_EQ(arrived("\x1b[31m\r\n\t\x7f\xc2\x9b\xff", false), "\\x1b[31m\r\n\t\x7f\xc2\x9b\xff");
}

TEST(PlainOutput, ShowsALetterThatIsNeverWhole) {
  EXPECT_EQ(arrived("a\xe2\x89", true), "a\\xe2\\x89");
  EXPECT_EQ(arrived("\xe2\x89x", true, 1), "\\xe2\\x89x");
}

TEST(PlainOutput, GivesTheStreamBackAndIsPassedByFiles) {
  std::ostringstream out;
  {
    const PlainOutput plain(out, true);
    std::ostream(PlainOutput::past(out)) << "\x1b";
    out.setstate(std::ios::failbit);
  }
  EXPECT_TRUE(out.fail());
  out.clear();
  out << "\x1b";
  EXPECT_EQ(out.str(), "\x1b\x1b");
}

}  // namespace
}  // namespace coilwright::text
