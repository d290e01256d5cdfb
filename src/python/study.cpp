#include "python/study.hpp"

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "coilwright/formats/study/study_file.hpp"
#include "python/actuator.hpp"
#include "python/bindings.hpp"

namespace coilwright::python {
namespace {

namespace py = pybind11;

Study study_of(const std::string& text, const std::string& origin, const Actuator* actuator,
               std::vector<std::string> changes, const py::sequence& quantities,
               const actuator::EffectCatalogue& effects, const std::optional<std::string>& posterior) {
  const simulation::QuantityTable table = table_with(quantities);
  std::optional<text::InputText> own;
  if (actuator != nullptr) own = {.file = actuator->origin, .text = actuator->text};
  std::optional<text::InputText> diagnosis;
  if (posterior) diagnosis = {.file = "posterior", .text = *posterior};
  return {.content = formats::parse_study(text, origin,
                                          {.quantities = table,
                                           .effects = effects,
                                           .changes = std::move(changes),
                                           .actuator = own ? &*own : nullptr,
                                           .posterior = diagnosis ? &*diagnosis : nullptr}),
          .origin = origin};
}

std::vector<std::string> names_of_variables(const Study& study) {
  std::vector<std::string> names;
  for (const sizing::StudyVariable& each : study.content.variables) names.push_back(sizing::name_of(each));
  return names;
}

std::vector<std::string> names_of_objectives(const Study& study) {
  std::vector<std::string> names;
  for (const sizing::StudyObjective& each : study.content.objectives) names.push_back(each.quantity.name);
  return names;
}

std::vector<std::string> names_of_limits(const Study& study) {
  std::vector<std::string> names;
  for (const sizing::Limit& each : study.content.limits) names.push_back(sizing::name_of(each));
  return names;
}

}  // namespace

void bind_study(py::module_& module) {
  py::class_<Study>(module, "Study")
      .def_static("parse", &study_of, py::arg("text"), py::arg("origin"), py::arg("actuator").none(true),
                  py::arg("changes"), py::arg("quantities"), py::arg("effects"), py::arg("posterior"))
      .def_property_readonly("name", [](const Study& self) { return self.content.name; })
      .def_property_readonly("variables", &names_of_variables)
      .def_property_readonly("objectives", &names_of_objectives)
      .def_property_readonly("limits", &names_of_limits);
}

}  // namespace coilwright::python
