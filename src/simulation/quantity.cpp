#include "coilwright/simulation/quantity.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace coilwright::simulation {
namespace {

using Value = std::optional<double>;

constexpr double degrees = 180.0 / std::numbers::pi;

constexpr std::string_view no_change = "the current does not change the bending angle";
constexpr std::string_view no_current_allowed = "the surroundings are as hot as a limit already";
constexpr std::string_view runaway = "the current is at or beyond that of a thermal runaway";

// One row a quantity: how to get it, in the unit of its name.
constexpr std::array table = {
    Quantity{"axial_force_N", "one coil on the magnet beside it at the rest gap; repulsion is positive", 2.0,
             [](const Candidate& c) -> Value { return c.performance.axial_force; }},
    Quantity{"rest_angle_deg", "bending angle, hanging without current", 20.0,
             [](const Candidate& c) -> Value { return c.performance.motion.rest_angles.sum() * degrees; }},
    Quantity{"steady_angle_deg", "bending angle in which a step from rest ends", 60.0,
             [](const Candidate& c) -> Value { return c.performance.motion.steady_angles.sum() * degrees; }},
    Quantity{"stroke_deg", "bending angle from rest to steady", 40.0,
             [](const Candidate& c) -> Value {
               const Motion& motion = c.performance.motion;
               return (motion.steady_angles.sum() - motion.rest_angles.sum()) * degrees;
             }},
    Quantity{"peak_bending_speed_deg_s", "largest speed of the bending angle in a step from rest", 1500.0,
             [](const Candidate& c) -> Value { return c.performance.motion.peak_bending_speed * degrees; }},
    Quantity{"peak_speed_time_s", "when that speed is reached", 0.03,
             [](const Candidate& c) -> Value { return c.performance.motion.peak_speed_time; }},
    Quantity{"rise_time_s", "10 to 90 % of the change", 0.03,
             [](const Candidate& c) { return c.performance.motion.rise_time; }, no_change},
    Quantity{"overshoot_pct", "beyond the steady angle, of the change", 50.0,
             [](const Candidate& c) -> Value { return c.performance.motion.overshoot * 100.0; }},
    Quantity{"settling_time_s", "until the bending angle stays within 2 % of the change", 1.0,
             [](const Candidate& c) { return c.performance.motion.settling_time; }, no_change},
    Quantity{"damping_ratio", "of the slowest mode at the steady angle", 0.1,
             [](const Candidate& c) -> Value { return c.performance.motion.modes.front().damping_ratio; }},
    Quantity{"natural_frequency_Hz", "of the slowest mode at the steady angle", 7.0,
             [](const Candidate& c) -> Value { return c.performance.motion.modes.front().natural_frequency; }},
    Quantity{"grasp_force_N", "tip against a wall, finger straight and hanging", 1.0,
             [](const Candidate& c) -> Value { return c.performance.motion.grasp_force; }},
    Quantity{"contact_force_no_current_N", "the same without current", 0.1,
             [](const Candidate& c) -> Value { return c.performance.motion.contact_force_no_current; }},
    Quantity{"mass_g", "of the whole actuator without wires", 70.0,
             [](const Candidate& c) -> Value { return c.performance.mass * 1e3; }},
    Quantity{"width_mm", "of the cross-section", 22.0,
             [](const Candidate& c) -> Value { return c.assembly.dimensions.width * 1e3; }},
    Quantity{"height_mm", "of the cross-section", 24.0,
             [](const Candidate& c) -> Value { return c.assembly.dimensions.height * 1e3; }},
    Quantity{"effective_length_mm", "of all components and the front part", 41.0,
             [](const Candidate& c) -> Value { return c.assembly.dimensions.effective_length * 1e3; }},
    Quantity{"coil_outer_radius_mm", "of the winding", 9.5,
             [](const Candidate& c) -> Value { return c.assembly.dimensions.coil_outer_radius * 1e3; }},
    Quantity{"coil_length_mm", "of the winding", 12.0,
             [](const Candidate& c) -> Value { return c.assembly.dimensions.coil_length * 1e3; }},
    Quantity{"joint_stiffness_Nmm_rad", "of one hinge", 12.5,
             [](const Candidate& c) -> Value { return c.assembly.model.hinges().front().stiffness * 1e3; }},
    Quantity{"joint_damping_Nmms_rad", "of one hinge", 0.13,
             [](const Candidate& c) -> Value { return c.assembly.model.hinges().front().damping * 1e3; }},
    Quantity{"coil_resistance_Ohm", "of one coil at 20 degC", 4.0,
             [](const Candidate& c) -> Value { return c.performance.coil_resistance; }},
    Quantity{"inductance_mH", "of one coil", 1.0,
             [](const Candidate& c) -> Value { return c.performance.inductance * 1e3; }},
    Quantity{"current_A", "in every coil while on", 1.4, [](const Candidate& c) -> Value { return c.point.current; }},
    Quantity{"current_limit_A", "chassis-wiring ampacity of the gauge", 1.4,
             [](const Candidate& c) -> Value { return c.performance.current_limit; }},
    Quantity{"current_over_limit", "magnitude of the current over that ampacity", 1.0,
             [](const Candidate& c) -> Value { return std::abs(c.point.current) / c.performance.current_limit; }},
    Quantity{"continuous_current_A", "held for ever, the hottest coil reaches its limit", 1.1,
             [](const Candidate& c) -> Value { return c.performance.heat.continuous_current; }},
    Quantity{"magnet_continuous_current_A", "held for ever, the hottest magnet reaches its limit", 1.1,
             [](const Candidate& c) -> Value { return c.performance.heat.magnet_continuous_current; }},
    Quantity{"runaway_current_A", "from here on there is no steady temperature", 1.9,
             [](const Candidate& c) -> Value { return c.performance.heat.runaway_current; }},
    Quantity{
        "thermal_load", "rms current over the continuous current of coils and magnets; above 1 a limit is passed", 1.0,
        [](const Candidate& c) -> Value {
          const Heat& heat = c.performance.heat;
          const double rms = std::abs(c.point.current) * std::sqrt(c.point.duty);
          const double allowed = std::min(heat.continuous_current, heat.magnet_continuous_current);
          return allowed > 0.0 ? Value(rms / allowed) : Value();
        },
        no_current_allowed},
    Quantity{"coil_temperature_degC", "of the hottest coil when held", 100.0,
             [](const Candidate& c) { return c.performance.heat.coil_temperature; }, runaway},
    Quantity{"magnet_temperature_degC", "of the hottest magnet when held", 100.0,
             [](const Candidate& c) { return c.performance.heat.magnet_temperature; }, runaway},
    Quantity{"voltage_V", "across one coil at 20 degC", 5.0,
             [](const Candidate& c) -> Value { return c.performance.voltage; }},
    Quantity{"power_W", "of all coils while on, at 20 degC", 10.0,
             [](const Candidate& c) -> Value { return c.performance.power; }},
    Quantity{"cost_USD", "of coils, magnets, silicone, moulds and wires", 8.0,
             [](const Candidate& c) -> Value { return c.performance.cost; }},
};

}  // namespace

std::span<const Quantity> quantities() {
  return table;
}

const Quantity* find_quantity(std::string_view name) {
  const auto found = std::ranges::find(table, name, &Quantity::name);
  return found == table.end() ? nullptr : &*found;
}

}  // namespace coilwright::simulation
