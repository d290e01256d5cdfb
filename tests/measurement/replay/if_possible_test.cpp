#include "measurement/replay/if_possible.hpp"

#include <gtest/gtest.h>

#include <new>
#include <stdexcept>
#include <system_error>

namespace coilwright::measurement::replay {
namespace {

template <class Thrown>
std::optional<int> made_by_one_that_throws(Thrown thrown) {
  return if_possible<int>([&]() -> int { throw thrown; });
}

TEST(IfPossible, GivesWhatIsMade) {
  EXPECT_EQ(if_possible<int>([] { return 3; }), 3);
  EXPECT_EQ(if_possible<int>([] { return std::optional<int>(); }), std::nullopt);
}

TEST(IfPossible, GivesNothingWhereNumbersMakeNoModelOrNoMotion) {
  EXPECT_EQ(made_by_one_that_throws(std::invalid_argument("a mass below zero")), std::nullopt);
  EXPECT_EQ(made_by_one_that_throws(std::domain_error("a curve that jumps")), std::nullopt);
  EXPECT_EQ(made_by_one_that_throws(std::runtime_error("a motion that cannot be followed")), std::nullopt);
  EXPECT_EQ(made_by_one_that_throws(std::overflow_error("a function of a library")), std::nullopt);
  EXPECT_EQ(refusal_of([] { throw std::domain_error("a curve that jumps"); }), "a curve that jumps");
}

TEST(IfPossible, SwallowsNothingElse) {
  EXPECT_THROW((void)made_by_one_that_throws(std::bad_alloc()), std::bad_alloc);
  EXPECT_THROW((void)made_by_one_that_throws(std::system_error(EAGAIN, std::generic_category())), std::system_error);
  EXPECT_THROW((void)made_by_one_that_throws(std::out_of_range("an index")), std::out_of_range);
  EXPECT_THROW((void)made_by_one_that_throws(std::bad_optional_access()), std::bad_optional_access);
}

}  // namespace
}  // namespace coilwright::measurement::replay
