#include "coilwright/formats/simulation/linear_model_json.hpp"

#include <fmt/format.h>

#include <numbers>
#include <string>
#include <vector>

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

Json joint_names(Json names, Eigen::Index joints, const char* pattern) {
  for (Eigen::Index j = 1; j <= joints; ++j) names.add(fmt::format(fmt::runtime(pattern), j));
  return names;
}

Json state_names(const simulation::LinearModel& model) {
  const Eigen::Index n = model.angles.size();
  Json names = joint_names(joint_names(Json::array(), n, "theta{}_rad"), n, "rate{}_rad_s");
  for (int k = 1; k <= model.effect_states; ++k) names.add(fmt::format("effect_state{}", k));
  return names;
}

Json modes_of(const simulation::LinearModel& model) {
  Json out = Json::array();
  for (const simulation::Mode& mode : model.modes)
    out.add(Json::object({{"natural_frequency_Hz", mode.natural_frequency}, {"damping_ratio", mode.damping_ratio}}));
  return out;
}

}  // namespace

Json to_json(const simulation::LinearModel& model) {
  constexpr double degrees = 180.0 / std::numbers::pi;
  const Eigen::Index n = model.angles.size();
  std::vector<double> angles;
  for (const double angle : model.angles) angles.push_back(units::from_memory(angle, "angle_deg"));
  Json eigenvalues = Json::array();
  for (const auto& value : model.eigenvalues)
    eigenvalues.add(Json::object({{"real_1_s", value.real()}, {"imaginary_1_s", value.imag()}}));
  Json pressed = Json::array();
  for (const int joint : model.pressed_joints) pressed.add(joint + 1);
  return Json::object({{"format", "linear-model/1"},
                       {"current_A", model.current},
                       {"joint_angles_deg", Json::numbers(angles)},
                       {"bending_angle_deg", units::from_memory(model.angles.sum(), "angle_deg")},
                       {"states", state_names(model)},
                       {"inputs", Json::array({"current_A"})},
                       {"outputs", joint_names(Json::array({"bending_angle_rad"}), n, "theta{}_rad")},
                       {"A", rows_of(model.a)},
                       {"B", rows_of(model.b)},
                       {"C", rows_of(model.c)},
                       {"D", rows_of(model.d)},
                       {"dc_gain_deg_A", model.dc_gain ? Json((*model.dc_gain)[0] * degrees) : Json(nullptr)},
                       {"modes", modes_of(model)},
                       {"eigenvalues", std::move(eigenvalues)},
                       {"stable", model.stable()},
                       {"sticks", model.sticks},
                       {"pressed_joints", std::move(pressed)}});
}

}  // namespace coilwright::formats
