#include "cli/bench/newest.hpp"

#include <utility>

namespace coilwright::cli {

NewestFirst::Turn::Turn(NewestFirst& all, std::string page) : all_(all), page_(std::move(page)) {
  std::unique_lock lock(all_.mutex_);
  number_ = ++all_.asked_;
  all_.newest_[page_] = number_;
  all_.changed_.notify_all();
  all_.changed_.wait(lock, [&] { return !all_.busy_ || all_.newest_[page_] != number_; });
  if (all_.newest_[page_] != number_) throw Superseded();
  all_.busy_ = true;
}

NewestFirst::Turn::~Turn() {
  const std::lock_guard lock(all_.mutex_);
  all_.busy_ = false;
  if (const auto own = all_.newest_.find(page_); own != all_.newest_.end() && own->second == number_)
    all_.newest_.erase(own);
  all_.changed_.notify_all();
}

void NewestFirst::Turn::require_wanted() const {
  const std::lock_guard lock(all_.mutex_);
  const auto own = all_.newest_.find(page_);
  if (own == all_.newest_.end() || own->second != number_) throw Superseded();
}

}  // namespace coilwright::cli
