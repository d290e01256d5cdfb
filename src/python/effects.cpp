#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
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

using Vectors = std::vector<Eigen::VectorXd>;

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
  std::string gives;                            // "torques", "currents" or "shown": what `acts` does
  std::shared_ptr<py::function> acts, settled;  // settled: null for an effect without states
  bool slow{};
  std::unique_ptr<const actuator::DescribedEffect> kind{};
};

// What an effect of Python does: its function is called with the effect's numbers, with what enters its stage and with
// its states, and gives what leaves the stage and the slopes of the states. Every call takes the interpreter's lock.
class PythonTerm final : public EffectTerm {
 public:
  PythonTerm(const OwnedKind& kind, std::span<const double> numbers, const actuator::ModelSpec& spec)
      : kind_(kind),
        numbers_(Eigen::Map<const Eigen::VectorXd>(numbers.data(), static_cast<Eigen::Index>(numbers.size()))) {
    if (kind.settled)
      states_ = static_cast<int>(
          at_rest(Eigen::VectorXd::Zero(spec.chain.joints()), Eigen::VectorXd::Zero(spec.coils)).size());
  }

  int states() const override { return states_; }
  bool slow() const override { return kind_.slow; }
  void settle(const Kinematics& motion, const actuator::CoilCurrents& currents, double* out) const override {
    if (states_ == 0) return;
    const Eigen::VectorXd rest = at_rest(motion.angles, currents);
    std::copy_n(rest.data(), states_, out);
  }

  void drive(InternalStateView own, actuator::CoilCurrents& currents) const override {
    currents = given({currents}, 1, own).front();
  }
  void magnetize(InternalStateView own, const actuator::CoilCurrents& /*currents*/,
                 actuator::CoilCurrents& strength) const override {
    if (kind_.gives == "currents") strength = given({strength}, 1, own).front();
  }
  void add_torques(const Kinematics& motion, const actuator::CoilCurrents& strength, InternalStateView own,
                   mechanics::JointVector& torques) const override {
    if (kind_.gives == "torques") torques += given({motion.angles, motion.rates, strength}, 1, own).front();
  }
  bool shows() const override { return kind_.gives == "shown"; }
  // By central differences: a step far below any motion's rates and far above rounding.
  void add_damping(const Kinematics& motion, const actuator::CoilCurrents& strength,
                   mechanics::JointMatrix& damping) const override {
    if (kind_.gives != "torques") return;
    constexpr double step = 1e-4;  // rad/s
    actuator::InternalStates rest(states_);
    settle(motion, strength, rest.data());
    const auto torques = [&](int joint, double rate) {
      mechanics::JointVector rates = motion.rates;
      rates[joint] += rate;
      return given({motion.angles, rates, strength}, 1, {.states = rest.data()}).front();
    };
    for (int j = 0; j < motion.rates.size(); ++j)
      damping.col(j) += (torques(j, -step) - torques(j, step)) / (2.0 * step);
  }
  void show(InternalStateView own, mechanics::JointVector& angles, mechanics::JointVector& rates) const override {
    const Vectors shown = given({angles, rates}, 2, own);
    angles = shown[0];
    rates = shown[1];
  }

 private:
  // Throws an exception of Python: others say that a motion cannot be computed, and a search goes on without it.
  void require(bool kept, std::string_view function, const std::string& rule) const {
    if (kept) return;
    PyErr_SetString(PyExc_ValueError, fmt::format("effect {}: {} must give {}", kind_.id, function, rule).c_str());
    throw py::error_already_set();
  }

  Eigen::VectorXd at_rest(const Eigen::VectorXd& angles, const Eigen::VectorXd& currents) const {
    const py::gil_scoped_acquire lock;
    Eigen::VectorXd rest = array_of((*kind_.settled)(numbers_, angles, currents), "settled", "an array");
    require(states_ == 0 || rest.size() == states_, "settled", fmt::format("{} numbers, as before", states_));
    return rest;
  }

  Eigen::VectorXd array_of(const py::handle& value, std::string_view function, const std::string& rule) const {
    const auto array = py::array_t<double, py::array::forcecast>::ensure(value);
    require(array && array.ndim() == 1, function, rule);
    return array.cast<Eigen::VectorXd>();
  }

  // The first `count` vectors that it gives, each as long as the first that enters. Writes the slopes of its states,
  // which come behind them, where they are wanted.
  Vectors given(const Vectors& entering, std::size_t count, InternalStateView own) const {
    const py::gil_scoped_acquire lock;
    py::list arguments;
    arguments.append(numbers_);
    for (const Eigen::VectorXd& each : entering) arguments.append(each);
    if (states_ > 0) arguments.append(Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(own.states, states_)));
    py::object answer = (*kind_.acts)(*arguments);
    const std::size_t all = count + (states_ > 0 ? 1 : 0);
    const std::string rule =
        all == 1 ? "an array" : fmt::format("{} arrays{}", all, states_ > 0 ? ", the slopes of its states last" : "");
    if (all == 1) answer = py::make_tuple(answer);
    require(py::isinstance<py::sequence>(answer) && py::len(answer) == all, kind_.gives, rule);
    Vectors out;
    for (std::size_t i = 0; i < all; ++i) {
      const Eigen::Index size = i < count ? entering.front().size() : states_;
      out.push_back(array_of(answer[py::int_(i)], kind_.gives, rule));
      require(out[i].size() == size, kind_.gives, fmt::format("{} numbers; got {}", size, out[i].size()));
    }
    if (states_ > 0 && own.slopes != nullptr) std::copy_n(out.back().data(), states_, own.slopes);
    return out;
  }

  const OwnedKind& kind_;
  Eigen::VectorXd numbers_;
  int states_{};
};

actuator::EffectParameter parameter_of(const Number& number) {
  return {.key = number.key,
          .text = number.text,
          .lower = units::to_memory(number.lower, number.key),
          .upper = units::to_memory(number.upper, number.key),
          .absent = number.absent ? std::optional(units::to_memory(*number.absent, number.key)) : std::nullopt};
}

// Which of them take what an effect gives is in _effects.py.
actuator::Stage stage_of(std::string_view word) {
  constexpr std::array words{"drive", "magnetics", "hinge", "chain", "camera"};
  return static_cast<actuator::Stage>(std::ranges::find(words, word) - words.begin());
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
                         std::string gives, py::function acts, const py::object& settled, bool slow) {
  auto owned = std::make_unique<OwnedKind>(OwnedKind{
      std::move(id), std::move(description), std::move(equation), std::move(source), std::move(numbers),
      std::move(gives), held(std::move(acts)), settled.is_none() ? nullptr : held(settled.cast<py::function>()), slow});
  actuator::EffectProperties row{.id = owned->id,
                                 .stage = stage_of(stage),
                                 .description = owned->description,
                                 .equation = owned->equation,
                                 .source = owned->source};
  for (const Number& each : owned->numbers) row.parameters.push_back(parameter_of(each));
  row.starts = [all = in_memory(std::move(starts), owned->numbers)](const actuator::RigScale&) { return all; };
  row.build = [kind = owned.get()](std::span<const double> values, actuator::ModelSpec& spec) {
    return std::make_unique<PythonTerm>(*kind, values, spec);
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
                  py::arg("gives"), py::arg("acts"), py::arg("settled"), py::arg("slow"));
  py::class_<actuator::EffectCatalogue>(module, "Effects").def(py::init(&catalogue_with), py::arg("own"));
  module.def("effects", &listed_effects);
}

}  // namespace coilwright::python
