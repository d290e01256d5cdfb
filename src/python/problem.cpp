#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "coilwright/sizing/search/pareto.hpp"
#include "coilwright/sizing/search/search.hpp"
#include "python/bindings.hpp"
#include "python/held_function.hpp"
#include "python/interruptible.hpp"
#include "python/search_options.hpp"

namespace coilwright::python {
namespace {

namespace py = pybind11;
using sizing::Evaluation;
using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;
using VariableRow = std::tuple<std::string, std::string, double, double, double>;  // name, kind, lower, upper, step

sizing::VariableKind kind_of(std::string_view word) {
  if (word == "integer") return sizing::VariableKind::integer;
  return word == "categorical" ? sizing::VariableKind::categorical : sizing::VariableKind::continuous;
}

// Points as rows in, a row of objectives and constraints each out. A row that has a nan stands for a design that cannot
// be evaluated.
std::vector<Evaluation> evaluations(const py::function& function, std::span<const std::vector<double>> points,
                                    std::size_t objectives, std::size_t constraints) {
  const py::gil_scoped_acquire lock;
  Array in({points.size(), points.front().size()});
  for (std::size_t i = 0; i < points.size(); ++i)
    std::copy(points[i].begin(), points[i].end(), in.mutable_data(static_cast<py::ssize_t>(i), 0));
  const Array out = function(in).cast<Array>();
  if (out.ndim() != 2 || out.shape(0) != in.shape(0) ||
      out.shape(1) != static_cast<py::ssize_t>(objectives + constraints))
    throw std::invalid_argument(
        fmt::format("the function must give {} rows of {} numbers (objectives, then constraints)", points.size(),
                    objectives + constraints));
  std::vector<Evaluation> all;
  for (py::ssize_t i = 0; i < out.shape(0); ++i) {
    const double* row = out.data(i, 0);
    all.push_back(
        {.objectives = {row, row + objectives}, .constraints = {row + objectives, row + objectives + constraints}});
  }
  return all;
}

sizing::Problem problem_of(const std::vector<VariableRow>& variables,
                           const std::vector<std::pair<std::string, bool>>& objectives,
                           const std::vector<std::string>& constraints, const py::function& function,
                           const std::vector<double>& start) {
  sizing::Problem problem;
  problem.constraints = constraints;
  if (!start.empty()) problem.starts = {start};
  for (const auto& [name, kind, lower, upper, step] : variables)
    problem.variables.push_back({.name = name, .kind = kind_of(kind), .lower = lower, .upper = upper, .step = step});
  for (const auto& [name, maximise] : objectives)
    problem.objectives.push_back({.name = name, .sense = maximise ? sizing::Sense::maximise : sizing::Sense::minimise});
  problem.evaluate_together = [shared = held(function), wanted = objectives.size(),
                               limits = constraints.size()](std::span<const std::vector<double>> points) {
    return evaluations(*shared, points, wanted, limits);
  };
  problem.evaluate = [together = problem.evaluate_together](std::span<const double> point) {
    const std::vector<double> alone(point.begin(), point.end());
    return together({&alone, 1}).front();
  };
  sizing::validate_problem(problem);
  return problem;
}

py::list rows_of(const std::vector<sizing::Record>& records) {
  py::list out;
  for (const sizing::Record& each : records)
    out.append(py::make_tuple(each.point, each.evaluation.objectives, each.evaluation.constraints,
                              each.evaluation.failure, each.number));
  return out;
}

// (the best or the front, whether feasible, why it ended, all records)
py::tuple search(const sizing::Problem& problem, const py::dict& words) {
  sizing::SearchOptions options = options_of(words, {.afterwards = sizing::Afterwards::nothing});
  const bool several = problem.objectives.size() > 1;
  const auto found =
      interruptible([&](const std::stop_token& stop) -> std::variant<sizing::SearchResult, sizing::ParetoResult> {
        options.stop = stop;
        if (several) return sizing::pareto(problem, options);
        return sizing::search(problem, options);
      });
  if (const auto* front = std::get_if<sizing::ParetoResult>(&found))
    return py::make_tuple(rows_of(front->front), !front->front.empty(), std::string(name_of(front->stop_reason)),
                          rows_of(front->archive.records()));
  const auto& one = std::get<sizing::SearchResult>(found);
  return py::make_tuple(rows_of({one.best.value()}), one.feasible, std::string(name_of(one.search_stop_reason)),
                        rows_of(one.archive.records()));
}

}  // namespace

sizing::SearchOptions options_of(const py::dict& words, sizing::SearchOptions usual) {
  const auto take = [&](auto& place, const char* name) {
    if (!words[name].is_none()) place = words[name].cast<std::remove_reference_t<decltype(place)>>();
  };
  take(usual.seed, "seed");
  take(usual.max_evaluations, "max_evaluations");
  take(usual.threads, "threads");
  if (!words["algorithm"].is_none()) usual.algorithm = sizing::algorithm_named(words["algorithm"].cast<std::string>());
  if (!words["progress"].is_none())
    usual.progress = [told = held(words["progress"].cast<py::function>())](const sizing::Progress& now) {
      const py::gil_scoped_acquire lock;
      (*told)(now.evaluations, now.max_evaluations, now.feasible, now.front_size);
    };
  return usual;
}

void bind_problem(py::module_& module) {
  py::class_<sizing::Problem>(module, "Problem")
      .def(py::init(&problem_of), py::arg("variables"), py::arg("objectives"), py::arg("constraints"),
           py::arg("function"), py::arg("start"));
  module.def("search", &search, py::arg("problem"), py::arg("words"));
}

}  // namespace coilwright::python
