#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "coilwright/formats/actuator/pair_file.hpp"
#include "coilwright/magnetics/field_places.hpp"
#include "coilwright/magnetics/forces.hpp"
#include "coilwright/report/systems/pair_remarks.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/text/input_text.hpp"
#include "coilwright/text/json/document.hpp"
#include "coilwright/units/unit.hpp"
#include "python/bindings.hpp"

namespace coilwright::python {
namespace {

namespace py = pybind11;
using magnetics::Body;
using magnetics::Pose;
using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;

// Bodies, and where the last one is.
struct Pair {
  formats::PairFile file;
  std::string text;
  std::string origin;
};

Pair pair_of(std::string text, std::string origin) {
  formats::PairFile file = formats::parse_pair(text, origin);
  return {.file = std::move(file), .text = std::move(text), .origin = std::move(origin)};
}

Pair loaded_pair(const std::string& path) {
  text::InputText input = text::read_text(path, text::json_size_limit);
  return pair_of(std::move(input.text), std::move(input.file));
}

Eigen::Vector3d row_of(const double* row) {
  return {row[0], row[1], row[2]};
}

constexpr double millimetres = 1000.0;  // a metre has

// Where the last body goes: as arrays say, or through the poses of the file.
class Poses {
 public:
  Poses(const Pair& pair, const Array& positions, const Array& axes)
      : listed_(pair.file.poses),
        positions_(positions.size() > 0 ? positions.data() : nullptr),
        axes_(axes.size() > 0 ? axes.data() : nullptr),
        count_(positions_ != nullptr ? static_cast<std::size_t>(positions.shape(0)) : listed_.size()) {}

  [[nodiscard]] std::size_t count() const noexcept { return count_; }
  [[nodiscard]] Pose at(std::size_t i) const {
    if (positions_ == nullptr) return listed_[i];
    Pose pose = listed_.front();
    pose.position = row_of(positions_ + 3 * i) / millimetres;
    if (axes_ != nullptr) pose.axis = row_of(axes_ + 3 * i);
    return pose;
  }

 private:
  const std::vector<Pose>& listed_;
  const double* positions_;  // mm
  const double* axes_;
  std::size_t count_;
};

// Only coils and magnets of the axial kind have a force where they overlap.
bool needs_room(const std::vector<Body>& bodies) {
  for (const Body& body : bodies)
    if (!magnetics::is_axial(body)) return true;
  return false;
}

// Six numbers a body: the force, N, and the torque, N mm.
void fill(const Pair& pair, const Poses& poses, std::size_t first, std::size_t last, double* out,
          report::PairRemarks& remarks) {
  std::vector<Body> bodies = pair.file.bodies_at(pair.file.poses.front());
  const bool check = needs_room(bodies);
  for (std::size_t i = first; i < last; ++i) {
    bodies.back().pose = poses.at(i);
    if (check) formats::require_apart(pair.file, bodies, i == 0 ? 0 : bodies.size() - 1, i, pair.origin);
    const magnetics::Forces forces = formats::forces_on(pair.file, bodies, i, pair.origin);
    remarks.add(bodies, i);
    remarks.add(forces);
    for (const magnetics::Wrench& each : forces.on) {
      for (int k = 0; k < 3; ++k) *out++ = each.force[k];
      for (int k = 0; k < 3; ++k) *out++ = each.torque[k] * millimetres;
    }
  }
}

Array force(const Pair& pair, const Array& positions, const Array& axes) {
  constexpr std::size_t between_signals = 5000;  // poses, of microseconds to a millisecond each: then Ctrl-C is heard
  const Poses poses(pair, positions, axes);
  const std::size_t bodies = pair.file.bodies.size();
  Array out({poses.count(), bodies, std::size_t{6}});
  double* place = out.mutable_data();
  report::PairRemarks remarks(pair.file);
  for (std::size_t first = 0; first < poses.count(); first += between_signals) {
    {
      const py::gil_scoped_release others_run;
      fill(pair, poses, first, std::min(poses.count(), first + between_signals), place + first * bodies * 6, remarks);
    }
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  }
  for (const std::string& sentence : remarks.sentences()) warn(pair.origin + ": " + sentence);
  return out;
}

// B and its gradient at each point, and the number of the body it lies in (0: none; -1: behind the face of the plate).
py::tuple field(const Pair& pair, const Array& points_mm, std::size_t pose, bool gradient) {
  if (pose == 0 || pose > pair.file.poses.size())
    throw text::InputError({.file = "pose",
                            .rule = "must be at least 1, and at most how many poses " + pair.origin + " has, " +
                                    std::to_string(pair.file.poses.size()),
                            .value = std::to_string(pose)});
  const auto count = static_cast<std::size_t>(points_mm.shape(0));
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double* row = points_mm.data() + 3 * i;
    points.emplace_back(units::to_memory(row[0], "x_mm"), units::to_memory(row[1], "y_mm"),
                        units::to_memory(row[2], "z_mm"));
  }
  const std::vector<Body> bodies = pair.file.bodies_at(pair.file.poses[pose - 1]);
  report::PairRemarks remarks(pair.file);
  remarks.add(bodies, pose);
  const magnetics::FieldPlaces found = [&] {
    const py::gil_scoped_release others_run;
    return magnetics::field_places(bodies, pair.file.plate, points, gradient);
  }();
  Array flux({count, std::size_t{3}});
  Array slopes({gradient ? count : std::size_t{0}, std::size_t{3}, std::size_t{3}});
  py::array_t<int> within(static_cast<py::ssize_t>(count));
  for (std::size_t i = 0; i < count; ++i) {
    const magnetics::FieldSample& sample = found.samples[i];
    const double unknown = found.in_iron[i] || found.on_edge[i] > 0 ? std::numeric_limits<double>::quiet_NaN() : 0.0;
    for (int k = 0; k < 3; ++k) {
      flux.mutable_data()[3 * i + static_cast<std::size_t>(k)] =
          units::from_si(sample.flux_density[k], "B_mT") + unknown;
      for (int j = 0; j < 3 && gradient; ++j)
        slopes.mutable_data()[9 * i + static_cast<std::size_t>(3 * k + j)] = sample.gradient(k, j) + unknown;
    }
    within.mutable_data()[i] = found.in_iron[i] ? -1 : static_cast<int>(found.within[i]);
  }
  for (const std::string& sentence : remarks.sentences()) warn(pair.origin + ": " + sentence);
  return py::make_tuple(flux, slopes, within);
}

}  // namespace

void bind_force(py::module_& module) {
  py::class_<Pair>(module, "Pair")
      .def_static("load", &loaded_pair, py::arg("path"))
      .def_static("parse", &pair_of, py::arg("text"), py::arg("origin"))
      .def_property_readonly("names", [](const Pair& self) { return py::tuple(py::cast(self.file.names)); })
      .def_property_readonly("text", [](const Pair& self) { return self.text; })
      .def_property_readonly("origin", [](const Pair& self) { return self.origin; });
  module.def("force", &force, py::arg("pair"), py::arg("positions_mm"), py::arg("axes"));
  module.def("field", &field, py::arg("pair"), py::arg("points_mm"), py::arg("pose"), py::arg("gradient"));
}

}  // namespace coilwright::python
