#include "python/actuator.hpp"

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <new>
#include <stdexcept>
#include <utility>

#include "coilwright/formats/actuator/actuator_argument.hpp"
#include "coilwright/formats/actuator/actuator_json.hpp"
#include "coilwright/simulation/supply.hpp"
#include "coilwright/text/csv/csv_table.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/text/input_text.hpp"
#include "coilwright/text/json/document.hpp"
#include "python/bindings.hpp"

namespace coilwright::python {
namespace {

namespace py = pybind11;

Actuator loaded(const std::string& path, const actuator::EffectCatalogue& effects) {
  text::InputText input = text::read_text(path, text::json_size_limit);
  return actuator_of(std::move(input.text), std::move(input.file), effects);
}

Actuator with_assignments(const Actuator& from, const std::vector<std::string>& assignments) {
  actuator::Design design =
      formats::design_of(from.content, from.origin, "only the numbers of a design can be replaced");
  for (const std::string& each : assignments) design = formats::with_assignment(std::move(design), each);
  return actuator_of(design, from.content.name, from.content.operating_point);
}

}  // namespace

Actuator::Driven Actuator::driven() const {
  if (const auto* model = std::get_if<actuator::Model>(&content.content)) return {.model = *model};
  try {
    actuator::Assembly assembly = actuator::assemble_or_throw(std::get<actuator::Design>(content.content));
    const auto drives =
        content.operating_point ? simulation::driven_cold(assembly, content.operating_point->supply) : std::nullopt;
    return {.model = std::move(assembly.model), .coil = assembly.coil, .supply_drives = drives};
  } catch (const std::invalid_argument& fault) {
    throw text::InputError({.file = origin, .rule = fault.what()});
  }
}

Actuator actuator_of(std::string text, std::string origin, const actuator::EffectCatalogue& effects) {
  formats::ActuatorFile content = formats::parse_actuator(text, origin, effects);
  return {.content = std::move(content), .text = std::move(text), .origin = std::move(origin)};
}

Actuator actuator_of(const actuator::Design& design, const std::string& name,
                     const std::optional<actuator::OperatingPoint>& point) {
  return {.content = {.name = name, .content = design, .operating_point = point},
          .text = formats::to_json(design, name, point).text(),
          .origin = "actuator"};
}

void bind_actuator(py::module_& module) {
  module.def("read_text", [](const std::string& path) { return text::read_text(path, text::csv_size_limit).text; });
  py::class_<Actuator>(module, "Actuator")
      .def_static("load", &loaded, py::arg("path"), py::arg("effects"))
      .def_static("parse", py::overload_cast<std::string, std::string, const actuator::EffectCatalogue&>(&actuator_of),
                  py::arg("text"), py::arg("origin"), py::arg("effects"))
      .def_static("prototype", [] { return actuator_of(actuator::Design{}, "prototype", std::nullopt); })
      .def("with_assignments", &with_assignments, py::arg("assignments"))
      .def_property_readonly("name", [](const Actuator& self) { return self.content.name; })
      .def_property_readonly("origin", [](const Actuator& self) { return self.origin; })
      .def_property_readonly("is_design", &Actuator::is_design)
      .def_property_readonly("text", [](const Actuator& self) { return self.text; });
}

}  // namespace coilwright::python
