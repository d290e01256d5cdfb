#include "threads_option.hpp"

#include <sched.h>

#include <algorithm>
#include <thread>

#include "number_rule.hpp"

namespace coilwright::cli {
namespace {

constexpr int most_threads = 1024;

// As TBB counts them: those that this process may run on, which hardware_concurrency does not heed. At least one.
int cores() {
  cpu_set_t allowed;
  CPU_ZERO(&allowed);
  if (sched_getaffinity(0, sizeof(allowed), &allowed) == 0) return CPU_COUNT(&allowed);
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));  // more than the set can hold
}

}  // namespace

void add_threads_option(CLI::App& command, int& threads, const std::string& what) {
  command
      .add_option_function<int>(
          "--threads", [&threads](int asked) { threads = std::min(asked, cores()); },
          what + ", at most the number of cores (default 0: one for each core)")
      ->transform(whole_number_rule(text::Rule::between(0, most_threads)));
}

}  // namespace coilwright::cli
