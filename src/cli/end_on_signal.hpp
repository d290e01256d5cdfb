#pragma once

#include <csignal>

namespace coilwright::cli {

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
