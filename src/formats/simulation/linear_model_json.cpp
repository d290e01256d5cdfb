#include "coilwright/formats/simulation/linear_model_json.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "coilwright/formats/simulation/performance_json.hpp"
#include "coilwright/units/angle.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::formats {
namespace {

using text::Json;

Json rows_of(const Eigen::MatrixXd& matrix) {
  Json rows = Json::array();
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    const Eigen::VectorXd row = matrix.row(i);
    rows.add(Json::numbers({row.data(), static_cast<std::size_t>(row.size())}));
  }
  return rows;
}

Json numbered(Json names, Eigen::Index joints, const char* pattern) {
  for (Eigen::Index j = 1; j <= joints; ++j) names.add(fmt::format(fmt::runtime(pattern), j));
  return names;
}

Json names_of_states(const simulation::LinearModel& model) {
  const Eigen::Index n = model.angles.size();
  Json names = numbered(numbered(Json::array(), n, "theta{}_rad"), n, "rate{}_rad_s");
  for (int k = 1; k <= model.effect_states; ++k) names.add(fmt::format("effect_state{}", k));
  return names;
}

Json numbers_of(const auto& values) {
  return Json::numbers({values.data(), static_cast<std::size_t>(values.size())});
}

Json names_of_inputs(const simulation::LinearModel& model) {
  if (model.b.cols() == 1) return Json::array({"current_A"});
  return numbered(Json::array(), model.b.cols(), "current{}_A");
}

}  // namespace

Json to_json(const simulation::LinearModel& model) {
  const Eigen::Index n = model.angles.size();
  Json eigenvalues = Json::list(model.eigenvalues, [](const auto& value) {
    return Json::object({{"real_1_s", value.real()}, {"imaginary_1_s", value.imag()}});
  });
  Json pressed = Json::list(model.pressed_joints, [](int joint) { return joint + 1; });
  // One input has its key, one for each coil a list.
  const bool one_input = model.b.cols() == 1;
  Json out = Json::object({{"format", "linear-model/1"}});
  if (one_input)
    out.set("current_A", model.currents[0]);
  else
    out.set("coil_currents_A", numbers_of(model.currents));
  out.set(Json::quantities("joint_angles_deg", {model.angles.data(), static_cast<std::size_t>(n)}));
  out.set(Json::quantity("bending_angle_deg", model.angles.sum()));
  out.set("states", names_of_states(model)).set("inputs", names_of_inputs(model));
  out.set("outputs", numbered(Json::array({"bending_angle_rad"}), n, "theta{}_rad"));
  out.set("A", rows_of(model.a)).set("B", rows_of(model.b)).set("C", rows_of(model.c)).set("D", rows_of(model.d));
  const char* gain = one_input ? "dc_gain_deg_A" : "dc_gains_deg_A";
  if (!model.dc_gain) {
    out.set(gain, nullptr);
  } else {
    const Eigen::VectorXd gains = units::degrees_per_radian * model.dc_gain->row(0);
    out.set(gain, one_input ? Json(gains[0]) : numbers_of(gains));
  }
  out.set("modes", Json::list(model.modes, mode_json))
      .set("eigenvalues", std::move(eigenvalues))
      .set("stable", model.stable());
  out.set("sticks", model.sticks).set("pressed_joints", std::move(pressed));
  return out;
}

}  // namespace coilwright::formats
