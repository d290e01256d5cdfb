#include "end_on_signal.hpp"

#include <unistd.h>

#include "outcome.hpp"

namespace coilwright::cli {
namespace {

// Of all that could be done here, _exit alone is safe in a signal handler while other threads work.
extern "C" void end_now(int) {
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
