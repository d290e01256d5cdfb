#include "coilwright/formats/systems/grip_json.hpp"

#include <utility>

#include "coilwright/actuator/cost.hpp"
#include "coilwright/units/angle.hpp"

namespace coilwright::formats {
namespace {

using systems::gripper::Grasp;
using systems::gripper::GraspContact;
using systems::gripper::GripAnswer;
using systems::gripper::PlacementTolerance;
using text::Json;

}  // namespace

Json to_json(const GripAnswer& answer) {
  const Grasp& grasp = answer.grasp;
  Json contacts = Json::array();
  for (const GraspContact& each : answer.told_contacts())
    contacts.add(Json::object({{"finger", answer.finger_name(each)},
                               {"link", each.link},
                               {"along_mm", each.along * 1e3},
                               {"x_mm", each.position.x() * 1e3},
                               {"y_mm", each.position.y() * 1e3},
                               {"normal_N", each.normal},
                               {"friction_N", each.friction}}));
  Json out = Json::object({{"fingers", answer.mounting.fingers},
                           {"current_A", answer.current},
                           {"holds", grasp.holds},
                           {"touches", grasp.both_touched},
                           {"load_N", grasp.load},
                           {"capacity_N", grasp.capacity},
                           {"capacity_is_lower_bound", grasp.capacity_is_bound},
                           {"bending_left_deg", grasp.left.sum() * units::degrees_per_radian},
                           {"bending_right_deg", grasp.right.sum() * units::degrees_per_radian},
                           {"magnet_force_N", grasp.magnet_force},
                           {"settling_mm", grasp.settling * 1e3},
                           {"contacts", std::move(contacts)}});
  const auto side = [&](double value) { return grasp.holds ? Json(value) : Json(); };
  const PlacementTolerance& tolerance = answer.tolerance;
  out.set(
      "placement_tolerance",
      Json::object({{"lower_mm", side(tolerance.height.below * 1e3)},
                    {"higher_mm", side(tolerance.height.above * 1e3)},
                    {"narrower_mm", side(tolerance.width.below * 1e3)},
                    {"wider_mm", side(tolerance.width.above * 1e3)},
                    {"spacing_narrower_mm", side(tolerance.spacing.below * 1e3)},
                    {"spacing_wider_mm", side(tolerance.spacing.above * 1e3)},
                    {"mounting_further_in_deg", side(tolerance.mounting_angle.below * units::degrees_per_radian)},
                    {"mounting_further_out_deg", side(tolerance.mounting_angle.above * units::degrees_per_radian)}}));
  out.set("closing_time_ms", grasp.both_touched ? Json(grasp.closing_time * 1e3) : Json());
  if (answer.least_current) out.set("least_current_A", answer.least_current->found);
  if (answer.least_friction) out.set("least_friction", answer.least_friction->found);
  out.set("runaway_current_A", answer.burns_from);
  if (answer.magnets_cold) out.set("demagnetisation_margin", answer.magnets_cold->margin);
  if (answer.magnets_cold)
    out.set("irreversible_loss_held_pct",
            answer.magnets_held ? Json(answer.magnets_held->irreversible_loss * 100.0) : Json());
  out.set("gripper_cost_USD", answer.cost).set("pneumatic_cost_USD", actuator::PneumaticGripperCost{}.total());
  if (answer.heat) {
    out.set("continuous_current_A", answer.heat->current_for_good());
    out.set("time_to_limit_s", answer.heat->time_to_limit);
    if (const auto& driven = answer.heat->electrics.driven_current) out.set("supply_driven_current_A", *driven);
  }
  return out;
}

}  // namespace coilwright::formats
