#pragma once

#include <pybind11/pybind11.h>

#include <string>

#include "coilwright/text/json/json.hpp"

namespace coilwright::python {

/// A JSON value as dicts, lists, numbers, texts and None.
[[nodiscard]] pybind11::object to_python(const text::Json& json);

}  // namespace coilwright::python
