#pragma once

#include <pybind11/pybind11.h>

#include <stdexcept>

namespace coilwright::python {

/// An actuator that can be built and has no performance at its operating point: coilwright.NoPerformance.
class NoPerformanceError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Adds to the module what its file of that name binds; what Python sees is in coilwright/_core.pyi.
///@{
void bind_errors(pybind11::module_& module);
void bind_effects(pybind11::module_& module);
void bind_actuator(pybind11::module_& module);
void bind_performance(pybind11::module_& module);
void bind_motion(pybind11::module_& module);
void bind_force(pybind11::module_& module);
void bind_study(pybind11::module_& module);
void bind_problem(pybind11::module_& module);
void bind_answers(pybind11::module_& module);
void bind_diagnosis(pybind11::module_& module);
///@}

}  // namespace coilwright::python
