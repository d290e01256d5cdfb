#pragma once

#include <algorithm>
#include <cstddef>
#include <list>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace coilwright::measurement::replay {

/// Remembers the results of an expensive pure function by its numbers, and forgets the one that was asked for the
/// longest ago. A fit asks for the same numbers again and again while it moves others. Safe from any thread; the same
/// numbers may be worked out twice, to the same result.
template <class Result>
class LruMemo {
 public:
  template <class Make>
  [[nodiscard]] std::shared_ptr<const Result> get(const std::vector<double>& numbers, Make&& make) {
    {
      const std::lock_guard lock(mutex_);
      const auto found = std::ranges::find(results_, numbers, &Entry::first);
      if (found != results_.end()) {
        results_.splice(results_.begin(), results_, found);
        return found->second;
      }
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
  std::list<Entry> results_;  // the one asked for last at the front
};

}  // namespace coilwright::measurement::replay
