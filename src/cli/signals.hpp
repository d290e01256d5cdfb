#pragma once

#include <atomic>
#include <csignal>

namespace coilwright::cli {

/// While it lives, the first SIGINT, SIGTERM or SIGHUP (its terminal is gone) only raises a flag, for a long command to
/// look at, write what it has found and end with ExitCode::interrupted; a SIGINT or SIGTERM after a SIGINT ends the
/// program at once. A SIGHUP that is ignored, as nohup asks, stays so. One at a time.
class StopSignal {
 public:
  StopSignal();
  ~StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;

  /// True once a signal has come. May be read from any thread; the reference is good as long as the program runs.
  [[nodiscard]] const std::atomic<bool>& requested() const noexcept;

 private:
  struct sigaction interrupt_before_ {};
  struct sigaction terminate_before_ {};
  struct sigaction hang_up_before_ {};
};

/// While it lives, SIGINT or SIGTERM says on standard error that nothing is written, and ends the program at once with
/// ExitCode::interrupted: for long work that has nothing to save.
class EndOnSignal {
 public:
  EndOnSignal();
  ~EndOnSignal();
  EndOnSignal(const EndOnSignal&) = delete;
  EndOnSignal& operator=(const EndOnSignal&) = delete;

 private:
  struct sigaction interrupt_before_ {};
  struct sigaction terminate_before_ {};
};

}  // namespace coilwright::cli
