#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "coilwright/simulation/quantity.hpp"

namespace coilwright::simulation {
namespace {

using Value = std::optional<double>;

constexpr double degrees = 180.0 / std::numbers::pi;

constexpr auto no_change = "the current does not change the bending angle";
constexpr auto no_current_allowed = "the surroundings are as hot as a limit already";
constexpr auto no_coercivity =
    "the magnets have no grade and so no known coercivity, or the current is at or beyond that of a thermal runaway";
constexpr auto runaway = "the current is at or beyond that of a thermal runaway";

ResultQuantity of_design(std::string name, std::string meaning, double scale, ResultQuantity::Value value,
                         std::string absence = {}) {
  return {.name = std::move(name),
          .meaning = std::move(meaning),
          .scale = scale,
          .value = std::move(value),
          .absence = std::move(absence)};
}

// What a model tells by its free motion alone, and hence a lumped model too; of a design at the steady temperatures of
// its operating point.
ResultQuantity of_motion(std::string name, std::string meaning, double scale,
                         std::optional<double> (*value)(const FreeMotion&), std::string absence = {}) {
  absence = absence.empty() ? runaway : absence + ", or " + runaway;
  return {.name = std::move(name),
          .meaning = std::move(meaning),
          .scale = scale,
          .value = [value](const DesignView& d) -> Value {
            const std::optional<FreeMotion>& motion = d.performance.free.motion;
            return motion ? value(*motion) : std::nullopt;
          },
          .absence = std::move(absence),
          .value_of_lumped = [value](const MotionSummary& motion, double) { return value(motion); }};
}

// The same of a finger whose tip is held.
ResultQuantity of_grasp(std::string name, std::string meaning, double scale, double Grasp::*value) {
  return {.name = std::move(name),
          .meaning = std::move(meaning),
          .scale = scale,
          .value = [value](const DesignView& d) -> Value {
            const std::optional<Grasp>& grasp = d.performance.gripping.grasp;
            return grasp ? Value((*grasp).*value) : Value();
          },
          .absence = runaway,
          .value_of_lumped = [value](const MotionSummary& motion, double) -> Value { return motion.*value; }};
}

// What it does with everything at 20 degC; a lumped model knows no other.
ResultQuantity of_cold(std::string name, std::string meaning, double scale, double (*value)(const MotionSummary&)) {
  return {.name = std::move(name),
          .meaning = std::move(meaning),
          .scale = scale,
          .value = [value](const DesignView& d) -> Value { return value(d.performance.cold); },
          .value_of_lumped = [value](const MotionSummary& motion, double) -> Value { return value(motion); }};
}

ResultQuantity of_design_cold(std::string name, std::string meaning, double scale,
                              double (*value)(const MotionSummary&)) {
  ResultQuantity out = of_cold(std::move(name), std::move(meaning), scale, value);
  out.value_of_lumped = {};
  return out;
}

// The hotter of the free finger and the gripping one; no value where one of them runs away.
Value hotter(const Performance& performance, std::optional<double> Heat::*part) {
  const std::optional<double>& free = performance.free.heat.*part;
  const std::optional<double>& gripping = performance.gripping.heat.*part;
  return free && gripping ? Value(std::max(*free, *gripping)) : Value();
}

Value part_of(const Performance& performance, double actuator::Demagnetisation::*part) {
  const std::optional<actuator::Demagnetisation>& found = performance.demagnetisation;
  return found ? Value((*found).*part) : Value();
}

// The smaller current of the two.
double smaller(const Performance& performance, double Heat::*current) {
  return std::min(performance.free.heat.*current, performance.gripping.heat.*current);
}

// One row a quantity: its name with the unit, its meaning, an ordinary magnitude, and how to get it in that unit.
std::vector<ResultQuantity> rows() {
  return {
      of_design("axial_force_N", "force of one coil on the adjacent magnet at the rest gap; repulsion is positive", 2.0,
                [](const DesignView& d) -> Value { return d.performance.axial_force; }),
      of_cold("rest_angle_deg", "bending angle of the finger hanging without current", 20.0,
              [](const MotionSummary& motion) { return motion.rest_angles.sum() * degrees; }),
      of_motion("steady_angle_deg", "bending angle at the end of a step from rest", 60.0,
                [](const FreeMotion& motion) -> Value { return motion.steady_angles.sum() * degrees; }),
      of_design(
          "stroke_deg", "change of the bending angle from rest to steady", 40.0,
          [](const DesignView& d) -> Value {
            const std::optional<FreeMotion>& motion = d.performance.free.motion;
            if (!motion) return std::nullopt;
            return (motion->steady_angles.sum() - motion->rest_angles.sum()) * degrees;
          },
          runaway),
      of_motion("peak_bending_speed_deg_s", "largest speed of the bending angle in a step from rest", 1500.0,
                [](const FreeMotion& motion) -> Value { return motion.peak_bending_speed * degrees; }),
      of_motion("peak_speed_time_s", "time at which the bending speed is largest", 0.03,
                [](const FreeMotion& motion) -> Value { return motion.peak_speed_time; }),
      of_motion(
          "rise_time_s", "time from 10 to 90 % of the change of the bending angle", 0.03,
          [](const FreeMotion& motion) { return motion.rise_time; }, no_change),
      of_motion("peak_angle_deg", "largest bending angle in a step from rest", 100.0,
                [](const FreeMotion& motion) -> Value { return motion.peak_angle * degrees; }),
      of_motion("peak_joint_angle_deg", "largest angle of any one joint in a step from rest", 50.0,
                [](const FreeMotion& motion) -> Value { return motion.peak_joint_angle * degrees; }),
      of_motion("overshoot_pct", "excess over the steady angle, relative to the change", 50.0,
                [](const FreeMotion& motion) -> Value { return motion.overshoot * 100.0; }),
      of_motion(
          "settling_time_s", "time until the bending angle stays within 2 % of the change", 1.0,
          [](const FreeMotion& motion) { return motion.settling_time; }, no_change),
      of_motion("damping_ratio", "damping ratio of the slowest mode at the steady angle", 0.1,
                [](const FreeMotion& motion) -> Value { return motion.modes.front().damping_ratio; }),
      of_motion("natural_frequency_Hz", "natural frequency of the slowest mode at the steady angle", 7.0,
                [](const FreeMotion& motion) -> Value { return motion.modes.front().natural_frequency; }),
      of_grasp("grasp_force_N",
               "force against a wall at the grasp's opening and height; by default of the tip of the straight finger",
               1.0, &Grasp::grasp_force),
      of_cold("contact_force_no_current_N", "force against that wall without current", 0.1,
              [](const MotionSummary& motion) { return motion.contact_force_no_current; }),
      of_design_cold("steady_angle_cold_deg", "the same as steady_angle_deg with everything at 20 degC", 60.0,
                     [](const MotionSummary& motion) { return motion.steady_angles.sum() * degrees; }),
      of_design_cold("peak_bending_speed_cold_deg_s", "the same as peak_bending_speed_deg_s with everything at 20 degC",
                     1500.0, [](const MotionSummary& motion) { return motion.peak_bending_speed * degrees; }),
      of_design_cold("grasp_force_cold_N", "the same as grasp_force_N with everything at 20 degC", 1.0,
                     [](const MotionSummary& motion) { return motion.grasp_force; }),
      of_design(
          "demagnetisation_margin", "1 - mean field inside the worst magnet / its coercivity, at its temperature", 0.3,
          [](const DesignView& d) { return part_of(d.performance, &actuator::Demagnetisation::margin); },
          no_coercivity),
      of_design(
          "demagnetisation_margin_worst_point", "the same of the worst point of any magnet", 0.3,
          [](const DesignView& d) { return part_of(d.performance, &actuator::Demagnetisation::margin_worst_point); },
          no_coercivity),
      of_design("mass_g", "mass of the whole actuator without wires", 70.0,
                [](const DesignView& d) -> Value { return d.performance.mass * 1e3; }),
      of_design("width_mm", "width of the cross-section", 22.0,
                [](const DesignView& d) -> Value { return d.assembly.dimensions.width * 1e3; }),
      of_design("height_mm", "height of the cross-section", 24.0,
                [](const DesignView& d) -> Value { return d.assembly.dimensions.height * 1e3; }),
      of_design("effective_length_mm", "length of all components and the front part", 41.0,
                [](const DesignView& d) -> Value { return d.assembly.dimensions.effective_length * 1e3; }),
      of_design("coil_outer_radius_mm", "outer radius of the winding", 9.5,
                [](const DesignView& d) -> Value { return d.assembly.dimensions.coil_outer_radius * 1e3; }),
      of_design("coil_length_mm", "length of the winding", 12.0,
                [](const DesignView& d) -> Value { return d.assembly.dimensions.coil_length * 1e3; }),
      of_design("joint_stiffness_Nmm_rad", "stiffness of one hinge", 12.5,
                [](const DesignView& d) -> Value { return d.assembly.model.hinges().front().stiffness * 1e3; }),
      of_design("joint_damping_Nmms_rad", "damping of one hinge", 0.13,
                [](const DesignView& d) -> Value { return d.assembly.model.hinges().front().damping * 1e3; }),
      of_design("coil_resistance_Ohm", "resistance of one coil at 20 degC", 4.0,
                [](const DesignView& d) -> Value { return d.performance.coil_resistance; }),
      of_design("inductance_mH", "inductance of one coil", 1.0,
                [](const DesignView& d) -> Value { return d.performance.inductance * 1e3; }),
      {.name = "current_A",
       .meaning = "current in every coil while it is on",
       .scale = 1.4,
       .value = [](const DesignView& d) -> Value { return d.point.current; },
       .value_of_lumped = [](const MotionSummary&, double current) -> Value { return current; }},
      of_design("current_limit_A", "chassis-wiring ampacity of the wire gauge", 1.4,
                [](const DesignView& d) -> Value { return d.performance.current_limit; }),
      of_design("current_over_limit", "magnitude of the current divided by that ampacity", 1.0,
                [](const DesignView& d) -> Value { return std::abs(d.point.current) / d.performance.current_limit; }),
      of_design("continuous_current_A", "current that, held indefinitely, brings the hottest coil to its limit", 1.1,
                [](const DesignView& d) -> Value { return smaller(d.performance, &Heat::continuous_current); }),
      of_design("magnet_continuous_current_A",
                "current that, held indefinitely, brings the hottest magnet to its limit", 1.1,
                [](const DesignView& d) -> Value { return smaller(d.performance, &Heat::magnet_continuous_current); }),
      of_design("runaway_current_A", "current from which on there is no steady temperature", 1.9,
                [](const DesignView& d) -> Value { return smaller(d.performance, &Heat::runaway_current); }),
      of_design(
          "thermal_load", "rms current divided by the smaller continuous current of coils and magnets", 1.0,
          [](const DesignView& d) -> Value {
            const double rms = std::abs(d.point.current) * std::sqrt(d.point.duty);
            const double allowed = std::min(smaller(d.performance, &Heat::continuous_current),
                                            smaller(d.performance, &Heat::magnet_continuous_current));
            return allowed > 0.0 ? Value(rms / allowed) : Value();
          },
          no_current_allowed),
      of_design(
          "coil_temperature_degC", "steady temperature of the hottest coil at this current and duty", 100.0,
          [](const DesignView& d) { return hotter(d.performance, &Heat::coil_temperature); }, runaway),
      of_design(
          "magnet_temperature_degC", "steady temperature of the hottest magnet at this current and duty", 100.0,
          [](const DesignView& d) { return hotter(d.performance, &Heat::magnet_temperature); }, runaway),
      of_design("voltage_V", "voltage across one coil at 20 degC", 5.0,
                [](const DesignView& d) -> Value { return d.performance.voltage; }),
      of_design("power_W", "power of all coils while they are on, at 20 degC", 10.0,
                [](const DesignView& d) -> Value { return d.performance.power; }),
      of_design("cost_USD", "cost of coils, magnets, silicone, moulds and wires", 8.0,
                [](const DesignView& d) -> Value { return d.performance.cost; }),
  };
}

}  // namespace

const QuantityTable& standard_quantities() {
  static const QuantityTable table{rows()};
  return table;
}

}  // namespace coilwright::simulation
