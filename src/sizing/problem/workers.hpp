#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <stop_token>
#include <string_view>
#include <vector>

#include "coilwright/sizing/problem/archive.hpp"

namespace coilwright::sizing {

/// A fixed number of threads that run indexed tasks.
class Workers {
 public:
  /// `threads` at the same time; 0: one per core.
  explicit Workers(unsigned threads);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  /// Calls `task(i)` for every i below `count`, in any order, and returns when all calls have ended. If calls throw, it
  /// throws the exception of the lowest index.
  void run(std::size_t count, const std::function<void(std::size_t)>& task);

  /// Evaluates designs into `archive`, numbers them and returns their records, both in the given order. After a request
  /// to stop it leaves out the designs that are not begun. `proposed_by` says what proposed design i; empty: nothing.
  [[nodiscard]] std::vector<Record> evaluate(Archive& archive, const std::vector<std::vector<double>>& points,
                                             const std::stop_token& stop,
                                             const std::function<std::string_view(std::size_t i)>& proposed_by = {});

 private:
  struct Arena;
  std::unique_ptr<Arena> arena_;
};

}  // namespace coilwright::sizing
