#include "coilwright/formats/simulation/performance_json.hpp"

#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "coilwright/units/angle.hpp"

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

void add_joints_and_modes(Json& out, const mechanics::JointVector& rest, const FreeMotion* motion, const Grasp* grasp) {
  out.set("joint_angles_deg", in_degrees(motion == nullptr ? nullptr : &motion->steady_angles));
  out.set("rest_joint_angles_deg", in_degrees(&rest));
  out.set("grasp_joint_angles_deg", in_degrees(grasp == nullptr ? nullptr : &grasp->grasp_angles));
  out.set("modes", motion == nullptr ? Json() : Json::list(motion->modes, mode_json));
}

}  // namespace

Json mode_json(const simulation::Mode& mode) {
  return Json::object({{"natural_frequency_Hz", mode.natural_frequency}, {"damping_ratio", mode.damping_ratio}});
}

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

Json to_json(std::span<const simulation::PartLimit> limits) {
  return Json::list(limits, [](const simulation::PartLimit& limit) {
    return Json::object({{"quantity", limit.quantity},
                         {"value", limit.value},
                         {limit.at_most ? "at_most" : "at_least", limit.limit},
                         {"broken", limit.is_broken()},
                         {"conditional", limit.conditional},
                         {"consequence", limit.consequence}});
  });
}

Json to_json(const actuator::OtherChoice& choice) {
  return Json::object({{"subject", choice.subject},
                       {"taken", choice.taken},
                       {"otherwise", choice.otherwise},
                       {"number", choice.number.empty() ? Json(nullptr) : Json(choice.number)},
                       {"source", choice.source},
                       {"settled_by", choice.settled_by},
                       {"decided", choice.decided}});
}

Json to_json(std::span<const simulation::ChoiceEffect> effects) {
  Json out = Json::array();
  for (const simulation::ChoiceEffect& effect : effects) {
    Json entry = to_json(effect.choice);
    entry.set("matters", effect.matters());
    if (const auto* why = std::get_if<simulation::NoPerformance>(&effect.result)) {
      entry.set("reason", why->reason);
    } else {
      const simulation::DesignView design = std::get<simulation::EvaluatedDesign>(effect.result).view();
      entry.set("part_limits", to_json(simulation::told_part_limits(design)));
      entry.set("performance", to_json(design));
    }
    out.add(std::move(entry));
  }
  return out;
}

Json to_json(std::span<const simulation::CorrectionReach> reach) {
  return Json::list(reach, [](const simulation::CorrectionReach& each) {
    using enum actuator::CorrectionVariable;
    const std::string unit = each.variable == angle ? "_deg" : each.variable == rate ? "_rad_s" : "_A";
    return Json::object({{"variable", name_of(each.variable)},
                         Json::quantity("measured_from" + unit, each.measured_from),
                         Json::quantity("measured_to" + unit, each.measured_to),
                         Json::quantity("used_from" + unit, each.used_from),
                         Json::quantity("used_to" + unit, each.used_to),
                         {"beyond", each.is_beyond()}});
  });
}

}  // namespace coilwright::formats
