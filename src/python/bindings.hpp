#pragma once

#include <pybind11/pybind11.h>

#include <algorithm>
#include <stdexcept>
#include <string>

namespace coilwright::python {

/// An actuator that can be built and has no performance at its operating point: coilwright.NoPerformance.
class NoPerformanceError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What the program says on standard error, as a warning of Python at the line that called the package. Throws what a
/// filter of warnings makes of it. The interpreter's lock is held.
inline void warn(std::string text) {
  constexpr int who_called_the_package = 2;
  text.erase(0, text.find_first_not_of('\n'));
  std::replace(text.begin(), text.end(), '\n', ' ');
  if (PyErr_WarnEx(PyExc_UserWarning, text.c_str(), who_called_the_package) != 0) throw pybind11::error_already_set();
}

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
void bind_systems(pybind11::module_& module);
void bind_films(pybind11::module_& module);
///@}

}  // namespace coilwright::python
