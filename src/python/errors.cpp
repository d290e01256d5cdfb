#include <pybind11/pybind11.h>

#include <exception>

#include "coilwright/text/input_error.hpp"
#include "coilwright/text/output/output_file.hpp"
#include "python/bindings.hpp"

namespace coilwright::python {
namespace {

namespace py = pybind11;

// Their classes are Python's, in _errors.py: they are pickled and caught like any other.
template <class... Arguments>
void raise(const char* name, const Arguments&... arguments) {
  const py::object kind = py::module_::import("coilwright._errors").attr(name);
  PyErr_SetObject(kind.ptr(), kind(arguments...).ptr());
}

}  // namespace

void bind_errors(py::module_&) {
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const text::InputError& error) {
      const text::Fault& fault = error.fault();
      raise("InputError", error.what(), fault.file, fault.place, fault.rule, fault.value);
    } catch (const text::OutputError& error) {
      raise("OutputError", error.what());
    } catch (const NoPerformanceError& error) {
      raise("NoPerformance", error.what());
    }
  });
}

}  // namespace coilwright::python
