#include "coilwright/formats/simulation/performance_json.hpp"
#include "coilwright/units/angle.hpp"

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace coilwright::formats {
namespace {

using namespace text;
using simulation::FreeMotion;
using simulation::Grasp;
using simulation::MotionSummary;
using simulation::QuantityTable;
using simulation::ResultQuantity;

// null where a thermal runaway leaves none.
Json in_degrees(const mechanics::JointVector* angles) {
  if (angles == nullptr) return nullptr;
  return Json::list(*angles, [](double angle) { return angle * units::degrees_per_radian; });
}

Json mode_json(const simulation::Mode& mode) {
  return Json::object({{"natural_frequency_Hz", mode.natural_frequency}, {"damping_ratio", mode.damping_ratio}});
}

void add_joints_and_modes(Json& out, const mechanics::JointVector& rest, const FreeMotion* motion, const Grasp* grasp) {
  out.set("joint_angles_deg", in_degrees(motion == nullptr ? nullptr : &motion->steady_angles));
  out.set("rest_joint_angles_deg", in_degrees(&rest));
  out.set("grasp_joint_angles_deg", in_degrees(grasp == nullptr ? nullptr : &grasp->grasp_angles));
  out.set("modes", motion == nullptr ? Json() : Json::list(motion->modes, mode_json));
}

}  // namespace

Json to_json(const simulation::DesignView& design, const QuantityTable& quantities) {
  Json out = Json::object();
  for (const ResultQuantity& quantity : quantities) out.set(quantity.name, number_or_null(quantity.value(design)));
  const simulation::Performance& found = design.performance;
  add_joints_and_modes(out, found.cold.rest_angles, found.free.motion ? &*found.free.motion : nullptr,
                       found.gripping.grasp ? &*found.gripping.grasp : nullptr);
  return out;
}

Json to_json(const MotionSummary& motion, double current, const QuantityTable& quantities) {
  Json out = Json::object();
  for (const ResultQuantity& quantity : quantities)
    if (quantity.value_of_lumped) out.set(quantity.name, number_or_null(quantity.value_of_lumped(motion, current)));
  add_joints_and_modes(out, motion.rest_angles, &motion, &motion);
  return out;
}

}  // namespace coilwright::formats
