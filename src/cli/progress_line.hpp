#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <ostream>
#include <stop_token>
#include <string>
#include <thread>

namespace coilwright::cli {

/// How long work still takes, from how fast it went lately.
class Pace {
 public:
  using Time = std::chrono::steady_clock::time_point;

  /// So much was done by then. What was done more than half a minute before counts no more: the designs that an archive
  /// answers at once say nothing of those that follow.
  void learn(Time now, std::size_t done);

  /// Designs per second; nothing before there are two moments to compare.
  [[nodiscard]] std::optional<double> rate() const;

  /// Until `all` are done, s; nothing without a rate.
  [[nodiscard]] std::optional<double> left(std::size_t all) const;

 private:
  std::deque<std::pair<Time, std::size_t>> moments_;
};

/// "4 s", "2 min 10 s", "3 h 5 min".
[[nodiscard]] std::string duration_text(double seconds);

/// What a command says of its work on standard error while it works. It asks for the words on a thread of its own, so
/// that it says something also while nothing gets done.
class ProgressLine {
 public:
  /// Where the words go.
  enum class Place {
    nowhere,   ///< nothing is said
    terminal,  ///< one line, written over and over, and gone when the work ends
    log        ///< line after line, none of them in the first interval
  };

  /// Asks `words` every `interval`; on its thread, one call at a time.
  ProgressLine(std::ostream& out, Place place, std::chrono::milliseconds interval, std::function<std::string()> words);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

 private:
  void work(const std::stop_token& stop);

  std::ostream out_;
  Place place_;
  std::chrono::milliseconds interval_;
  std::function<std::string()> words_;
  std::size_t length_{};
  std::mutex guard_;
  std::condition_variable_any over_;
  std::jthread thread_;  // last: it uses the others
};

/// Nowhere with --quiet; otherwise as standard error is a terminal or not.
[[nodiscard]] ProgressLine::Place progress_place(bool quiet);

/// Ten times a second on a terminal, twice a minute in a log.
[[nodiscard]] std::chrono::milliseconds progress_interval(ProgressLine::Place place);

}  // namespace coilwright::cli
