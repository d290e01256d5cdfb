#include "python/json_objects.hpp"

#include <cstdint>
#include <variant>

namespace coilwright::python {
namespace {

namespace py = pybind11;
using text::Json;

py::object object_of(const Json& json);

struct ToPython {
  py::object operator()(std::nullptr_t) const { return py::none(); }
  py::object operator()(bool value) const { return py::bool_(value); }
  py::object operator()(double value) const { return py::float_(value); }
  py::object operator()(std::int64_t value) const { return py::int_(value); }
  py::object operator()(const std::string& value) const { return py::str(value); }
  py::object operator()(const Json::Array& elements) const {
    py::list out;
    for (const Json& each : elements) out.append(object_of(each));
    return out;
  }
  py::object operator()(const Json::Object& members) const {
    py::dict out;
    for (const auto& [key, value] : members) out[py::str(key)] = object_of(value);
    return out;
  }
};

py::object object_of(const Json& json) {
  return std::visit(ToPython{}, json.content());
}

}  // namespace

py::object to_python(const Json& json) {
  return object_of(json);
}

}  // namespace coilwright::python
