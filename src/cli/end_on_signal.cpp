#include "end_on_signal.hpp"

#include <unistd.h>

#include <string_view>

#include "outcome.hpp"

namespace coilwright::cli {
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
