#include "exports/workshop/sheets.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>
#include <sstream>

#include "coilwright/actuator/design/current_shares.hpp"
#include "coilwright/actuator/heat.hpp"
#include "coilwright/text/csv/csv_writer.hpp"
#include "coilwright/thermal/steady_state.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::exports {
namespace {

using actuator::ComponentKind;

// Of an alkaline cell, fresh and without load, V.
constexpr double cell_voltage = 1.5;

double in_mm(double length) {
  return 1e3 * length;
}

bool is_magnet(const BodyPlan& plan, std::size_t part) {
  return part < plan.parts.size() && plan.parts[part].component.kind == ComponentKind::magnet;
}

// The wall towards a magnet is thinner than most wires.
std::string_view start_face(const BodyPlan& plan, std::size_t coil) {
  const bool behind = coil > 0 && is_magnet(plan, coil - 1);
  const bool before = is_magnet(plan, coil + 1);
  if (behind && before) return "neither";
  if (!behind && !before) return "either";
  return behind ? "tip" : "base";
}

PartRow row_of(const BodyPlan& plan, std::size_t index) {
  const PlacedPart& part = plan.parts[index];
  const int number = static_cast<int>(index) + 1;
  const bool positive = part.component.polarity > 0;
  // A positive current sets a coil's moment against that of a magnet of the same polarity (towards the tip).
  if (is_magnet(plan, index))
    return {.number = number,
            .kind = ComponentKind::magnet,
            .centre = part.centre,
            .north_towards = positive ? "tip" : "base",
            .current = "",
            .positive_lead = "",
            .start_face = ""};
  return {.number = number,
          .kind = ComponentKind::coil,
          .centre = part.centre,
          .north_towards = positive ? "base" : "tip",
          .current = positive ? "clockwise" : "anticlockwise",
          .positive_lead = positive ? "start" : "end",
          .start_face = start_face(plan, index)};
}

std::string_view effect_at(const actuator::Component& near, const actuator::Component& far) {
  if (near.kind == far.kind) return "nearly nothing";
  return near.polarity * far.polarity > 0 ? "pushes apart" : "pulls together";
}

std::vector<JointRow> joints_of(const DesignSubject& subject, const BodyPlan& plan) {
  std::vector<JointRow> rows;
  for (std::size_t j = 0; j < plan.joints.size(); ++j)
    rows.push_back({.number = static_cast<int>(j) + 1,
                    .place = plan.joints[j],
                    .gap = actuator::gap_of_joint(subject.design, static_cast<int>(j)),
                    .effect = effect_at(plan.parts[j].component, plan.parts[j + 1].component)});
  return rows;
}

// Between magnets there is a pull or a push without any current, too strong for uncured silicone.
std::string_view remark_on_magnets(int magnets) {
  return magnets < 2 ? "" : " The magnets act on each other through the coils: hold them in place until it has cured.";
}

// A coil between two magnets has no face where its start is out of the way.
std::string remark_on_starts(const AssemblyOrder& order, const Recipe& recipe, const WindingSheet& winding) {
  const bool between = std::ranges::count(order.parts, "neither", &PartRow::start_face) > 0;
  if (!between || winding.wire.insulated_diameter <= recipe.coil_dip) return "";
  return fmt::format(
      " Where it says neither, the start crosses a wall of {:.3g} mm with a wire of {:.3g} mm, and that gap grows by "
      "the difference.",
      in_mm(recipe.coil_dip), in_mm(winding.wire.insulated_diameter));
}

std::vector<std::string> steps_of(const DesignSubject& subject, const AssemblyOrder& order, const Cast& cast,
                                  const Recipe& recipe, const WindingSheet& winding) {
  const BodyPlan& plan = cast.plan;
  return {
      fmt::format("Wind {} coil{} by the winding sheet: mark the face that will look towards the tip, and seen from it "
                  "lead the wire clockwise from its start at the bore. The start leaves the bore over the face that "
                  "the table names, where no magnet will be.{} Mark the start. Fix the turns, take the bobbin out, and "
                  "compare the resistance with the sheet.",
                  winding.coils, winding.coils == 1 ? "" : "s", remark_on_starts(order, recipe, winding)),
      std::string("Find the north face of each magnet with a compass (the end of the needle that points north turns "
                  "away from it) and mark it."),
      subject.design.bottom_silicone
          ? fmt::format("Mix and de-air the batch of the bottom layer and pour it into the mould, {:.4g} mm high. "
                        "While it is still tacky, mix and de-air the next batch and pour the main body onto it.",
                        in_mm(plan.bottom_layer))
          : std::string("Mix and de-air the first batch. Pour the main body into the mould."),
      fmt::format("Dip all coils and magnets whole into what is left of it, once. One dip must leave a wall of {:.3g} "
                  "mm on a face (the source paper's: 0.3 mm); wipe the round side so that no more than {:.3g} mm stay "
                  "there. Let all of it cure for 12 hours at room temperature; the magnets bear {:.4g} degC at most.",
                  in_mm(recipe.coil_dip), in_mm(cast.clearance), subject.design.magnet.temperature_limit),
      fmt::format("Mix the batch of the second dip and dip the magnets again, to a wall of {:.3g} mm on each face. The "
                  "coils keep their {:.3g} mm: the pockets leave no room for more. Let it cure for 12 hours.",
                  in_mm(recipe.magnet_dip), in_mm(recipe.coil_dip)),
      "Do the checks before bonding, below.",
      fmt::format("Mix the last batch. Lay the parts into the pockets of the main body in the order and sense of the "
                  "table, marked faces of the coils towards the tip, wall against wall. Lead the wires out at the top. "
                  "Fill the bores and the pockets up to the upside of the body, and let it cure for 12 hours.{}",
                  remark_on_magnets(subject.assembly.magnets)),
      fmt::format("Solder flexible silicone wires to the leads. Cut the slits across the body at the places of the "
                  "joints, between wall and wall, from the upside down to {:.4g} mm above the underside, and no "
                  "deeper: what is left is the hinge.",
                  in_mm(plan.bottom_layer)),
      "Do the checks after cutting, below.",
  };
}

std::string cell_text(const WindingSheet& winding) {
  const double resistance = meter_reading(winding, 20.0).expected;
  const double current = cell_voltage / resistance;
  if (current <= winding.current_limit)
    return fmt::format("A cell of {:.2g} V drives {:.3g} A through one coil, below the {:.3g} A of its wire",
                       cell_voltage, current, winding.current_limit);
  return fmt::format(
      "A cell of {:.2g} V would drive {:.3g} A through one coil, more than the {:.3g} A of its wire: put a resistor of "
      "{:.2g} ohm in series, or touch for a moment only",
      cell_voltage, current, winding.current_limit, cell_voltage / winding.current_limit - resistance);
}

// Straight, coils and magnets are nearest to each other, and heat each other most.
std::string coils_of(const actuator::Design& design) {
  if (has_one_current(design)) return "in every coil";
  return fmt::format("of which the coils, base to tip, carry {} on drivers of their own",
                     fmt::join(actuator::current_shares(design), " and "));
}

std::string operation_text(const DesignSubject& subject) {
  const auto straight = mechanics::JointVector::Zero(subject.assembly.model.joints());
  const thermal::CurrentLimits limits =
      thermal::current_limits(actuator::heat_network(subject.design, subject.assembly, straight));
  std::string text = fmt::format(
      "In use. Straight, at {:.4g} degC around it, the actuator holds {:.3g} A {} for good; then {} at its limit. From "
      "{:.3g} A on nothing holds its temperature: it burns.",
      subject.design.surroundings.ambient, limits.for_good(), coils_of(subject.design),
      limits.coils <= limits.magnets ? "the hottest coil is" : "the hottest magnet is", limits.runaway);
  if (subject.design.choices.film == actuator::FilmChoice::calibrated) {
    const thermal::CurrentLimits still =
        thermal::current_limits(actuator::still_air_network(subject.design, subject.assembly, straight));
    text += fmt::format(
        " That takes {:.0f} W/m2K at its surface, as the continuous current of the actuator's file asks for; air that "
        "stands still carries less away, and then it holds {:.3g} A.",
        actuator::calibrated_film(subject.design), still.for_good());
  }
  if (const auto& point = subject.operating_point)
    text += fmt::format(" It was sized for {:.4g} A{}.", point->current,
                        point->duty < 1.0 ? fmt::format(" during {:.3g} of the time", point->duty) : "");
  return text;
}

std::vector<std::string> checks_of(const DesignSubject& subject, const AssemblyOrder& order,
                                   const WindingSheet& winding) {
  std::vector<std::string> checks = {
      "Before bonding. " + cell_text(winding) +
      ". Connect its plus pole to the start of a coil and look at the marked face with a compass: it is a south pole, "
      "and draws the end of the needle that points north. If it does not, the coil is wound the other way round: "
      "exchange the names of its leads."};
  for (const JointRow& joint : order.joints)
    if (joint.effect != "nearly nothing")
      checks.push_back(
          fmt::format("Before bonding, joint {}. Hold the two parts in front of each other as they will lie, with the "
                      "cell's plus pole at the coil's positive lead: the current {}.",
                      joint.number, joint.effect == "pushes apart" ? "pushes them apart" : "pulls them together"));
  const auto magnets = std::ranges::count(order.parts, ComponentKind::magnet, &PartRow::kind);
  checks.push_back(
      fmt::format("After cutting. No lead may have contact with another coil. With the positive leads of all coils at "
                  "plus, each joint does as the table of joints says: the slit opens where the current pushes apart{}. "
                  "With the cell reversed it does the opposite.",
                  magnets > 1 ? ", unless the magnets hold it against so small a current" : ""));
  checks.push_back(operation_text(subject));
  return checks;
}

}  // namespace

AssemblyOrder assembly_order(const DesignSubject& subject, const Cast& cast, const Recipe& recipe,
                             const WindingSheet& winding) {
  AssemblyOrder order;
  for (std::size_t i = 0; i < cast.plan.parts.size(); ++i) order.parts.push_back(row_of(cast.plan, i));
  order.joints = joints_of(subject, cast.plan);
  order.steps = steps_of(subject, order, cast, recipe, winding);
  order.checks = checks_of(subject, order, winding);
  return order;
}

std::string assembly_csv(const AssemblyOrder& order) {
  std::ostringstream out;
  text::CsvWriter csv(out, {"part", "kind", "centre_mm", "north_towards", "positive_current_seen_from_tip",
                            "positive_lead", "start_face"});
  for (const PartRow& row : order.parts)
    csv.row({row.number, row.kind == ComponentKind::magnet ? "magnet" : "coil",
             rounded(units::from_memory(row.centre, "centre_mm")), row.north_towards, row.current, row.positive_lead,
             row.start_face});
  return out.str();
}

}  // namespace coilwright::exports
