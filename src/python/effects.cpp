#include <pybind11/eigen.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "coilwright/actuator/model/described_effect.hpp"
#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "coilwright/actuator/model/model_spec.hpp"
#include "coilwright/units/unit.hpp"
#include "python/bindings.hpp"
#include "python/held_function.hpp"

namespace coilwright::python {
namespace {

namespace py = pybind11;
using actuator::EffectTerm;

// A torque at the joints that a Python function gives. It is called in every step of every simulation, with the
// interpreter's lock: some thousand times slower than an effect of Coilwright.
class PythonTorque final : public EffectTerm {
 public:
  PythonTorque(std::shared_ptr<py::function> function, std::span<const double> numbers)
      : function_(std::move(function)),
        numbers_(Eigen::Map<const Eigen::VectorXd>(numbers.data(), static_cast<Eigen::Index>(numbers.size()))) {}

  void add_torques(const Kinematics& motion, const actuator::CoilCurrents& strength, InternalStateView /*own*/,
                   mechanics::JointVector& torques) const override {
    const py::gil_scoped_acquire lock;
    const Eigen::VectorXd angles = motion.angles, rates = motion.rates, currents = strength;
    const auto given = (*function_)(numbers_, angles, rates, currents).cast<Eigen::VectorXd>();
    if (given.size() != torques.size())
      throw std::invalid_argument(
          fmt::format("the effect's function must give {} torques; got {}", torques.size(), given.size()));
    torques += given;
  }

 private:
  std::shared_ptr<py::function> function_;
  Eigen::VectorXd numbers_;
};

// One number of it as Python gives it, in the unit of its key.
struct Number {
  std::string key, text;
  double lower{}, upper{};
  std::optional<double> absent{};
};

// Never let go: models, effects and results refer to a kind by its address for as long as they like.
struct OwnedKind {
  std::string id, description, equation, source;
  std::vector<Number> numbers;
  std::unique_ptr<const actuator::DescribedEffect> kind{};
};

actuator::EffectParameter parameter_of(const Number& number) {
  return {.key = number.key,
          .text = number.text,
          .lower = units::to_memory(number.lower, number.key),
          .upper = units::to_memory(number.upper, number.key),
          .absent = number.absent ? std::optional(units::to_memory(*number.absent, number.key)) : std::nullopt};
}

actuator::Stage stage_of(std::string_view word) {
  if (word == "magnetics") return actuator::Stage::magnetics;
  if (word == "chain") return actuator::Stage::chain;
  if (word == "hinge") return actuator::Stage::hinge;
  throw std::invalid_argument(fmt::format("stage: must be magnetics, hinge or chain; got {}", word));
}

std::vector<std::vector<double>> in_memory(std::vector<std::vector<double>> starts,
                                           const std::vector<Number>& numbers) {
  for (std::vector<double>& start : starts) {
    if (start.size() != numbers.size())
      throw std::invalid_argument(
          fmt::format("starts: each must have {} numbers; got {}", numbers.size(), start.size()));
    for (std::size_t i = 0; i < start.size(); ++i) start[i] = units::to_memory(start[i], numbers[i].key);
  }
  if (starts.empty()) throw std::invalid_argument("starts: must have at least one");
  return starts;
}

const OwnedKind* kind_of(std::string id, std::string_view stage, std::string description, std::string equation,
                         std::string source, std::vector<Number> numbers, std::vector<std::vector<double>> starts,
                         py::function torques) {
  auto owned = std::make_unique<OwnedKind>(
      OwnedKind{std::move(id), std::move(description), std::move(equation), std::move(source), std::move(numbers)});
  actuator::EffectProperties row{.id = owned->id,
                                 .stage = stage_of(stage),
                                 .description = owned->description,
                                 .equation = owned->equation,
                                 .source = owned->source};
  for (const Number& each : owned->numbers) row.parameters.push_back(parameter_of(each));
  row.starts = [all = in_memory(std::move(starts), owned->numbers)](const actuator::RigScale&) { return all; };
  row.build = [function = held(std::move(torques))](std::span<const double> values, actuator::ModelSpec&) {
    return std::make_unique<PythonTorque>(function, values);
  };
  owned->kind = std::make_unique<const actuator::DescribedEffect>(std::move(row));
  return owned.release();
}

actuator::EffectCatalogue catalogue_with(const std::vector<const OwnedKind*>& own) {
  actuator::EffectCatalogue all = actuator::standard_effects();
  for (const OwnedKind* each : own) all = all.with(*each->kind);
  return all;
}

py::list listed_effects() {
  py::list out;
  for (const actuator::EffectKind* kind : actuator::standard_effects().kinds())
    out.append(py::make_tuple(std::string(kind->id()), std::string(kind->description())));
  return out;
}

}  // namespace

void bind_effects(py::module_& module) {
  py::class_<Number>(module, "Number")
      .def(py::init([](std::string key, std::string text, double lower, double upper, std::optional<double> absent) {
             return Number{std::move(key), std::move(text), lower, upper, absent};
           }),
           py::arg("key"), py::arg("text"), py::arg("lower"), py::arg("upper"), py::arg("absent"));
  py::class_<OwnedKind, std::unique_ptr<OwnedKind, py::nodelete>>(module, "EffectKind")
      .def_static("make", &kind_of, py::return_value_policy::reference, py::arg("id"), py::arg("stage"),
                  py::arg("description"), py::arg("equation"), py::arg("source"), py::arg("numbers"), py::arg("starts"),
                  py::arg("torques"));
  py::class_<actuator::EffectCatalogue>(module, "Effects").def(py::init(&catalogue_with), py::arg("own"));
  module.def("effects", &listed_effects);
}

}  // namespace coilwright::python
