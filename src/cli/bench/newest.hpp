#pragma once

#include <condition_variable>
#include <cstdint>
#include <map>
#include <mutex>
#include <stdexcept>
#include <string>

namespace coilwright::cli {

/// Says to who asked that a later question of the same page has taken the place of this one.
class Superseded : public std::runtime_error {
 public:
  Superseded() : std::runtime_error("a later question of this page came before the answer") {}
};

/// Lets one question be answered at a time and, of those of one page that wait, only the newest: a slider that moves
/// asks more often than is answered, and nothing may queue.
class NewestFirst {
 public:
  /// The turn of a question: as long as it lives, no other has one.
  class Turn {
   public:
    /// Waits for the turn. Throws Superseded as soon as the same page asks anew.
    Turn(NewestFirst& all, std::string page);
    ~Turn();
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;

    /// Throws Superseded if the same page has asked anew, for long work to look at between its steps.
    void require_wanted() const;

   private:
    NewestFirst& all_;
    std::string page_;
    std::uint64_t number_{};
  };

 private:
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::map<std::string, std::uint64_t> newest_;  // of the pages that wait or have their turn
  std::uint64_t asked_{};
  bool busy_{};
};

}  // namespace coilwright::cli
