#include "cli/bench/jobs.hpp"

#include <exception>
#include <utility>

namespace coilwright::cli {

bool LongWork::begin(std::string kind, Work work) {
  std::unique_lock lock(mutex_);
  if (state_ == "running") return false;
  if (thread_.joinable()) thread_.join();  // it has ended
  kind_ = std::move(kind);
  state_ = "running";
  error_.clear();
  result_ = {};
  progress_.done = progress_.of = 0;
  thread_ = std::jthread([this, work = std::move(work)](const std::stop_token& stop) {
    text::Json result;
    std::string error;
    try {
      result = work(stop, progress_);
    } catch (const std::exception& reason) {
      error = reason.what();
    }
    const std::lock_guard own(mutex_);
    state_ = !error.empty() ? "failed" : stop.stop_requested() ? "stopped" : "done";
    result_ = std::move(result);
    error_ = std::move(error);
  });
  return true;
}

text::Json LongWork::state() const {
  const std::lock_guard lock(mutex_);
  return text::Json::object({{"kind", kind_},
                             {"state", state_},
                             {"done", progress_.done.load()},
                             {"of", progress_.of.load()},
                             {"result", result_},
                             {"error", text::text_or_null(error_)}});
}

void LongWork::stop() {
  const std::lock_guard lock(mutex_);
  thread_.request_stop();
}

}  // namespace coilwright::cli
