#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace coilwright::measurement::identification {

/// How long fits of one kind take: the mean of those that were made.
class PaceOfFits {
 public:
  using Clock = std::chrono::steady_clock;

  void add(std::size_t fits, Clock::duration took);
  /// ", about 40 s" for so many more; empty as long as none was made.
  [[nodiscard]] std::string text(std::size_t more) const;

 private:
  std::size_t fits_ = 0;
  Clock::duration took_{};
};

}  // namespace coilwright::measurement::identification
