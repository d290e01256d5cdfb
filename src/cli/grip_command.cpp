#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "actuator_input.hpp"
#include "coilwright/actuator/cost.hpp"
#include "coilwright/actuator/demagnetisation.hpp"
#include "coilwright/actuator/heat.hpp"
#include "coilwright/simulation/performance.hpp"
#include "coilwright/systems/gripper/grasp.hpp"
#include "coilwright/systems/gripper/heat_of_hold.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/text/json/json.hpp"
#include "coilwright/thermal/steady_state.hpp"
#include "coilwright/units/angle.hpp"
#include "commands.hpp"
#include "number_rule.hpp"
#include "word_rule.hpp"

namespace coilwright::cli {
namespace {

using systems::gripper::Grasp;
using systems::gripper::GraspContact;
using systems::gripper::GraspTask;
using systems::gripper::Gripper;
using systems::gripper::Object;
using systems::gripper::ObjectShape;
using systems::gripper::Polarity;
using text::Json;

// As on the command line, each in the unit of its name.
struct Options {
  ActuatorOptions actuator;
  double mounting_angle = 30.0;
  double spacing = 70.0;
  int fingers = 2;
  std::string polarity = "same";
  std::string shape = "sphere";
  double width{};
  double height{};
  double mass{};
  double friction{};
  double across = 0.0;
  double below = 16.0;
  std::optional<double> current{};  // nothing: the file's own, or the paper's
  double open_current = 0.0;
  double acceleration = 0.0;
  double most_current{};
  double most_friction{};
  bool json{false};
};

// In both fingers, unless the command or the file says otherwise: that of the paper's demonstrations, A.
constexpr double paper_current = 1.4;

// Of coils and magnets while they grip, degC.
constexpr double cold = 20.0;

// What the command answers.
struct Answer {
  double current{};   // A, in every coil
  bool is_of_file{};  // whether it is that of the file's operating point
  Grasp grasp;
  double cost{};                           // US$, of the gripper with driver and supply
  double burns_from{};                     // A: from this current on a finger bent like that has no steady temperature
  std::optional<simulation::Heat> heat{};  // of one finger at the pose of the hold
  std::optional<double> demagnetisation_margin{};  // of the worst magnet of a straight finger at 20 degC
  std::optional<std::optional<double>> least_current{}, least_friction{};  // where asked for; nothing if there is none
};

ObjectShape shape_of(const Options& options) {
  if (options.shape == "box") return ObjectShape::box;
  if (options.shape == "upright_cylinder") return ObjectShape::upright_cylinder;
  return options.shape == "cylinder" ? ObjectShape::cylinder : ObjectShape::sphere;
}

Object object_of(const Options& options) {
  return {.shape = shape_of(options),
          .width = options.width * 1e-3,
          .height = options.height * 1e-3,
          .mass = options.mass * 1e-3,
          .friction = options.friction,
          .centre = {options.across * 1e-3, -options.below * 1e-3}};
}

// Runs `call`; a rule that it finds broken is reported at `place`.
template <class Call>
auto at_place(const std::string& place, const Call& call) {
  try {
    return call();
  } catch (const systems::gripper::NoRoom& none) {
    throw text::InputError(
        {.file = place,
         .rule = fmt::format("{}; --spacing-mm, --mounting-angle-deg and --open-current-A make room", none.what())});
  } catch (const std::invalid_argument& rule) {
    // How the fingers hang is said on the command line, all else of them in their file.
    const std::string text = rule.what();
    const bool of_mounting = text.starts_with("mounting.");
    throw text::InputError(
        {.file = of_mounting ? "--mounting-angle-deg, --spacing-mm, --fingers, --polarity" : place, .rule = text});
  }
}

Answer answer_of(const Options& options) {
  formats::ActuatorFile file = read_actuator(options.actuator);
  const actuator::Design design = design_in(file, options.actuator, "a gripper needs a design (actuator/1)");
  const Gripper gripper = at_place(options.actuator.file, [&] {
    return Gripper(design, {.angle = options.mounting_angle / units::degrees_per_radian,
                            .spacing = options.spacing * 1e-3,
                            .polarity = options.polarity == "same" ? Polarity::same : Polarity::opposite,
                            .fingers = options.fingers});
  });
  const Object object = object_of(options);
  const bool is_of_file = !options.current && file.operating_point;
  const double current = is_of_file ? file.operating_point->current : options.current.value_or(paper_current);
  const GraspTask task{.current = current, .open_current = options.open_current, .acceleration = options.acceleration};
  Answer out{.current = current,
             .is_of_file = is_of_file,
             .grasp = at_place("--shape, --width-mm, --centre-x-mm, --centre-below-palm-mm",
                               [&] { return systems::gripper::grasp(gripper, object, task); })};
  out.heat = systems::gripper::heat_of_hold(design, gripper, out.grasp, {.current = current});
  out.cost = actuator::gripper_cost(actuator::cost_of(design, gripper.assembly()).total(), options.fingers);
  out.burns_from = thermal::current_limits(actuator::heat_network(design, gripper.assembly(), out.grasp.left)).runaway;
  if (design.magnet.grade != nullptr)
    out.demagnetisation_margin = actuator::InnerFields(design, gripper.assembly())
                                     .demagnetisation(std::vector<double>(design.layout.size(), cold), current)
                                     .margin;
  if (options.most_current > 0.0)
    out.least_current = systems::gripper::least_current(gripper, object, task, options.most_current);
  if (options.most_friction > 0.0)
    out.least_friction = systems::gripper::least_friction(gripper, object, task, options.most_friction);
  return out;
}

bool burns(const Answer& answer) {
  return std::abs(answer.current) >= answer.burns_from;
}

bool is_demagnetised(const Answer& answer) {
  return answer.demagnetisation_margin && *answer.demagnetisation_margin < 0.0;
}

// A hold that the fingers do not survive is none.
std::string held_text(const Answer& answer) {
  if (is_demagnetised(answer)) return "Not for long: the magnets are lost (see below). Until then held";
  if (answer.heat && answer.heat->time_to_limit)
    return fmt::format("Held for {:.3g} s from cold, not for good (see below)", *answer.heat->time_to_limit);
  return burns(answer) ? "Held for moments, until it burns (see below)" : "Held";
}

std::string verdict_of(const Options& options, const Answer& answer) {
  const Grasp& grasp = answer.grasp;
  const std::string what = fmt::format("{:.6g} g at {:.4g} A{}", options.mass, answer.current,
                                       answer.is_of_file ? " (the actuator's operating point)" : "");
  if (!grasp.both_touched)
    return fmt::format("Not held: {}. A finger does not reach the object{}.\n", what,
                       grasp.missing > 0.0 && std::isfinite(grasp.missing)
                           ? fmt::format(": it stays {:.3g} mm away", grasp.missing * 1e3)
                           : "");
  if (!grasp.holds && grasp.capacity >= grasp.load)
    return fmt::format(
        "Not held: {}. It creeps out of the fingers: they can carry {:.4g} N, hardly more than its load of "
        "{:.4g} N.\n",
        what, grasp.capacity, grasp.load);
  if (!grasp.holds)
    return fmt::format("Not held: {}. It slips at a load of {:.4g} N; it would need {:.4g} N.\n", what, grasp.capacity,
                       grasp.load);
  return fmt::format("{}: {}. The load is {:.4g} N; it slips at {}{:.4g} N, {:.3g} times that.\n", held_text(answer),
                     what, grasp.load, grasp.capacity_is_bound ? "more than " : "", grasp.capacity, grasp.margin());
}

// Of more than two fingers one stands for all.
bool is_shown(const Options& options, const GraspContact& contact) {
  return options.fingers == 2 || contact.finger == 0;
}

const char* finger_name(const Options& options, const GraspContact& contact) {
  if (options.fingers > 2) return "each";
  return contact.finger == 0 ? "left" : "right";
}

std::string contacts_text(const Options& options, const Grasp& grasp) {
  if (grasp.contacts.empty()) return {};
  std::string text = fmt::format("  {:<7}{:>6}{:>12}{:>9}{:>9}{:>10}{:>11}\n", "finger", "link", "along mm", "x mm",
                                 "y mm", "normal N", "friction N");
  for (const GraspContact& each : grasp.contacts)
    if (is_shown(options, each))
      text += fmt::format("  {:<7}{:>6}{:>12.2f}{:>9.2f}{:>9.2f}{:>10.4f}{:>11.4f}\n", finger_name(options, each),
                          each.link, each.along * 1e3, each.position.x() * 1e3, each.position.y() * 1e3, each.normal,
                          each.friction);
  return text;
}

std::string least_text(const char* what, const std::optional<double>& least, double most, const char* unit) {
  if (!least) return fmt::format("The least {}: none up to {:.4g}{} holds it.\n", what, most, unit);
  // Rounded up, so that what is printed holds it.
  const double digits = std::pow(10.0, 3.0 - std::ceil(std::log10(std::max(*least, 1e-9))));
  return fmt::format("The least {} that holds it: {:.3g}{}.\n", what, std::ceil(*least * digits) / digits, unit);
}

std::string heat_text(const Answer& answer) {
  const bool no_end = burns(answer);
  const std::string burning = fmt::format("at {:.4g} A nothing holds its temperature: it burns (from {:.4g} A on)",
                                          answer.current, answer.burns_from);
  if (!answer.heat) return no_end ? fmt::format("\nHeat of one finger bent like that: {}.\n", burning) : std::string();
  const simulation::Heat& heat = *answer.heat;
  std::string text = fmt::format("\nHeat of one finger bent like that against a wall: {:.4g} A can be held for good; ",
                                 heat.current_for_good());
  text += no_end ? burning : fmt::format("at {:.4g} A ", answer.current);
  if (heat.time_to_limit)
    return text + fmt::format("{}a part reaches its limit after {:.3g} s, from cold.\n", no_end ? "; " : "",
                              *heat.time_to_limit);
  return text + (no_end ? ".\n" : "no part reaches its limit.\n");
}

std::string magnets_text(const Answer& answer) {
  if (!is_demagnetised(answer)) return {};
  return fmt::format(
      "The coils' field at {:.4g} A demagnetises the magnets for good, even at 20 degC (margin {:.3g}, at least 0): "
      "these forces are there once at most.\n",
      answer.current, *answer.demagnetisation_margin);
}

std::string as_text(const Options& options, const Answer& answer) {
  const Grasp& grasp = answer.grasp;
  std::string text = verdict_of(options, answer);
  if (grasp.both_touched)
    text += fmt::format(
        "{} fingers touch it after {:.3g} ms{}.\n",
        options.fingers == 2 ? "Both" : fmt::format("All {}", options.fingers), grasp.closing_time * 1e3,
        grasp.contacts.empty()
            ? fmt::format(", and bend past it: in the end {} touches it", options.fingers == 2 ? "neither" : "none")
            : "");
  text += fmt::format("\nFingers {}\n", grasp.holds          ? "while they hold it"
                                        : grasp.both_touched ? "on the object, before its support is taken away"
                                                             : "where they end");
  text += contacts_text(options, grasp);
  const double left = grasp.left.sum() * units::degrees_per_radian;
  const char* act = options.polarity == "same" ? "repel" : "attract";
  if (options.fingers == 2)
    text +=
        fmt::format("  bending {:.4g} deg left, {:.4g} deg right; their magnets {} each other with up to {:.3g} N\n",
                    left, grasp.right.sum() * units::degrees_per_radian, act, grasp.magnet_force);
  else
    text += fmt::format("  bending {:.4g} deg each; magnets that face each other {}, two of them with up to {:.3g} N\n",
                        left, act, grasp.magnet_force);
  if (answer.least_current) text += '\n' + least_text("current", *answer.least_current, options.most_current, " A");
  if (answer.least_friction) text += '\n' + least_text("friction", *answer.least_friction, options.most_friction, "");
  return text + heat_text(answer) + magnets_text(answer) +
         fmt::format(
             "\n{} such fingers with driver and supply cost {:.0f} USD; the pneumatic gripper of the paper's Table "
             "III "
             "{:.0f} USD.\n",
             options.fingers == 2 ? "Two" : fmt::format("{}", options.fingers), answer.cost,
             actuator::PneumaticGripperCost{}.total()) +
         "\nIt rests on: friction and place of the object as given, rigid segments, coils and magnets at 20 degC, an "
         "object that\n" +
         (options.fingers == 2 ? "moves in the plane of the fingers only.\n"
                               : "stays on the gripper's axis, and fingers that all do the same.\n");
}

Json optional_number(const std::optional<double>& value) {
  return value ? Json(*value) : Json();
}

std::string as_json(const Options& options, const Answer& answer) {
  const Grasp& grasp = answer.grasp;
  Json contacts = Json::array();
  for (const GraspContact& each : grasp.contacts)
    if (is_shown(options, each))
      contacts.add(Json::object({{"finger", finger_name(options, each)},
                                 {"link", each.link},
                                 {"along_mm", each.along * 1e3},
                                 {"x_mm", each.position.x() * 1e3},
                                 {"y_mm", each.position.y() * 1e3},
                                 {"normal_N", each.normal},
                                 {"friction_N", each.friction}}));
  Json out = Json::object({{"fingers", options.fingers},
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
  out.set("closing_time_ms", grasp.both_touched ? Json(grasp.closing_time * 1e3) : Json());
  if (answer.least_current) out.set("least_current_A", optional_number(*answer.least_current));
  if (answer.least_friction) out.set("least_friction", optional_number(*answer.least_friction));
  out.set("runaway_current_A", answer.burns_from);
  if (answer.demagnetisation_margin) out.set("demagnetisation_margin", *answer.demagnetisation_margin);
  out.set("cost_USD", answer.cost).set("pneumatic_cost_USD", actuator::PneumaticGripperCost{}.total());
  if (answer.heat) {
    out.set("continuous_current_A", answer.heat->current_for_good());
    out.set("time_to_limit_s", optional_number(answer.heat->time_to_limit));
  }
  return out.text();
}

void add_object_options(CLI::App& command, Options& options) {
  const auto up_to = [&](double most, const char* name, double& value, const char* text) {
    return command.add_option(name, value, text)
        ->check(number_rule(text::Rule::above(0.0).and_also(text::Rule::at_most(most))));
  };
  command
      .add_option(
          "--shape", options.shape,
          "sphere, cylinder (its axis across the fingers' plane), box, or upright_cylinder (a cup; default sphere)")
      ->check(word_rule({"sphere", "cylinder", "box", "upright_cylinder"}));
  up_to(1e3, "--width-mm", options.width, "Diameter, or width of a box between the fingers, mm")->required();
  up_to(1e3, "--height-mm", options.height, "Height of a box or an upright cylinder, mm");
  // Contacts are solved to a share of the fingers' impulses: what weighs less than a milligram is lost in that.
  command.add_option("--mass-g", options.mass, "Mass of the object, g, at least 0.001")
      ->check(number_rule(text::Rule::between(1e-3, 1e5)))
      ->required();
  up_to(10.0, "--friction", options.friction, "Coefficient of friction between it and the fingers")->required();
  command.add_option("--centre-x-mm", options.across, "Its centre from the middle between the fingers, mm (default 0)")
      ->check(number_rule(text::Rule::between(-1e3, 1e3)));
  command
      .add_option("--centre-below-palm-mm", options.below,
                  "Its centre below the line through the base joints, mm (default 16)")
      ->check(number_rule(text::Rule::between(-1e3, 1e3)));
}

void add_gripper_options(CLI::App& command, Options& options) {
  command
      .add_option("--mounting-angle-deg", options.mounting_angle,
                  "Of each straight finger with the gripper's axis, outwards, deg (default 30)")
      ->check(number_rule(text::Rule::between(-89.0, 89.0)));
  command
      .add_option(
          "--fingers", options.fingers,
          "How many, evenly round the gripper's axis (default 2); more than two hold a sphere or an upright cylinder")
      ->check(number_rule(text::Rule::between(2.0, systems::gripper::most_fingers)));
  command
      .add_option("--spacing-mm", options.spacing,
                  "Between the two base joints, or diameter of the circle of more, mm (default 70)")
      ->check(number_rule(text::Rule::above(0.0).and_also(text::Rule::at_most(1e3))));
  command
      .add_option("--polarity", options.polarity,
                  "same (identical fingers, whose magnets repel) or opposite (every second one turned; default same)")
      ->check(word_rule({"same", "opposite"}));
  command
      .add_option(
          "--current-A", options.current,
          "In every coil of all fingers, A (default that of the actuator's operating point, or the paper's 1.4)")
      ->check(number_rule(text::Rule::between(-100.0, 100.0)));
  command
      .add_option("--open-current-A", options.open_current,
                  "Before that, while the object is put between them, A; below zero it opens them (default 0)")
      ->check(number_rule(text::Rule::between(-100.0, 100.0)));
  command
      .add_option("--acceleration-m_s2", options.acceleration, "Upwards, that the hold must survive, m/s^2 (default 0)")
      ->check(number_rule(text::Rule::between(0.0, 1e3)));
  const text::Rule above_zero = text::Rule::above(0.0).and_also(text::Rule::at_most(100.0));
  command.add_option("--least-current-up-to-A", options.most_current, "Also find the least current, up to this one, A")
      ->check(number_rule(above_zero));
  command
      .add_option("--least-friction-up-to", options.most_friction,
                  "Also find the least coefficient of friction, up to this one")
      ->check(number_rule(above_zero));
}

}  // namespace

void add_grip_command(CLI::App& app, Outcome&) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("grip", "Close fingers on an object, lift it, and load it until it slips");
  add_actuator_options(*command, options->actuator);
  add_object_options(*command, *options);
  add_gripper_options(*command, *options);
  command->add_flag("--json", options->json, "Print JSON instead of text")->disable_flag_override();
  command->footer(
      "Two like fingers hang from a palm, mirrored, and close in one plane; more stand evenly round the\n"
      "gripper's axis and all do the same. The object stands on a smooth support until they hold it; the support\n"
      "is then taken away, the load put on within 0.3 s and held for 0.2 s. It slips where it sinks at 20 mm/s under "
      "a\n"
      "load that grows on; a ball that turns between the fingers on its way there is carried by up to 2 % more than\n"
      "what they hold at rest. Fingers hang at the mounting angle: the base tilt of their file is not used.\n\n"
      "Example:\n"
      "  coilwright grip configs/actuators/paper_finger.json --width-mm 60 --mass-g 40 --friction 0.8");
  command->callback([options] {
    const bool has_height = object_of(*options).has_flat_sides();
    if (has_height && options->height == 0.0)
      throw CLI::ValidationError("--height-mm", "is needed for a box and an upright cylinder");
    if (!has_height && options->height != 0.0)
      throw CLI::ValidationError("--height-mm", "belongs to a box and an upright cylinder: --width-mm is all that a " +
                                                    options->shape + " has");
    const Answer answer = answer_of(*options);
    std::cout << (options->json ? as_json(*options, answer) : as_text(*options, answer));
  });
}

}  // namespace coilwright::cli
