#include "coilwright/formats/systems/task_rows.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace coilwright::formats {
namespace {

using namespace systems;
using namespace systems::gripper;
using drive::BridgeRatings;
using drive::CellSwitch;
using drive::HBridge;
using text::choice_row;
using text::row;
using text::Row;
using text::Rule;
using enum text::Need;

// Above zero, and within what any hardware has.
constexpr Rule up_to(double most) {
  return text::positive.and_also(Rule::at_most(most));
}

constexpr Rule pulses = Rule::between(0.1, 1e6);         // Hz
constexpr Rule supply_voltage = up_to(1e3);              // V
constexpr Rule line_resistance = Rule::between(0, 1e3);  // ohm
constexpr double most_switch = 100.0;                    // ohm
constexpr Rule switch_mOhm = Rule::between(0, 1e3 * most_switch);
constexpr Rule cell_mAh = up_to(1e6);
constexpr Rule cell_limit = up_to(1e3);  // A
constexpr Rule switching_us = Rule::between(0, 1e3);

constexpr auto parts = &CrawlTask::parts;
constexpr auto feet = &CrawlerParts::friction;
constexpr auto pulse = &CrawlerParts::drive;
constexpr auto cell = &CrawlerParts::cell;
constexpr auto load = &CrawlerParts::payload;
constexpr auto timing = &CrawlTask::timing;
constexpr std::array crawl = {
    row<parts, feet, &FootFriction::forwards>("friction_forwards", up_to(10),
                                              "Coefficient of friction of a foot that slides towards the fingertip",
                                              required),
    row<parts, feet, &FootFriction::backwards>("friction_backwards", up_to(10), "Of one that slides towards the rear",
                                               required),
    row<parts, pulse, &PulseDrive::frequency>("frequency_Hz", Rule::between(0.1, 1e3), "Frequency of the pulses"),
    row<parts, pulse, &PulseDrive::duty>("duty", text::positive.and_also(Rule::below(1)),
                                         "Fraction of a period with the switch closed"),
    row<parts, cell, &Cell::voltage>("cell_voltage_V", up_to(100), "Voltage of the cell"),
    row<parts, cell, &Cell::capacity>("cell_capacity_mAh", cell_mAh, "Capacity of the cell"),
    row<parts, cell, &Cell::current_limit>("cell_limit_A", cell_limit, "The most that the cell delivers"),
    row<parts, pulse, &PulseDrive::lead_resistance>("lead_resistance_Ohm", line_resistance,
                                                    "Of switch and leads, which carry the current of all coils"),
    row<parts, load, &Payload::mass>("payload_mass_g", up_to(1e4), "Of battery, board and longer rear part"),
    row<parts, load, &Payload::length>("payload_length_mm", up_to(1e3), "By which the rear part is longer"),
    row<timing, &CrawlTiming::step>("step_ms", Rule::between(1e-3, 1), "Longest time step", fixed),
    row<timing, &CrawlTiming::settling_periods>("settling_periods", Rule::between(0, 10000),
                                                "Periods before it is measured"),
    row<timing, &CrawlTiming::periods>("periods", Rule::between(1, 10000), "Periods over which it is measured"),
};

constexpr std::array driver = {
    Row<DriverTask>{{.key = "kind",
                     .meaning = "h_bridge, which shorts the coils while off, or cell, with a switch and a diode across "
                                "the coils",
                     .need = required,
                     .words = DriverTask::kind_words},
                    [](const DriverTask& task) -> std::optional<double> { return static_cast<double>(task.kind); },
                    [](DriverTask& task, double value) {
                      task.kind = static_cast<DriverTask::Kind>(value);
                      if (task.kind == DriverTask::Kind::cell)
                        task.switch_resistance = drive::CellSwitch{}.switch_resistance;
                    }},
    row<&DriverTask::voltage>("voltage_V", supply_voltage,
                              "Of the open circuit: give an emptying cell its lowest, or scatter it", required),
    row<&DriverTask::resistance>("resistance_Ohm", line_resistance, "Inside, with leads"),
    row<&DriverTask::switch_resistance>("switch_resistance_Ohm", Rule::between(0, most_switch),
                                        "Of all switches that the current passes; 0.05 of a cell"),
    row<&DriverTask::frequency>("frequency_Hz", pulses, "Of the pulses"),
    row<&DriverTask::most_current>("most_current_A", up_to(1e3), "That bridge or cell bears, of all coils"),
};

// As the meanings of rows say.
static_assert(drive::HBridge{}.diode_voltage == 0.8 && drive::CellSwitch{}.diode_voltage == 0.4);
static_assert(drive::CellSwitch{}.switch_resistance == 0.05);

constexpr auto question = &DriveTask::question;
constexpr auto bridge = &DriveTask::bridge;
constexpr auto ratings = &HBridge::ratings;
constexpr auto of_cell = &DriveTask::cell;
constexpr auto circuit = &CellDrive::circuit;
constexpr std::array driven = {
    row<question, &DriveQuestion::duty>("duty", Rule::between(0, 1),
                                        "Fraction of a period that is switched on, 0 to 1"),
    row<question, &DriveQuestion::mean>(
        "mean_A", up_to(100),
        "Wanted mean current of a coil: finds the duty for it, or with --duty the supply voltage"),
    row<question, &DriveQuestion::frequency>("frequency_Hz", pulses, "Frequency of the pulses"),
    choice_row<question, &DriveQuestion::wiring>("wiring", drive::bank_wiring_words,
                                                 "parallel or series: how all coils hang on the driver"),
    row<question, &DriveQuestion::actuators>("actuators", Rule::between(1, 16), "Like actuators on the same driver"),
    row<question, &DriveQuestion::coil_temperature>("coil_temperature_degC", Rule::between(-50, 200),
                                                    "Mean temperature of the coils"),
    row<bridge, &HBridge::supply_voltage>("supply_voltage_V", supply_voltage, "Of the H-bridge's supply"),
    choice_row<bridge, &HBridge::decay>("decay", drive::decay_words,
                                        "slow (coils shorted while off) or fast (current returned to the supply)"),
    row<bridge, &HBridge::trip>("current_limit_A", up_to(100), "At which the H-bridge chops; absent: never"),
    row<bridge, &HBridge::supply_resistance>("supply_resistance_Ohm", line_resistance,
                                             "Inside supply or cell, with leads"),
    row<bridge, &HBridge::high_resistance>("high_resistance_mOhm", switch_mOhm, "Of a high switch"),
    row<bridge, &HBridge::low_resistance>("low_resistance_mOhm", switch_mOhm, "Of a low switch"),
    row<bridge, &HBridge::dead_time>("dead_time_us", switching_us, "Between switches"),
    row<bridge, &HBridge::limit_off_time>("limit_off_time_us", Rule::between(1, 1e4),
                                          "For which the current limit switches off"),
    row<bridge, &HBridge::limit_blanking>("limit_blanking_us", switching_us,
                                          "In which the limit does not look after switching on"),
    row<&DriveTask::diode_voltage>("diode_voltage_V", Rule::between(0, 10),
                                   "Of a diode; otherwise 0.8 in a bridge, 0.4 across the coils at a cell"),
    row<bridge, ratings, &BridgeRatings::lowest_voltage>("bridge_lowest_V", Rule::between(0, 1e3),
                                                         "Supply from which the H-bridge works"),
    row<bridge, ratings, &BridgeRatings::highest_voltage>("bridge_highest_V", supply_voltage,
                                                          "Supply up to which the H-bridge works"),
    row<bridge, ratings, &BridgeRatings::peak_current>("bridge_peak_A", up_to(1e3), "Current that the H-bridge bears"),
    row<of_cell, circuit, &CellSwitch::emf>("cell_voltage_V", supply_voltage,
                                            "Drives by a battery cell of this open voltage through a switch instead"),
    row<of_cell, &CellDrive::capacity>("cell_capacity_mAh", cell_mAh, "Of the cell; says how long it lasts"),
    row<of_cell, &CellDrive::most_current>(
        "cell_limit_A", cell_limit,
        "The most that the cell delivers; otherwise 20 times its capacity an hour, where that is given"),
    row<of_cell, circuit, &CellSwitch::switch_resistance>("switch_resistance_mOhm", switch_mOhm,
                                                          "Of the cell's switch"),
};

constexpr auto mounting = &GripperTask::mounting;
constexpr auto object = &GripperTask::object;
constexpr Rule any_place = Rule::between(-1e3, 1e3);  // mm
constexpr std::array grip = {
    choice_row<object, &Object::shape>(
        "shape", shape_words,
        "sphere, cylinder (its axis across the fingers' plane), box, or upright_cylinder (a cup, its axis that of the "
        "gripper)"),
    row<object, &Object::width>("width_mm", up_to(1e3), "Diameter, or width of a box between the fingers", required),
    row<object, &Object::height>("height_mm", up_to(1e3), "Height of a box or an upright cylinder", required),
    // Contacts are solved to a share of the fingers' impulses: what weighs less than a milligram is lost in that.
    row<object, &Object::mass>("mass_g", Rule::between(1e-3, 1e5), "Mass of the object", required),
    row<object, &Object::friction>("friction", up_to(10), "Coefficient of friction between it and the fingers",
                                   required),
    Row<GripperTask>{{.key = "centre_x_mm",
                      .rule = any_place,
                      .meaning = "Its centre from the middle between the fingers; 0 of more than two"},
                     [](const GripperTask& task) { return std::optional(task.object.centre.x()); },
                     [](GripperTask& task, double value) { task.object.centre.x() = value; }},
    Row<GripperTask>{{.key = "centre_below_palm_mm",
                      .rule = any_place,
                      .meaning = "Its centre below the line through the base joints"},
                     [](const GripperTask& task) { return std::optional(-task.object.centre.y()); },
                     [](GripperTask& task, double value) { task.object.centre.y() = -value; }},
    row<mounting, &Mounting::angle>("mounting_angle_deg", Rule::between(-89, 89),
                                    "Of each straight finger with the gripper's axis, outwards"),
    row<mounting, &Mounting::fingers>(
        "fingers", Rule::between(2, most_fingers),
        "How many, evenly round the gripper's axis; more than two hold a sphere or an upright cylinder"),
    row<mounting, &Mounting::spacing>("spacing_mm", up_to(1e3),
                                      "Between the two base joints, or diameter of the circle of more"),
    choice_row<mounting, &Mounting::polarity>(
        "polarity", polarity_words,
        "same (identical fingers, whose magnets repel) or opposite (every second one turned)"),
    row<&GripperTask::open_current>(
        "open_current_A", Rule::between(-100, 100),
        "Before it closes, while the object is put between the fingers; below zero it opens them"),
    row<&GripperTask::acceleration>("acceleration_m_s2", Rule::between(0, 1e3), "Upwards, that the hold must survive"),
    row<&GripperTask::most_current>(
        "least_current_up_to_A", up_to(100),
        "Up to which the least current that holds is looked for; in a study otherwise the ampacity of the wire", fixed),
};

}  // namespace

std::span<const Row<CrawlTask>> crawl_rows() {
  return crawl;
}

std::span<const Row<DriverTask>> driver_rows() {
  return driver;
}

std::span<const Row<DriveTask>> drive_rows() {
  return driven;
}

std::vector<Row<GripperTask>> grip_rows(const GripperTask& base) {
  std::vector<Row<GripperTask>> out(grip.begin(), grip.end());
  if (!base.object.has_flat_sides()) std::erase_if(out, [](const auto& each) { return each.key == "height_mm"; });
  if (base.mounting.fingers > 2)
    std::ranges::find(out, "centre_x_mm", &text::RowFacts::key)->rule = Rule::between(0.0, 0.0);
  return out;
}

DriveQuestion DriveTask::asked() const {
  DriveQuestion out = question;
  if (cell.circuit.emf > 0.0) {
    CellDrive chosen = cell;
    chosen.circuit.resistance = bridge.supply_resistance;
    chosen.circuit.diode_voltage = diode_voltage.value_or(chosen.circuit.diode_voltage);
    out.driver = chosen;
  } else {
    HBridge chosen = bridge;
    chosen.diode_voltage = diode_voltage.value_or(chosen.diode_voltage);
    out.driver = chosen;
  }
  return out;
}

}  // namespace coilwright::formats
