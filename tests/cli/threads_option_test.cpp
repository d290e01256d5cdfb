#include "cli/options.hpp"

#include <gtest/gtest.h>
#include <sched.h>

#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace coilwright::cli {
namespace {

int threads_of(std::vector<std::string> arguments) {
  CLI::App app;
  int threads = 0;
  add_threads_option(app, threads, "Fits made at once");
  app.parse(std::move(arguments));  // CLI11 takes them last first
  return threads;
}

// While it lives, this thread may run on one core only.
class OneCore {
 public:
  OneCore() {
    sched_getaffinity(0, sizeof(before_), &before_);
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(sched_getcpu(), &one);
    sched_setaffinity(0, sizeof(one), &one);
  }
  ~OneCore() { sched_setaffinity(0, sizeof(before_), &before_); }
  OneCore(const OneCore&) = delete;
  OneCore& operator=(const OneCore&) = delete;

 private:
  cpu_set_t before_{};
};

TEST(ThreadsOption, TakesWhatTheMachineOffers) {
  EXPECT_EQ(threads_of({}), 0);
  EXPECT_EQ(threads_of({"0", "--threads"}), 0);
  EXPECT_EQ(threads_of({"1", "--threads"}), 1);
}

TEST(ThreadsOption, CountsMoreThanTheCoresAsTheirNumber) {
  EXPECT_LE(threads_of({"1024", "--threads"}), static_cast<int>(std::thread::hardware_concurrency()));
  const OneCore only;
  EXPECT_EQ(threads_of({"2", "--threads"}), 1);
  EXPECT_EQ(threads_of({"1024", "--threads"}), 1);
  EXPECT_EQ(threads_of({"0", "--threads"}), 0);
}

}  // namespace
}  // namespace coilwright::cli
