#pragma once

#include <algorithm>
#include <deque>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace coilwright::formats {

/// The last results of a pure function that is dear, by its numbers. A fit asks for the same numbers again and again
/// while it moves others. Safe from any thread; the same numbers may be worked out twice, to the same result.
template <class Result>
class RecentResults {
 public:
  template <class Make>
  [[nodiscard]] std::shared_ptr<const Result> get(const std::vector<double>& numbers, Make&& make) {
    {
      const std::lock_guard lock(mutex_);
      const auto found = std::ranges::find(results_, numbers, &Entry::first);
      if (found != results_.end()) return found->second;
    }
    auto result = std::make_shared<const Result>(std::forward<Make>(make)());
    const std::lock_guard lock(mutex_);
    results_.emplace_front(numbers, result);
    if (results_.size() > most_results) results_.pop_back();
    return result;
  }

 private:
  using Entry = std::pair<std::vector<double>, std::shared_ptr<const Result>>;
  static constexpr std::size_t most_results = 32;  // a point of a fit, and its neighbours along each number

  std::mutex mutex_;
  std::deque<Entry> results_;
};

}  // namespace coilwright::formats
