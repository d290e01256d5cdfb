#include <optional>
#include <string>
#include <utility>

#include "python/held_function.hpp"
#include "python/performance.hpp"
#include "python/study.hpp"

namespace coilwright::python {
namespace {

namespace py = pybind11;

std::optional<double> value_of(const py::function& function, const simulation::DesignView& design) {
  const py::gil_scoped_acquire lock;
  // A copy, as the function may keep what it is given.
  const py::object value = function(Performance(simulation::EvaluatedDesign{.design = design.design,
                                                                            .assembly = design.assembly,
                                                                            .point = design.point,
                                                                            .performance = design.performance,
                                                                            .settings = settings_of(design)}));
  if (value.is_none()) return std::nullopt;
  return value.cast<double>();
}

simulation::ResultQuantity quantity_of(const py::tuple& row) {
  return {.name = row[0].cast<std::string>(),
          .meaning = row[1].cast<std::string>(),
          .scale = row[2].cast<double>(),
          .value = [function = held(row[3].cast<py::function>())](
                       const simulation::DesignView& design) { return value_of(*function, design); },
          .absence = "the Python function gave None"};
}

}  // namespace

simulation::QuantityTable table_with(const py::sequence& own) {
  simulation::QuantityTable table = simulation::standard_quantities();
  for (const py::handle row : own) table = table.with(quantity_of(row.cast<py::tuple>()));
  return table;
}

}  // namespace coilwright::python
