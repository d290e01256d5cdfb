#include "coilwright/text/variant.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace coilwright::text {
namespace {

struct Uncopied {
  Uncopied() = default;
  Uncopied(const Uncopied&) { throw std::runtime_error("no memory"); }
  Uncopied& operator=(const Uncopied&) = default;
};

TEST(Variant, LeavesNothingOfACopyThatFails) {
  using Content = Variant<double, bool, int, long, char, std::string, std::vector<Uncopied>>;
  const Content whole{std::vector<Uncopied>(2)};
  for (int i = 0; i < 100; ++i) {
    // What lies where the copy begins must not matter.
    const std::vector<Content> before(3, Content{std::string(100, 'a')});
    EXPECT_THROW(Content{whole}, std::runtime_error);
  }
  EXPECT_EQ(std::get<std::vector<Uncopied>>(whole).size(), 2);
}

TEST(Variant, IsCopiedWithItsContent) {
  const Variant<double, std::string> text{std::string(100, 'a')};
  const Variant<double, std::string> copy = text;
  EXPECT_EQ(copy, text);
  EXPECT_EQ(std::get<std::string>(copy), std::string(100, 'a'));
}

}  // namespace
}  // namespace coilwright::text
