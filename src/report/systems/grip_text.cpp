#include "coilwright/report/systems/grip_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "coilwright/actuator/cost.hpp"
#include "coilwright/simulation/part_limits.hpp"
#include "coilwright/units/angle.hpp"

namespace coilwright::report {
namespace {

using systems::gripper::Grasp;
using systems::gripper::GraspContact;
using systems::gripper::GripAnswer;
using systems::gripper::LeastToHold;
using systems::gripper::PlacementTolerance;
using systems::gripper::Polarity;
using systems::gripper::Tolerance;
using systems::gripper::tried_angles;
using systems::gripper::tried_lengths;

// What objects and fingers are off by where people put them, m.
constexpr double usual_placement = 1e-3;

// Percent; nothing where the magnets have no grade or no steady temperature.
std::optional<double> loss_held(const GripAnswer& answer) {
  if (!answer.magnets_held) return std::nullopt;
  return 100.0 * answer.magnets_held->irreversible_loss;
}

std::string seconds(double time) {
  return time < 999.5 ? fmt::format("{:.3g}", time) : fmt::format("{:.0f}", time);
}

// A hold that the fingers do not survive is none.
std::string held_text(const GripAnswer& answer) {
  if (answer.is_demagnetised()) return "Not for long: the magnets are lost (see below). Until then held";
  if (answer.heat && answer.heat->time_to_limit)
    return fmt::format("Held for {} s from cold, not for good (see below)", seconds(*answer.heat->time_to_limit));
  if (answer.burns()) return "Held for moments, until it burns (see below)";
  return loss_held(answer) >= simulation::most_irreversible_loss ? "Held, but the magnets weaken (see below)" : "Held";
}

std::string outcome_text(const GripAnswer& answer) {
  const Grasp& grasp = answer.grasp;
  const std::string what = fmt::format("{:.6g} g at {:.4g} A{}", answer.object.mass * 1e3, answer.current,
                                       answer.is_of_file ? " (the actuator's operating point)" : "");
  if (!grasp.both_touched)
    return fmt::format("Not held: {}. A finger does not reach the object{}.\n", what,
                       grasp.missing > 0.0 && std::isfinite(grasp.missing)
                           ? fmt::format(": it stays {:.3g} mm away", grasp.missing * 1e3)
                           : "");
  if (!grasp.holds && grasp.capacity >= grasp.load)
    return fmt::format(
        "Not held: {}. It creeps out of the fingers: they can carry {:.4g} N, hardly more than its load of {:.4g} N.\n",
        what, grasp.capacity, grasp.load);
  if (!grasp.holds)
    return fmt::format("Not held: {}. It slips at a load of {:.4g} N; it would need {:.4g} N.\n", what, grasp.capacity,
                       grasp.load);
  return fmt::format("{}: {}. The load is {:.4g} N; it slips at {}{:.4g} N, {:.3g} times that.\n", held_text(answer),
                     what, grasp.load, grasp.capacity_is_bound ? "more than " : "", grasp.capacity, grasp.margin());
}

std::string contacts_text(const GripAnswer& answer) {
  if (answer.grasp.contacts.empty()) return {};
  std::string text = fmt::format("  {:<7}{:>6}{:>12}{:>9}{:>9}{:>10}{:>11}\n", "finger", "link", "along mm", "x mm",
                                 "y mm", "normal N", "friction N");
  for (const GraspContact& each : answer.told_contacts())
    text +=
        fmt::format("  {:<7}{:>6}{:>12.2f}{:>9.2f}{:>9.2f}{:>10.4f}{:>11.4f}\n", answer.finger_name(each), each.link,
                    each.along * 1e3, each.position.x() * 1e3, each.position.y() * 1e3, each.normal, each.friction);
  return text;
}

std::string least_text(const char* what, const LeastToHold& least, const char* unit) {
  if (!least.found) return fmt::format("The least {}: none up to {:.4g}{} holds it.\n", what, least.most, unit);
  // Rounded up, so that what is printed holds it.
  const double digits = std::pow(10.0, 3.0 - std::ceil(std::log10(std::max(*least.found, 1e-9))));
  return fmt::format("The least {} that holds it: {:.3g}{}.\n", what, std::ceil(*least.found * digits) / digits, unit);
}

std::string heat_text(const GripAnswer& answer) {
  const bool no_end = answer.burns();
  const std::string burning = fmt::format("at {:.4g} A nothing holds its temperature: it burns (from {:.4g} A on)",
                                          answer.current, answer.burns_from);
  if (!answer.heat) return no_end ? fmt::format("\nHeat of one finger bent like that: {}.\n", burning) : std::string();
  const simulation::Heat& heat = *answer.heat;
  std::string text = fmt::format("\nHeat of one finger bent like that against a wall: {:.4g} A can be held for good; ",
                                 heat.current_for_good());
  text += no_end ? burning : fmt::format("at {:.4g} A ", answer.current);
  if (heat.time_to_limit)
    return text + fmt::format("{}a part reaches its limit after {} s, from cold.\n", no_end ? "; " : "",
                              seconds(*heat.time_to_limit));
  return text + (no_end ? ".\n" : "no part reaches its limit.\n");
}

// "less than 0.1 mm lower to 5 mm or more higher"
std::string tolerance_text(const Tolerance& tolerance, std::span<const double> tried, double unit, const char* name,
                           const char* below, const char* above) {
  const auto side = [&](double value, const char* way) {
    if (value < tried.front()) return fmt::format("less than {:.4g} {} {}", tried.front() / unit, name, way);
    return fmt::format("{:.4g} {}{} {}", value / unit, name, value < tried.back() ? "" : " or more", way);
  };
  return side(tolerance.below, below) + " to " + side(tolerance.above, above);
}

std::string tolerances_text(const GripAnswer& answer) {
  if (!answer.grasp.holds) return {};
  const PlacementTolerance& tolerance = answer.tolerance;
  constexpr double degree = 1.0 / units::degrees_per_radian;
  return fmt::format(
      "\nHow far off one of these may be, the others as given, and it is still held\n"
      "  height of the object  {}\n  width of the object   {}\n  spacing of the palm   {}\n  mounting angle        "
      "{}\n{}",
      tolerance_text(tolerance.height, tried_lengths, 1e-3, "mm", "lower", "higher"),
      tolerance_text(tolerance.width, tried_lengths, 1e-3, "mm", "narrower", "wider"),
      tolerance_text(tolerance.spacing, tried_lengths, 1e-3, "mm", "narrower", "wider"),
      tolerance_text(tolerance.mounting_angle, tried_angles, degree, "deg", "further in", "further out"),
      tolerance.smallest_length() < usual_placement
          ? "MIND: less than a millimetre loses it, and hands and printed palms are off by that.\n"
          : "");
}

std::string supply_text(const GripAnswer& answer) {
  const std::optional<double> driven = answer.heat ? answer.heat->electrics.driven_current : std::nullopt;
  if (!driven || std::abs(answer.current) <= *driven) return {};
  return fmt::format(
      "MIND: the supply of the actuator's operating_point drives {:.4g} A through coils as warm as a hold without end "
      "makes them, and not {:.4g} A: with it this is not held.\n",
      *driven, std::abs(answer.current));
}

std::string magnets_text(const GripAnswer& answer) {
  if (answer.is_demagnetised())
    return fmt::format(
        "The coils' field at {:.4g} A demagnetises the magnets for good, even at 20 degC (margin {:.3g}, at least 0): "
        "these forces are there once at most.\n",
        answer.current, answer.magnets_cold->margin);
  const std::optional<double> loss = loss_held(answer);
  if (!loss && answer.magnets_cold && (answer.heat || answer.burns()))
    return fmt::format("What a hold costs the magnets is not known: there is no steady temperature at {:.4g} A.\n",
                       answer.current);
  if (!loss) return {};
  return fmt::format(
      "If it goes on without end, the worst magnet loses {} of its moment for good; the hottest is at {:.4g} degC.\n",
      *loss < 0.1 ? "less than 0.1 %" : fmt::format("{:.3g} %", *loss), *answer.heat->magnet_temperature);
}

}  // namespace

std::string to_text(const GripAnswer& answer) {
  const Grasp& grasp = answer.grasp;
  const int fingers = answer.mounting.fingers;
  std::string text = outcome_text(answer);
  if (grasp.both_touched)
    text += fmt::format("{} fingers touch it after {:.3g} ms{}.\n",
                        fingers == 2 ? "Both" : fmt::format("All {}", fingers), grasp.closing_time * 1e3,
                        grasp.contacts.empty() ? fmt::format(", and bend past it: in the end {} touches it",
                                                             fingers == 2 ? "neither" : "none")
                                               : "");
  text += fmt::format("\nFingers {}\n", grasp.holds          ? "while they hold it"
                                        : grasp.both_touched ? "on the object, before its support is taken away"
                                                             : "where they end");
  text += contacts_text(answer);
  const double left = grasp.left.sum() * units::degrees_per_radian;
  const char* act = answer.mounting.polarity == Polarity::same ? "repel" : "attract";
  if (fingers == 2)
    text +=
        fmt::format("  bending {:.4g} deg left, {:.4g} deg right; their magnets {} each other with up to {:.3g} N\n",
                    left, grasp.right.sum() * units::degrees_per_radian, act, grasp.magnet_force);
  else
    text += fmt::format("  bending {:.4g} deg each; magnets that face each other {}, two of them with up to {:.3g} N\n",
                        left, act, grasp.magnet_force);
  text += tolerances_text(answer);
  if (answer.least_current) text += '\n' + least_text("current", *answer.least_current, " A");
  if (answer.least_friction) text += '\n' + least_text("friction", *answer.least_friction, "");
  return text + heat_text(answer) + supply_text(answer) + magnets_text(answer) +
         fmt::format(
             "\n{} such fingers with driver and supply cost {:.0f} USD; the pneumatic gripper of the paper's Table III "
             "{:.0f} USD.\n",
             fingers == 2 ? "Two" : fmt::format("{}", fingers), answer.cost, actuator::PneumaticGripperCost{}.total()) +
         "\nIt rests on: friction and place of the object as given, rigid segments, coils and magnets at 20 degC, an "
         "object that\n" +
         (fingers == 2 ? "moves in the plane of the fingers only.\n"
                       : "stays on the gripper's axis, and fingers that all do the same.\n");
}

}  // namespace coilwright::report
