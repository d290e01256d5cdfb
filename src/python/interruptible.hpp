#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <future>
#include <optional>
#include <stop_token>
#include <utility>

namespace coilwright::python {

/// What `work` (it takes a std::stop_token) returns, done on a thread of its own with the interpreter free meanwhile.
/// Ctrl-C asks it to stop, waits for that and raises KeyboardInterrupt. The caller holds the interpreter's lock.
template <class Work>
auto interruptible(Work&& work) {
  namespace py = pybind11;
  constexpr std::chrono::milliseconds soon{50};
  std::stop_source stop;
  std::optional<py::error_already_set> interrupted;
  py::gil_scoped_release others_run;
  auto done = std::async(std::launch::async, [&] { return work(stop.get_token()); });
  while (!interrupted && done.wait_for(soon) != std::future_status::ready) {
    const py::gil_scoped_acquire held;
    if (PyErr_CheckSignals() != 0) interrupted.emplace();
  }
  if (!interrupted) return done.get();
  stop.request_stop();
  done.wait();
  throw *std::move(interrupted);
}

}  // namespace coilwright::python
