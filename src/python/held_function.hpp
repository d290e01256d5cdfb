#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <utility>

namespace coilwright::python {

/// A Python function that copies of a std::function share: it is let go with the interpreter's lock, whichever thread
/// drops the last of them. Call it with that lock.
[[nodiscard]] inline std::shared_ptr<pybind11::function> held(pybind11::function function) {
  return {new pybind11::function(std::move(function)), [](pybind11::function* last) {
            const pybind11::gil_scoped_acquire lock;
            delete last;
          }};
}

}  // namespace coilwright::python
