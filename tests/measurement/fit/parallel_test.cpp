#include "measurement/fit/parallel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <new>
#include <stdexcept>
#include <vector>

namespace coilwright::measurement::fit {
namespace {

TEST(Parallel, CallsEveryIndexOnce) {
  std::vector<int> calls(1000);
  with_threads(3, [&] { in_parallel(calls.size(), [&](std::size_t i) { ++calls[i]; }); });
  EXPECT_EQ(calls, std::vector<int>(1000, 1));
  with_threads(0, [] { in_parallel(0, [](std::size_t) { FAIL(); }); });
}

// A fit simulates its runs in a loop inside of the loop over all fits: what it then holds must be whole, whatever
// becomes of a fit beside it.
TEST(Parallel, LeavesNoLoopHalfDoneWithoutSayingSo) {
  for (int round = 0; round < 50; ++round) {
    std::atomic<int> whole = 0, halves = 0, given_up = 0;
    const auto one = [&](std::size_t i) {
      if (i == 17) throw std::bad_alloc();
      std::atomic<int> done = 0;
      try {
        in_parallel(20, [&](std::size_t) { ++done; });
      } catch (const GivenUp&) {
        ++given_up;
        throw;
      }
      ++(done == 20 ? whole : halves);
    };
    EXPECT_THROW(with_threads(4, [&] { in_parallel(40, one); }), std::bad_alloc);
    EXPECT_EQ(halves, 0);
    EXPECT_LT(whole, 40);
  }
}

// That of a task, and not what came of it elsewhere.
TEST(Parallel, ThrowsWhatATaskThrew) {
  const auto outer = [](std::size_t) {
    in_parallel(50, [](std::size_t k) {
      if (k == 20) throw std::runtime_error("the one");
    });
  };
  for (int round = 0; round < 50; ++round)
    EXPECT_THROW(with_threads(4, [&] { in_parallel(50, outer); }), std::runtime_error);
}

}  // namespace
}  // namespace coilwright::measurement::fit
