#include "coilwright/formats/simulation/performance_json.hpp"

#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace coilwright::formats {
namespace {

using namespace text;
using simulation::MotionSummary;
using simulation::QuantityTable;
using simulation::ResultQuantity;

constexpr double degrees = 180.0 / std::numbers::pi;

std::vector<double> in_degrees(const mechanics::JointVector& angles) {
  std::vector<double> out;
  for (const double angle : angles) out.push_back(angle * degrees);
  return out;
}

Json number_or_null(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

void add_joints_and_modes(Json& out, const MotionSummary& motion) {
  out.set("joint_angles_deg", Json::numbers(in_degrees(motion.steady_angles)));
  out.set("rest_joint_angles_deg", Json::numbers(in_degrees(motion.rest_angles)));
  out.set("grasp_joint_angles_deg", Json::numbers(in_degrees(motion.grasp_angles)));
  Json modes = Json::array();
  for (const simulation::Mode& mode : motion.modes)
    modes.add(Json::object({{"natural_frequency_Hz", mode.natural_frequency}, {"damping_ratio", mode.damping_ratio}}));
  out.set("modes", std::move(modes));
}

}  // namespace

Json to_json(const simulation::DesignView& design, const QuantityTable& quantities) {
  Json out = Json::object();
  for (const ResultQuantity& quantity : quantities) out.set(quantity.name, number_or_null(quantity.value(design)));
  add_joints_and_modes(out, design.performance.cold);
  return out;
}

Json to_json(const MotionSummary& motion, double current, const QuantityTable& quantities) {
  Json out = Json::object();
  for (const ResultQuantity& quantity : quantities)
    if (quantity.value_of_lumped) out.set(quantity.name, number_or_null(quantity.value_of_lumped(motion, current)));
  add_joints_and_modes(out, motion);
  return out;
}

}  // namespace coilwright::formats
