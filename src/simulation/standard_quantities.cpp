#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "coilwright/simulation/quantity.hpp"
#include "coilwright/units/angle.hpp"

namespace coilwright::simulation {
namespace {

using actuator::HeldCases;
using Value = std::optional<double>;

constexpr auto no_change = "the current does not change the bending angle";
constexpr auto no_current_allowed = "the surroundings are as hot as a limit already";
constexpr auto no_coercivity =
    "the magnets have no grade and state no coercivity with its coefficient, or the current is at or beyond that of a "
    "thermal runaway";
constexpr auto runaway = "the current is at or beyond that of a thermal runaway";

ResultQuantity of_design(std::string name, std::string meaning, double scale, ResultQuantity::Value value,
                         std::string absence = {}) {
  return {.name = std::move(name),
          .meaning = std::move(meaning),
          .scale = scale,
          .value = std::move(value),
          .absence = std::move(absence)};
}

ResultQuantity of_pose(HeldCases pose, std::string name, std::string meaning, double scale, ResultQuantity::Value value,
                       std::string absence) {
  ResultQuantity out = of_design(std::move(name), std::move(meaning), scale, std::move(value), std::move(absence));
  out.pose = pose;
  return out;
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
          .value_of_lumped = [value](const MotionSummary& motion, double) { return value(motion); },
          .pose = HeldCases::free};
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
          .value_of_lumped = [value](const MotionSummary& motion, double) -> Value { return motion.*value; },
          .pose = HeldCases::gripping};
}

// What it does with everything at 20 degC; a lumped model knows no other.
ResultQuantity of_cold(std::string name, std::string meaning, double scale, double (*value)(const MotionSummary&)) {
  return {.name = std::move(name),
          .meaning = std::move(meaning),
          .scale = scale,
          .value = [value](const DesignView& d) -> Value { return value(d.performance.cold); },
          .value_of_lumped = [value](const MotionSummary& motion, double) -> Value { return value(motion); }};
}

ResultQuantity of_design_cold(HeldCases pose, std::string name, std::string meaning, double scale,
                              double (*value)(const MotionSummary&)) {
  ResultQuantity out = of_cold(std::move(name), std::move(meaning), scale, value);
  out.value_of_lumped = {};
  out.pose = pose;
  return out;
}

Value part_of(const Performance& performance, double actuator::Demagnetisation::*part) {
  const std::optional<actuator::Demagnetisation>& found = performance.demagnetisation;
  return found ? Value((*found).*part) : Value();
}

constexpr auto never = "the current may be held for good";
constexpr auto no_period = "the operating point states no period";
constexpr auto no_supply_voltage = "the operating point states no supply voltage";

// The heats that count at the operating point: of the free finger, the gripping one, or both.
std::vector<const Heat*> heats(const DesignView& d) {
  const Heat* free = &d.performance.free.heat;
  const Heat* gripping = &d.performance.gripping.heat;
  switch (d.point.cases) {
    case actuator::HeldCases::free:
      return {free};
    case actuator::HeldCases::gripping:
      return {gripping};
    case actuator::HeldCases::both:
      break;
  }
  return {free, gripping};
}

// The larger value of the cases that count; no value where one of them runs away.
Value hotter(const DesignView& d, std::optional<double> Heat::*part) {
  Value worst;
  for (const Heat* heat : heats(d)) {
    const Value& value = heat->*part;
    if (!value) return std::nullopt;
    worst = std::max(worst.value_or(*value), *value);
  }
  return worst;
}

Value hotter(const DesignView& d, std::optional<double> Electrics::*part) {
  Value worst;
  for (const Heat* heat : heats(d)) {
    const Value& value = heat->electrics.*part;
    if (!value) return std::nullopt;
    worst = std::max(worst.value_or(*value), *value);
  }
  return worst;
}

// The smaller value of the cases that have one.
Value soonest(const DesignView& d, std::optional<double> Heat::*part) {
  Value least;
  for (const Heat* heat : heats(d))
    if (const Value& value = heat->*part) least = std::min(least.value_or(*value), *value);
  return least;
}

// The smaller current of the cases that count.
double smaller(const DesignView& d, double Heat::*current) {
  double least = heats(d).front()->*current;
  for (const Heat* heat : heats(d)) least = std::min(least, heat->*current);
  return least;
}

Value load(const OperatingPoint& point, double allowed) {
  const double rms = std::abs(point.current) * std::sqrt(point.duty);
  return allowed > 0.0 ? Value(rms / allowed) : Value();
}

Value load(const OperatingPoint& point, const Heat& heat) {
  return load(point, heat.current_for_good());
}

// Of the whole finger at the temperatures of its operating point.
ResultQuantity of_electrics(std::string name, std::string meaning, double scale,
                            std::optional<double> Electrics::*part) {
  return of_design(
      std::move(name), std::move(meaning), scale, [part](const DesignView& d) { return hotter(d, part); }, runaway);
}

ResultQuantity of_cold_electrics(std::string name, std::string meaning, double scale,
                                 std::optional<double> Electrics::*part) {
  return of_design(std::move(name), std::move(meaning), scale,
                   [part](const DesignView& d) { return d.performance.electrics_cold.*part; });
}

// One row a quantity: its name with the unit, its meaning, an ordinary magnitude, and how to get it in that unit.
std::vector<ResultQuantity> rows() {
  return {
      of_design("axial_force_N", "force of one coil on the adjacent magnet at the rest gap; repulsion is positive", 2.0,
                [](const DesignView& d) -> Value { return d.performance.axial_force; }),
      of_cold("rest_angle_deg", "bending angle of the finger hanging without current", 20.0,
              [](const MotionSummary& motion) { return motion.rest_angles.sum() * units::degrees_per_radian; }),
      of_motion(
          "steady_angle_deg", "bending angle at the end of a step from rest", 60.0,
          [](const FreeMotion& motion) -> Value { return motion.steady_angles.sum() * units::degrees_per_radian; }),
      of_pose(
          HeldCases::free, "stroke_deg", "change of the bending angle from rest to steady", 40.0,
          [](const DesignView& d) -> Value {
            const std::optional<FreeMotion>& motion = d.performance.free.motion;
            if (!motion) return std::nullopt;
            return (motion->steady_angles.sum() - motion->rest_angles.sum()) * units::degrees_per_radian;
          },
          runaway),
      of_motion(
          "peak_bending_speed_deg_s", "largest speed of the bending angle in a step from rest", 1500.0,
          [](const FreeMotion& motion) -> Value { return motion.peak_bending_speed * units::degrees_per_radian; }),
      of_motion("peak_speed_time_s", "time at which the bending speed is largest", 0.03,
                [](const FreeMotion& motion) -> Value { return motion.peak_speed_time; }),
      of_motion(
          "rise_time_s", "time from 10 to 90 % of the change of the bending angle", 0.03,
          [](const FreeMotion& motion) { return motion.rise_time; }, no_change),
      of_motion("peak_angle_deg", "largest bending angle in a step from rest", 100.0,
                [](const FreeMotion& motion) -> Value { return motion.peak_angle * units::degrees_per_radian; }),
      of_motion("peak_joint_angle_deg", "largest angle of any one joint in a step from rest", 50.0,
                [](const FreeMotion& motion) -> Value { return motion.peak_joint_angle * units::degrees_per_radian; }),
      of_motion("smallest_joint_angle_deg", "smallest angle of any one joint at the end of a step from rest", 30.0,
                [](const FreeMotion& motion) -> Value {
                  return motion.steady_angles.minCoeff() * units::degrees_per_radian;
                }),
      of_cold("smallest_rest_joint_angle_deg", "smallest angle of any one joint of the finger hanging without current",
              10.0,
              [](const MotionSummary& motion) { return motion.rest_angles.minCoeff() * units::degrees_per_radian; }),
      of_motion("smallest_joint_stroke_deg",
                "smallest change of the angle of any one joint in a step from rest, 0 of one that stays shut, below 0 "
                "of one that closes",
                10.0,
                [](const FreeMotion& motion) -> Value {
                  return (motion.steady_angles - motion.rest_angles).minCoeff() * units::degrees_per_radian;
                }),
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
      of_design_cold(
          HeldCases::free, "steady_angle_cold_deg", "the same as steady_angle_deg with everything at 20 degC", 60.0,
          [](const MotionSummary& motion) { return motion.steady_angles.sum() * units::degrees_per_radian; }),
      of_design_cold(HeldCases::free, "peak_bending_speed_cold_deg_s",
                     "the same as peak_bending_speed_deg_s with everything at 20 degC", 1500.0,
                     [](const MotionSummary& motion) { return motion.peak_bending_speed * units::degrees_per_radian; }),
      of_design_cold(HeldCases::gripping, "grasp_force_cold_N", "the same as grasp_force_N with everything at 20 degC",
                     1.0, [](const MotionSummary& motion) { return motion.grasp_force; }),
      of_design(
          "demagnetisation_margin",
          "1 - mean field inside the worst magnet / its coercivity, at its temperature; below 0, where it is "
          "demagnetised, coercivity / field - 1",
          0.3, [](const DesignView& d) { return part_of(d.performance, &actuator::Demagnetisation::margin); },
          no_coercivity),
      of_design(
          "demagnetisation_margin_worst_point", "the same of the worst point of any magnet", 0.3,
          [](const DesignView& d) { return part_of(d.performance, &actuator::Demagnetisation::margin_worst_point); },
          no_coercivity),
      of_design(
          "irreversible_loss_pct", "what of its moment the worst magnet loses for good at its temperature and current",
          1.0,
          [](const DesignView& d) -> Value {
            const Value loss = part_of(d.performance, &actuator::Demagnetisation::irreversible_loss);
            return loss ? Value(*loss * 100.0) : Value();
          },
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
      of_design("current_limit_A",
                "ampacity of the wire gauge: a smooth law through the chassis-wiring table, or the table", 1.4,
                [](const DesignView& d) -> Value { return d.performance.current_limit; }),
      of_design("current_limit_table_A", "chassis-wiring ampacity of the wire gauge in the table", 1.4,
                [](const DesignView& d) -> Value { return d.performance.table_limit; }),
      of_design("current_over_limit", "magnitude of the largest coil current divided by that ampacity", 1.0,
                [](const DesignView& d) -> Value {
                  const double share = d.assembly.model.current_shares().cwiseAbs().maxCoeff();
                  return std::abs(d.point.current) * share / d.performance.current_limit;
                }),
      of_design("continuous_current_A", "current that, held indefinitely, brings the hottest coil to its limit", 1.1,
                [](const DesignView& d) -> Value { return smaller(d, &Heat::continuous_current); }),
      of_design("magnet_continuous_current_A",
                "current that, held indefinitely, brings the hottest magnet to its limit", 1.1,
                [](const DesignView& d) -> Value { return smaller(d, &Heat::magnet_continuous_current); }),
      of_design("runaway_current_A", "current from which on there is no steady temperature", 1.9,
                [](const DesignView& d) -> Value { return smaller(d, &Heat::runaway_current); }),
      of_design(
          "thermal_load",
          "rms current divided by the smaller continuous current of coils and magnets, the worst of the poses held",
          1.0,
          [](const DesignView& d) -> Value {
            return load(d.point,
                        std::min(smaller(d, &Heat::continuous_current), smaller(d, &Heat::magnet_continuous_current)));
          },
          no_current_allowed),
      of_pose(
          HeldCases::free, "thermal_load_free", "the same at the joint angles of the free finger", 1.0,
          [](const DesignView& d) { return load(d.point, d.performance.free.heat); }, no_current_allowed),
      of_pose(
          HeldCases::gripping, "thermal_load_gripping", "the same at the joint angles of the finger against a wall",
          1.0, [](const DesignView& d) { return load(d.point, d.performance.gripping.heat); }, no_current_allowed),
      of_design(
          "thermal_load_still_air", "thermal_load in still air, with a film coefficient from textbooks", 1.0,
          [](const DesignView& d) { return load(d.point, smaller(d, &Heat::still_air_current)); }, no_current_allowed),
      of_design(
          "time_to_limit_s", "time from cold, current on, until the first coil or magnet is at its limit", 100.0,
          [](const DesignView& d) { return soonest(d, &Heat::time_to_limit); }, never),
      of_design(
          "time_to_limit_warm_s", "the same from the steady state of the mean load, current and duty", 100.0,
          [](const DesignView& d) { return soonest(d, &Heat::time_to_limit_warm); }, never),
      of_design(
          "coil_hot_spot_degC", "steady temperature of the hottest turn in the poses held, at this current and duty",
          100.0, [](const DesignView& d) { return hotter(d, &Heat::coil_hot_spot); }, runaway),
      of_design(
          "temperature_ripple_K", "rise and fall of a coil over a period of the duty cycle, at most", 1.0,
          [](const DesignView& d) { return hotter(d, &Heat::ripple); }, no_period + std::string(", or ") + runaway),
      of_design(
          "coil_temperature_degC",
          "mean steady temperature of the hottest coil in the poses held, at this current and duty", 100.0,
          [](const DesignView& d) { return hotter(d, &Heat::coil_temperature); }, runaway),
      of_design(
          "magnet_temperature_degC",
          "steady temperature of the hottest magnet in the poses held, at this current and duty", 100.0,
          [](const DesignView& d) { return hotter(d, &Heat::magnet_temperature); }, runaway),
      of_design(
          "skin_temperature_degC",
          "steady temperature of the hottest place of the outer surface in the poses held, at this current and duty",
          60.0, [](const DesignView& d) { return hotter(d, &Heat::skin_temperature); }, runaway),
      of_electrics("coil_resistance_hot_Ohm", "resistance of the hottest coil at its steady temperature", 6.0,
                   &Electrics::resistance),
      of_electrics("voltage_V", "voltage across the hottest coil at its steady temperature", 5.0, &Electrics::voltage),
      of_cold_electrics("voltage_cold_V", "voltage across one coil at 20 degC", 5.0, &Electrics::voltage),
      of_electrics("power_W", "power of all coils while they are on, at their steady temperatures", 10.0,
                   &Electrics::power),
      of_cold_electrics("power_cold_W", "power of all coils while they are on, at 20 degC", 10.0, &Electrics::power),
      of_electrics("supply_voltage_V", "voltage that the supply needs without load, coils hot", 5.0,
                   &Electrics::supply_voltage),
      of_electrics("supply_current_A", "current that the supply delivers while the coils are on", 3.0,
                   &Electrics::supply_current),
      of_cold_electrics("supply_voltage_cold_V", "voltage that the supply needs without load, coils at 20 degC", 5.0,
                        &Electrics::supply_voltage),
      of_design(
          "supply_current_cold_A", "current that a supply of supply_voltage_V delivers before the coils are warm", 3.0,
          [](const DesignView& d) -> Value {
            const Value hot = hotter(d, &Electrics::supply_voltage);
            const Electrics& cold = d.performance.electrics_cold;
            if (!hot) return std::nullopt;
            return *hot > 0.0 ? Value(*cold.supply_current * *hot / *cold.supply_voltage) : Value(0.0);
          },
          runaway),
      of_design(
          "supply_driven_current_A", "current in every coil that the stated supply drives at most, coils hot", 1.4,
          [](const DesignView& d) -> Value {
            Value least;
            for (const Heat* heat : heats(d)) {
              const Value& value = heat->electrics.driven_current;
              if (!value) return std::nullopt;
              least = std::min(least.value_or(*value), *value);
            }
            return least;
          },
          no_supply_voltage + std::string(", or ") + runaway),
      of_design("cost_USD", "cost of coils, magnets, silicone, moulds and wires", 8.0,
                [](const DesignView& d) -> Value { return d.performance.cost; }),
  };
}

// Heat and what it takes from the magnets.
std::vector<ResultQuantity> with_what_lasts(std::vector<ResultQuantity> rows) {
  constexpr std::array lasting{"demagnetisation_margin",
                               "demagnetisation_margin_worst_point",
                               "irreversible_loss_pct",
                               "continuous_current_A",
                               "magnet_continuous_current_A",
                               "runaway_current_A",
                               "thermal_load",
                               "thermal_load_free",
                               "thermal_load_gripping",
                               "thermal_load_still_air",
                               "time_to_limit_s",
                               "time_to_limit_warm_s",
                               "coil_hot_spot_degC",
                               "coil_temperature_degC",
                               "magnet_temperature_degC",
                               "skin_temperature_degC"};
  for (ResultQuantity& row : rows) row.in_every_use = std::ranges::count(lasting, row.name) > 0;
  return rows;
}

Value angle_of(const mechanics::JointVector& angles, Eigen::Index joint) {
  return joint < angles.size() ? Value(angles[joint] * units::degrees_per_radian) : Value();
}

std::vector<ResultQuantity> rows_of_joints() {
  std::vector<ResultQuantity> out;
  for (int joint = 0; joint < mechanics::max_joints; ++joint) {
    const std::string absence = fmt::format("the actuator has no joint {}, or {}", joint + 1, runaway);
    ResultQuantity steady = of_pose(
        HeldCases::free, fmt::format("joint{}_angle_deg", joint + 1),
        fmt::format("angle of joint {} from the base at the end of a step from rest", joint + 1), 30.0,
        [joint](const DesignView& d) -> Value {
          const std::optional<FreeMotion>& motion = d.performance.free.motion;
          return motion ? angle_of(motion->steady_angles, joint) : Value();
        },
        absence);
    out.push_back(std::move(steady));
    out.push_back(of_design(
        fmt::format("rest_joint{}_angle_deg", joint + 1),
        fmt::format("angle of joint {} from the base without current", joint + 1), 10.0,
        [joint](const DesignView& d) { return angle_of(d.performance.cold.rest_angles, joint); }, absence));
  }
  return out;
}

}  // namespace

std::span<const ResultQuantity> joint_quantities() {
  static const std::vector<ResultQuantity> all = rows_of_joints();
  return all;
}

const QuantityTable& standard_quantities() {
  static const QuantityTable table{with_what_lasts(rows())};
  return table;
}

}  // namespace coilwright::simulation
