#include "coilwright/exports/kinds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <pugixml.hpp>
#include <utility>

#include "exports/chain/bodies.hpp"
#include "exports/chain/plain_model.hpp"

namespace coilwright::exports {
namespace {

using mechanics::FaceContact;
using pugi::xml_node;

// Of MuJoCo's stops: the share of a push that a stop takes at once. The rest is its softness, which is what gives it a
// stiffness: docs/exports/simulators.md.
constexpr double impedance = 0.9;
constexpr double longest_step = 1e-4;     // s
constexpr double steps_per_radian = 5.0;  // of the fastest oscillation in a stop, at the least

// A stop that is as stiff at rest as the faces, and rebounds with their damping ratio. MuJoCo's constraint of a joint
// with the inverse inertia A pushes with k r / ((1 - d) A) at rest where solref is (-k, -b) and the impedance d is
// constant, and moves with the frequency sqrt(k).
struct Stop {
  double k{};
  double b{};
};

Stop stop_of(const FaceContact& faces, double mobility) {
  const double softness = (1.0 - impedance) * mobility;
  return {.k = faces.stiffness * softness, .b = faces.damping * mobility * std::sqrt(1.0 - impedance)};
}

double step_for(const actuator::Model& model) {
  const mechanics::JointVector mobility = model.chain().joint_mobility();
  double step = longest_step;
  for (int j = 0; j < model.joints(); ++j) {
    const FaceContact& faces = model.hinges()[j].contact;
    if (faces.stiffness > 0.0)
      step = std::min(step, 1.0 / (steps_per_radian * std::sqrt(stop_of(faces, mobility[j]).k)));
  }
  // One digit, rounded down: a number that a person would choose.
  const double unit = std::pow(10.0, std::floor(std::log10(step)));
  return std::stod(fmt::format("{:.0e}", unit * std::floor(step / unit * (1.0 + 1e-9))));
}

void add_joint(xml_node body, int joint, const actuator::Model& model, const std::vector<TorqueTable>& tables) {
  const actuator::Hinge& hinge = model.hinges()[joint];
  const xml_node node = add(body, "joint",
                            {{"name", joint_name(joint)},
                             {"type", "hinge"},
                             {"axis", "0 -1 0"},
                             {"stiffness", hinge.stiffness},
                             {"damping", hinge.damping}});
  if (const double rotor = model.chain().link(joint).rotor_inertia; rotor > 0.0) set(node, {{"armature", rotor}});
  if (hinge.torque_offset != 0.0 && hinge.stiffness > 0.0) set(node, {{"springref", rest_angle(hinge)}});
  if (hinge.contact.stiffness <= 0.0) return set(node, {{"limited", "false"}});
  const Stop stop = stop_of(hinge.contact, model.chain().joint_mobility()[joint]);
  // A zero would turn the meaning of both numbers of solreflimit.
  set(node, {{"limited", "true"},
             {"range", words({hinge.contact.closing_angle, last_angle(joint, tables)})},
             {"solreflimit", words({-stop.k, -std::max(stop.b, 1e-9 * std::sqrt(stop.k))})},
             {"solimplimit", words({impedance, impedance, 0.001, 0.5, 2.0})}});
}

void add_body(xml_node parent, int link, const actuator::Model& model, const std::vector<RigidLink>& links,
              const std::vector<TorqueTable>& tables) {
  const RigidLink& body = links[static_cast<std::size_t>(link)];
  const xml_node node =
      add(parent, "body", {{"name", fmt::format("link{}", link + 1)}, {"pos", coordinates(body.joint)}});
  add(node, "inertial",
      {{"pos", coordinates(body.centre)},
       {"mass", body.mass},
       {"diaginertia", words({body.inertia, body.inertia, body.inertia})}});
  add_joint(node, link, model, tables);
  add(node, "geom",
      {{"type", "box"},
       {"pos", coordinates(body.box_centre)},
       {"size", coordinates(0.5 * body.box_size)},
       {"mass", "0"},
       {"contype", "0"},
       {"conaffinity", "0"}});
  if (model.tip().link == link)
    add(node, "site", {{"name", "tip"}, {"pos", coordinates(in_frame(model.tip().along, model.tip().offset))}});
  if (link + 1 < model.joints()) add_body(node, link + 1, model, links, tables);
}

void add_tables(xml_node custom, const std::vector<TorqueTable>& tables) {
  for (std::size_t i = 0; i < tables.size(); ++i) {
    const std::string pair = fmt::format("pair{}_", i + 1);
    add(custom, "numeric", {{"name", pair + "joint"}, {"data", words({tables[i].joint + 1.0})}});
    add(custom, "numeric", {{"name", pair + "coil"}, {"data", words({tables[i].coil + 1.0})}});
    add(custom, "numeric", {{"name", pair + "angle_rad"}, {"data", words(tables[i].angles)}});
    add(custom, "numeric", {{"name", pair + "torque_Nm_A"}, {"data", words(tables[i].torques)}});
  }
}

// How to drive the joints.
std::string use_of_motors(const std::vector<TorqueTable>& tables) {
  std::string text =
      "  The motor of a joint takes the torque in N m: for each pair, the current of its coil (A, positive opens) "
      "times\n"
      "  pairN_torque_Nm_A over pairN_angle_rad at the angle of the joint; torque.csv has the same numbers.\n";
  double miss = 0.0;
  for (const TorqueTable& table : tables) miss = std::max(miss, table.linear_error / largest_torque(table));
  if (!tables.empty())
    text += fmt::format("  Straight lines between the rows miss by at most {:.2g} of the largest torque.\n", miss);
  return text;
}

}  // namespace

std::vector<ExportedFile> mjcf(const ModelSubject& subject, const ExportSettings&) {
  SimulatorModel made = simulator_model(subject, "mjcf");
  const actuator::Model& model = made.plain.model;
  const std::vector<TorqueTable>& tables = made.tables;
  pugi::xml_document document;
  xml_node root = add(document, "mujoco", {{"model", model_name(subject.origin)}});
  root.append_child(pugi::node_comment)
      .set_value(head_comment(subject.origin, use_of_motors(tables), "", made.plain.left_out).c_str());
  add(root, "compiler", {{"angle", "radian"}, {"inertiafromgeom", "false"}});
  add(root, "option",
      {{"timestep", step_for(model)},
       {"gravity", coordinates(Eigen::Vector3d(0.0, 0.0, -model.chain().gravity()))},
       {"integrator", "RK4"}});
  if (!tables.empty()) add_tables(root.append_child("custom"), tables);
  const xml_node base = add(root.append_child("worldbody"), "body", {{"name", "base"}});
  if (const double tilt = model.chain().base_tilt(); tilt != 0.0)
    set(base, {{"axisangle", words({0.0, -1.0, 0.0, tilt})}});
  add_body(base, 0, model, made.links, tables);
  const xml_node motors = root.append_child("actuator");
  const xml_node sensors = root.append_child("sensor");
  for (int j = 0; j < model.joints(); ++j) {
    add(motors, "motor", {{"name", joint_name(j) + "_torque"}, {"joint", joint_name(j)}});
    add(sensors, "jointpos", {{"name", joint_name(j) + "_angle"}, {"joint", joint_name(j)}});
  }
  return with_torques("actuator.xml", document, std::move(made));
}

}  // namespace coilwright::exports
