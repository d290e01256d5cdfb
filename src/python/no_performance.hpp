#pragma once

#include <stdexcept>

namespace coilwright::python {

/// An actuator that can be built and has no performance at its operating point: coilwright.NoPerformance.
class NoPerformanceError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace coilwright::python
