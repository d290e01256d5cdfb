#include "cli/signals.hpp"

#include <unistd.h>
#include <string_view>

#include "cli/commands.hpp"

namespace coilwright::cli {
namespace {

// A signal handler can reach nothing but a global.
std::atomic<bool> stop_requested{false};
static_assert(std::atomic<bool>::is_always_lock_free, "only a lock-free atomic may be written in a signal handler");

extern "C" void on_interrupt(int) {
  stop_requested = true;
  struct sigaction end_at_once {};
  end_at_once.sa_handler = SIG_DFL;
  sigaction(SIGINT, &end_at_once, nullptr);
  sigaction(SIGTERM, &end_at_once, nullptr);
}

// A terminal that closes sends SIGHUP, and the shell in it may send another; `timeout` sends SIGTERM to its child and
// then to their group. The second must not end what the first one is ending.
extern "C" void on_end(int) {
  stop_requested = true;
}

}  // namespace

StopSignal::StopSignal() {
  stop_requested = false;
  struct sigaction raise_flag {};
  raise_flag.sa_flags = SA_RESTART;  // an interrupted write goes on
  raise_flag.sa_handler = on_interrupt;
  sigaction(SIGINT, &raise_flag, &interrupt_before_);
  raise_flag.sa_handler = on_end;
  sigaction(SIGTERM, &raise_flag, &terminate_before_);
  sigaction(SIGHUP, nullptr, &hang_up_before_);
  if (hang_up_before_.sa_handler != SIG_IGN) sigaction(SIGHUP, &raise_flag, nullptr);
}

StopSignal::~StopSignal() {
  sigaction(SIGINT, &interrupt_before_, nullptr);
  sigaction(SIGTERM, &terminate_before_, nullptr);
  sigaction(SIGHUP, &hang_up_before_, nullptr);
}

const std::atomic<bool>& StopSignal::requested() const noexcept {
  return stop_requested;
}

namespace {

constexpr std::string_view message = "coilwright: interrupted: nothing is written\n";

// Of all that could be done here, write and _exit alone are safe in a signal handler while other threads work.
extern "C" void end_now(int) {
  [[maybe_unused]] const ssize_t said = ::write(STDERR_FILENO, message.data(), message.size());
  _exit(static_cast<int>(ExitCode::interrupted));
}

}  // namespace

EndOnSignal::EndOnSignal() {
  struct sigaction end {};
  end.sa_handler = end_now;
  sigaction(SIGINT, &end, &interrupt_before_);
  sigaction(SIGTERM, &end, &terminate_before_);
}

EndOnSignal::~EndOnSignal() {
  sigaction(SIGINT, &interrupt_before_, nullptr);
  sigaction(SIGTERM, &terminate_before_, nullptr);
}

}  // namespace coilwright::cli
