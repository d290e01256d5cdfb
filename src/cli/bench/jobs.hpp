#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>

#include "coilwright/text/json/json.hpp"

namespace coilwright::cli {

/// Long work of a page, one at a time: it tells how far it is and can be stopped.
class LongWork {
 public:
  /// How far the work is; its thread writes, others read.
  struct Progress {
    std::atomic<std::size_t> done{}, of{};
  };
  using Work = std::function<text::Json(const std::stop_token& stop, Progress& progress)>;

  /// Begins it. False if other work is running.
  [[nodiscard]] bool begin(std::string kind, Work work);
  /// Its kind, state ("none", "running", "done", "stopped" or "failed"), progress and, at the end, result or error.
  [[nodiscard]] text::Json state() const;
  /// Asks it to end with what it has found.
  void stop();

 private:
  mutable std::mutex mutex_;
  std::string kind_, state_ = "none", error_;
  text::Json result_;
  Progress progress_;
  std::jthread thread_;  // last: it uses the others
};

}  // namespace coilwright::cli
