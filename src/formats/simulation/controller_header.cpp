#include "coilwright/formats/simulation/controller_header.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace coilwright::formats {
namespace {

using actuator::HingePair;
using actuator::Model;

constexpr int table_angles = 129;

// Equation of motion over the absolute angles of the links: their centres of mass move by turning about the joints
// before them; a joint's torque turns the link after it and the one before it the other way.
constexpr std::string_view functions = R"(
/* Current to set `time` seconds after the start, A. */
static inline CW_REAL cw_profile_current(CW_REAL time) {
  CW_REAL current = CW_CURRENT_BEFORE_A;
  int i;
  for (i = 0; i < CW_LEVELS && time >= cw_level_time_s[i]; ++i) current = cw_level_current_A[i];
  return current;
}

/* Opening torque of a joint per ampere of the current, N m/A; beyond the table along its last slope. */
static inline CW_REAL cw_torque_per_ampere(int joint, CW_REAL angle) {
  const CW_REAL place = (angle - cw_table_first_rad[joint]) / cw_table_step_rad[joint];
  int i = place > 0 ? (int)place : 0;
  if (i > CW_TABLE - 2) i = CW_TABLE - 2;
  return cw_table_Nm_A[joint][i] + (place - (CW_REAL)i) * (cw_table_Nm_A[joint][i + 1] - cw_table_Nm_A[joint][i]);
}

/* Spring, damper, faces that touch, and magnetics, N m. */
static inline CW_REAL cw_joint_torque(int joint, CW_REAL angle, CW_REAL rate, CW_REAL current) {
  CW_REAL torque = cw_offset_Nm[joint] - cw_stiffness_Nm_rad[joint] * angle - cw_damping_Nms_rad[joint] * rate +
                   current * cw_torque_per_ampere(joint, angle);
  const CW_REAL closed = cw_closing_rad[joint] - angle;
  if (closed > 0) {
    const CW_REAL push = cw_contact_Nm_rad[joint] * closed - cw_contact_Nms_rad[joint] * rate;
    if (push > 0) torque += push;
  }
  return torque;
}

/* Joint accelerations, rad/s^2, at joint angles (rad) and rates (rad/s) under a current (A). */
static inline void cw_accelerations(const CW_REAL angle[CW_JOINTS], const CW_REAL rate[CW_JOINTS], CW_REAL current,
                             CW_REAL acceleration[CW_JOINTS]) {
  CW_REAL mass[CW_JOINTS][CW_JOINTS], force[CW_JOINTS];
  CW_REAL turn_x[CW_JOINTS], turn_y[CW_JOINTS]; /* of the next joint with the link, m/rad */
  CW_REAL bias_x = 0, bias_y = CW_GRAVITY;       /* of a joint, without accelerations of the angles, m/s^2 */
  CW_REAL absolute = CW_BASE_TILT_RAD, speed = 0;
  int i, j, k;
  for (i = 0; i < CW_JOINTS; ++i) {
    CW_REAL s, c, own_x, own_y, centre_x, centre_y;
    absolute += angle[i];
    speed += rate[i];
    s = sin(absolute);
    c = cos(absolute);
    own_x = cw_com_along_m[i] * c + cw_com_offset_m[i] * s;
    own_y = cw_com_along_m[i] * s - cw_com_offset_m[i] * c;
    centre_x = bias_x - speed * speed * (cw_com_along_m[i] * s - cw_com_offset_m[i] * c);
    centre_y = bias_y + speed * speed * (cw_com_along_m[i] * c + cw_com_offset_m[i] * s);
    force[i] = -cw_mass_kg[i] * (own_x * centre_x + own_y * centre_y);
    mass[i][i] = cw_inertia_kgm2[i] + cw_mass_kg[i] * (own_x * own_x + own_y * own_y);
    for (j = 0; j < i; ++j) {
      mass[i][j] = cw_mass_kg[i] * (own_x * turn_x[j] + own_y * turn_y[j]);
      force[j] -= cw_mass_kg[i] * (turn_x[j] * centre_x + turn_y[j] * centre_y);
      for (k = 0; k <= j; ++k) mass[j][k] += cw_mass_kg[i] * (turn_x[j] * turn_x[k] + turn_y[j] * turn_y[k]);
    }
    turn_x[i] = cw_length_m[i] * c;
    turn_y[i] = cw_length_m[i] * s;
    bias_x -= speed * speed * cw_length_m[i] * s;
    bias_y += speed * speed * cw_length_m[i] * c;
  }
  for (i = 0; i < CW_JOINTS; ++i) {
    const CW_REAL torque = cw_joint_torque(i, angle[i], rate[i], current);
    force[i] += torque;
    if (i > 0) force[i - 1] -= torque;
  }
  for (i = 0; i < CW_JOINTS; ++i) { /* Cholesky */
    for (j = 0; j <= i; ++j) {
      CW_REAL sum = mass[i][j];
      for (k = 0; k < j; ++k) sum -= mass[i][k] * mass[j][k];
      mass[i][j] = i == j ? sqrt(sum) : sum / mass[j][j];
    }
    for (k = 0; k < i; ++k) force[i] -= mass[i][k] * force[k];
    force[i] /= mass[i][i];
  }
  for (i = CW_JOINTS - 1; i >= 0; --i) {
    for (k = i + 1; k < CW_JOINTS; ++k) force[i] -= mass[k][i] * force[k];
    force[i] /= mass[i][i];
  }
  for (i = 0; i < CW_JOINTS; ++i) acceleration[i] = i > 0 ? force[i] - force[i - 1] : force[i];
}

/* Angles and rates `step` seconds later under a current that holds so long. Steps of CW_LARGEST_STEP_S
   and below. */
static inline void cw_step(CW_REAL angle[CW_JOINTS], CW_REAL rate[CW_JOINTS], CW_REAL current, CW_REAL step) {
  static const CW_REAL ahead[4] = {0, 0.5, 0.5, 1}, weight[4] = {1, 2, 2, 1};
  CW_REAL a[CW_JOINTS], w[CW_JOINTS], dw[CW_JOINTS], sum_a[CW_JOINTS], sum_w[CW_JOINTS], last_w[CW_JOINTS],
      last_dw[CW_JOINTS];
  int i, stage;
  for (i = 0; i < CW_JOINTS; ++i) sum_a[i] = sum_w[i] = last_w[i] = last_dw[i] = 0;
  for (stage = 0; stage < 4; ++stage) {
    for (i = 0; i < CW_JOINTS; ++i) {
      a[i] = angle[i] + ahead[stage] * step * last_w[i];
      w[i] = rate[i] + ahead[stage] * step * last_dw[i];
    }
    cw_accelerations(a, w, current, dw);
    for (i = 0; i < CW_JOINTS; ++i) {
      sum_a[i] += weight[stage] * w[i];
      sum_w[i] += weight[stage] * dw[i];
      last_w[i] = w[i];
      last_dw[i] = dw[i];
    }
  }
  for (i = 0; i < CW_JOINTS; ++i) {
    angle[i] += step / 6 * sum_a[i];
    rate[i] += step / 6 * sum_w[i];
  }
}
)";

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
        "across "
        "more than one joint");
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
      "   and the lumped model. C99; define CW_REAL as double for more digits. Joint angles are relative, "
      "zero\n"
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
  out += '\n' + parts(model) + '\n' + tables(model);
  out += functions;
  out += "\n#endif\n";
  return out;
}

}  // namespace coilwright::formats
