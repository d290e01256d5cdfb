#include "coilwright/exports/controller_header.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "exports/packed_files.hpp"

namespace coilwright::exports {
namespace {

using actuator::HingePair;
using actuator::Model;

constexpr int table_angles = 129;

std::string array(std::string_view name, std::string_view size, const std::vector<double>& values) {
  return fmt::format("static const CW_REAL {}[{}] = {{{:.9g}}};\n", name, size, fmt::join(values, ", "));
}

template <class Part, class Number>
std::vector<double> of_each(const Part& parts, Number number) {
  std::vector<double> out;
  for (const auto& part : parts) out.push_back(number(part));
  return out;
}

// Torques per ampere of one joint, N m/A, over its table's angles.
struct Table {
  double first{};  // rad
  double step{};   // rad
  std::vector<double> torques;
  double error{};  // largest between two angles
};

Table table_of(const Model& model, int joint) {
  double lower = -0.5;
  double upper = 2.0;
  std::vector<HingePair> pairs;
  for (const HingePair& pair : model.magnetics().hinge_pairs()) {
    if (pair.joint != joint) continue;
    lower = pairs.empty() ? pair.torque_per_ampere->lower() : std::max(lower, pair.torque_per_ampere->lower());
    upper = pairs.empty() ? pair.torque_per_ampere->upper() : std::min(upper, pair.torque_per_ampere->upper());
    pairs.push_back(pair);
  }
  const actuator::CoilCurrents shares = model.current_shares();
  const auto torque = [&](double angle) {
    double sum = 0.0;
    for (const HingePair& pair : pairs) sum += shares[pair.coil] * pair.sense * pair.torque_per_ampere->value(angle);
    return sum;
  };
  Table table{.first = lower, .step = (upper - lower) / (table_angles - 1), .torques = {}};
  for (int i = 0; i < table_angles; ++i) table.torques.push_back(torque(lower + i * table.step));
  for (int i = 0; i + 1 < table_angles; ++i)
    table.error = std::max(table.error, std::abs(torque(lower + (i + 0.5) * table.step) -
                                                 0.5 * (table.torques[i] + table.torques[i + 1])));
  return table;
}

// A tenth of the fastest motion's period, be it a free one or one against a stop.
double largest_step(const Model& model) {
  const mechanics::JointVector mobility = model.chain().joint_mobility();
  double fastest = 0.0;  // rad^2/s^2
  for (int j = 0; j < model.joints(); ++j) {
    const actuator::Hinge& hinge = model.hinges()[j];
    fastest = std::max(fastest, (hinge.stiffness + hinge.contact.stiffness) * mobility[j]);
  }
  return fastest > 0.0 ? std::min(1e-3, 0.63 / std::sqrt(fastest)) : 1e-3;
}

std::string parts(const Model& model) {
  const auto links = model.chain().links();
  const auto& hinges = model.hinges();
  using actuator::Hinge;
  using mechanics::Link;
  constexpr std::string_view n = "CW_JOINTS";
  std::string out;
  out += array("cw_length_m", n, of_each(links, [](const Link& l) { return l.length; }));
  out += array("cw_com_along_m", n, of_each(links, [](const Link& l) { return l.com_along; }));
  out += array("cw_com_offset_m", n, of_each(links, [](const Link& l) { return l.com_offset; }));
  out += array("cw_mass_kg", n, of_each(links, [](const Link& l) { return l.mass; }));
  out += array("cw_inertia_kgm2", n, of_each(links, [](const Link& l) { return l.inertia; }));
  out += array("cw_stiffness_Nm_rad", n, of_each(hinges, [](const Hinge& h) { return h.stiffness; }));
  out += array("cw_damping_Nms_rad", n, of_each(hinges, [](const Hinge& h) { return h.damping; }));
  out += array("cw_offset_Nm", n, of_each(hinges, [](const Hinge& h) { return h.torque_offset; }));
  out += array("cw_closing_rad", n, of_each(hinges, [](const Hinge& h) { return h.contact.closing_angle; }));
  out += array("cw_contact_Nm_rad", n, of_each(hinges, [](const Hinge& h) { return h.contact.stiffness; }));
  out += array("cw_contact_Nms_rad", n, of_each(hinges, [](const Hinge& h) { return h.contact.damping; }));
  return out;
}

std::string tables(const Model& model) {
  std::vector<double> first, step;
  std::string rows;
  double error = 0.0;
  for (int j = 0; j < model.joints(); ++j) {
    const Table table = table_of(model, j);
    first.push_back(table.first);
    step.push_back(table.step);
    error = std::max(error, table.error);
    rows += fmt::format("  {{{:.7g}}}{}\n", fmt::join(table.torques, ", "), j + 1 < model.joints() ? "," : "");
  }
  return array("cw_table_first_rad", "CW_JOINTS", first) + array("cw_table_step_rad", "CW_JOINTS", step) +
         fmt::format("/* Linear between the angles: within {:.1g} N m/A of the curves. */\n", error) +
         "static const CW_REAL cw_table_Nm_A[CW_JOINTS][CW_TABLE] = {\n" + rows + "};\n";
}

}  // namespace

void require_header_can_say(const Model& model) {
  for (const mechanics::Link& link : model.chain().links())
    if (link.rotor_inertia > 0.0)
      throw std::invalid_argument("a C header has no rotors; take \"rotor_inertia_kgm2\" out of the actuator");
  if (!model.nominal_spec().effects.empty())
    throw std::invalid_argument("a C header has no effects; take them out of the actuator, or do without the header");
  if (model.nominal_spec().torque_correction)
    throw std::invalid_argument("a C header has no torque correction; take it out of the actuator");
  if (!model.magnetics().distant_pairs().empty())
    throw std::invalid_argument(
        "a C header has the pairs of neighbours alone; this actuator has coils and magnets that act on each other "
        "across more than one joint");
}

// Which current the header speaks of.
std::string coils_of(const Model& model) {
  const actuator::CoilCurrents shares = model.current_shares();
  if ((shares.array() == 1.0).all()) return "in every coil";
  const std::vector<double> each(shares.begin(), shares.end());
  return fmt::format("of which the coils, base to tip, carry {}", fmt::join(each, " and "));
}

std::string controller_header(const Model& model, const control::ProfileQuality& profile) {
  require_header_can_say(model);
  std::string out = fmt::format(
      "/* A soft electromagnetic actuator for a microcontroller, made by coilwright: the profile \"{}\" of the current "
      "{},\n"
      "   and the lumped model. C99; define CW_REAL as double for more digits. Joint angles are relative, zero\n"
      "   where the chain is straight, positive where a joint opens. Not in it: heat, and what moves the current. */\n"
      "#ifndef CW_ACTUATOR_H\n#define CW_ACTUATOR_H\n\n#include <tgmath.h>\n\n"
      "#ifndef CW_REAL\n#define CW_REAL float\n#endif\n\n",
      profile.name, coils_of(model));
  out += fmt::format("enum {{ CW_JOINTS = {}, CW_LEVELS = {}, CW_TABLE = {} }};\n\n", model.joints(),
                     profile.profile.levels.size(), table_angles);
  out += fmt::format(
      "#define CW_CURRENT_BEFORE_A ((CW_REAL){:.9g})\n#define CW_GRAVITY ((CW_REAL){:.9g}) /* m/s^2 */\n"
      "#define CW_BASE_TILT_RAD ((CW_REAL){:.9g})\n#define CW_LARGEST_STEP_S ((CW_REAL){:.3g})\n\n",
      profile.profile.before, model.chain().gravity(), model.chain().base_tilt(), largest_step(model));
  out += array("cw_level_time_s", "CW_LEVELS", profile.profile.times);
  out += array("cw_level_current_A", "CW_LEVELS", profile.profile.levels);
  out += '\n' + parts(model) + '\n' + tables(model) + '\n';
  out += text::packed_text(assets(), "controller.h");
  out += "\n#endif\n";
  return out;
}

}  // namespace coilwright::exports
