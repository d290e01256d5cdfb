#include "coilwright/simulation/part_limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "coilwright/actuator/heat.hpp"
#include "coilwright/simulation/pressed_joints.hpp"
#include "coilwright/simulation/shut_joints.hpp"
#include "coilwright/simulation/supply.hpp"
#include "coilwright/units/angle.hpp"
#include "simulation/shut_pose.hpp"

namespace coilwright::simulation {

double PartLimit::margin() const noexcept {
  if (!value) return -1.0;
  const double distance = at_most ? limit - *value : *value - limit;
  return distance / (limit == 0.0 ? 1.0 : std::abs(limit));
}

namespace {

constexpr std::string_view hot_spot = "coil_hot_spot_degC";
constexpr std::string_view magnet_temperature = "magnet_temperature_degC";
constexpr std::string_view still_air = "thermal_load_still_air";
constexpr std::string_view load_free = "thermal_load_free";
constexpr std::string_view load_gripping = "thermal_load_gripping";
constexpr std::string_view loss = "irreversible_loss_pct";
constexpr std::string_view smallest_joint = "smallest_joint_angle_deg";
constexpr std::string_view smallest_rest_joint = "smallest_rest_joint_angle_deg";

// Of heat, under a condition: they say nothing new where a part is beyond its own limit.
constexpr std::array conditional_heat{still_air, load_gripping, load_free};

// Where one pose alone counts, the other one is the condition.
std::optional<PartLimit> limit_in_other_pose(const DesignView& design) {
  const bool free = design.point.cases == actuator::HeldCases::free;
  if (!free && design.point.cases != actuator::HeldCases::gripping) return std::nullopt;
  const std::string_view name = free ? load_gripping : load_free;
  return PartLimit{.quantity = name,
                   .value = standard_quantities().at(name).value(design),
                   .limit = 1.0,
                   .consequence = free ? "held against a wall at this current, coils or magnets overheat; temperatures "
                                         "here are of the free finger"
                                       : "held free at this current, coils or magnets overheat; temperatures here are "
                                         "of the finger that grips",
                   .conditional = true};
}

// Nothing where every joint is open; of the pressed joints the one that lies furthest beyond its faces.
std::optional<PartLimit> limit_of_joints(const DesignView& design) {
  const auto pose = shut_pose(design);
  if (!pose) return std::nullopt;
  const auto& hinges = design.assembly.model.hinges();
  const auto opening = [&](int joint) { return pose->angles[joint] - hinges[joint].contact.closing_angle; };
  const int joint = *std::ranges::min_element(pose->joints(), {}, opening);
  return PartLimit{.quantity = pose->under_current.empty() ? smallest_rest_joint : smallest_joint,
                   .value = pose->angles[joint] * units::degrees_per_radian,
                   .limit = hinges[joint].contact.closing_angle * units::degrees_per_radian,
                   .at_most = false,
                   .consequence = pressed_joints_text(pose->at_rest, pose->under_current),
                   .conditional = true};
}

}  // namespace

std::vector<PartLimit> part_limits(const DesignView& design) {
  const auto value = [&](std::string_view name) { return standard_quantities().at(name).value(design); };
  std::vector<PartLimit> limits{
      {.quantity = hot_spot,
       .value = value(hot_spot),
       .limit = design.design.surroundings.coil_limit,
       .consequence = "the enamel of the wire fails"},
      {.quantity = magnet_temperature,
       .value = value(magnet_temperature),
       .limit = design.design.magnet.temperature_limit,
       .consequence = "the magnets lose magnetisation for good"},
      {.quantity = "current_over_limit",
       .value = value("current_over_limit"),
       .limit = 1.0,
       .consequence = "the wire carries more than its chassis-wiring ampacity; heat decides whether it may"},
  };
  if (design.point.supply.voltage)
    limits.push_back({.quantity = supply_load().name,
                      .value = supply_load().value(design),
                      .limit = 1.0,
                      .consequence = "the supply has not the voltage to drive this current through the warm coils, and "
                                     "nothing here is reached"});
  if (design.design.magnet.has_coercivity())
    limits.push_back({.quantity = loss,
                      .value = value(loss),
                      .limit = most_irreversible_loss,
                      .consequence =
                          "the worst magnet is weaker from then on, from the middle of its faces inwards: every "
                          "force falls by as much"});
  if (design.design.choices.film == actuator::FilmChoice::calibrated)
    limits.push_back({.quantity = still_air,
                      .value = value(still_air),
                      .limit = 1.0,
                      .consequence = fmt::format("only moving air, or a mount that conducts, carries this heat away "
                                                 "({:.0f} W/m2K are taken); in still air coils or magnets overheat",
                                                 actuator::calibrated_film(design.design)),
                      .conditional = true});
  if (auto joints = limit_of_joints(design)) limits.push_back(std::move(*joints));
  if (auto other = limit_in_other_pose(design)) limits.push_back(std::move(*other));
  return limits;
}

std::vector<PartLimit> told(std::vector<PartLimit> limits, const DesignView& design) {
  for (PartLimit& limit : limits)
    if (limit.quantity == smallest_joint || limit.quantity == smallest_rest_joint)
      if (const std::string cause = what_shuts_joints(design); !cause.empty()) limit.consequence += "; " + cause;
  return limits;
}

std::vector<PartLimit> broken_part_limits(const DesignView& design) {
  std::vector<PartLimit> out = part_limits(design);
  std::erase_if(out, [](const PartLimit& limit) { return !limit.is_broken(); });
  const auto is_broken = [&out](std::string_view name) {
    return std::ranges::find(out, name, &PartLimit::quantity) != out.end();
  };
  if (is_broken(hot_spot) || is_broken(magnet_temperature))
    std::erase_if(out, [](const PartLimit& limit) {
      return std::ranges::find(conditional_heat, limit.quantity) != conditional_heat.end();
    });
  return out;
}

}  // namespace coilwright::simulation
