#include "coilwright/exports/kinds.hpp"

#include <fmt/format.h>

#include <pugixml.hpp>
#include <sstream>
#include <utility>

#include "coilwright/text/csv/csv_writer.hpp"
#include "exports/chain/bodies.hpp"
#include "exports/chain/plain_model.hpp"

namespace coilwright::exports {
namespace {

using pugi::xml_node;

// URDF wants bounds of torque (N m) and rate (rad/s), and simulators clip at them. An actuator has neither: these are
// far beyond any.
constexpr double no_bound = 1000.0;

std::string link_name(int link) {
  return link < 0 ? "base" : fmt::format("link{}", link + 1);
}

void add_link(xml_node robot, int link, const RigidLink& body) {
  xml_node node = add(robot, "link", {{"name", link_name(link)}});
  xml_node inertial = node.append_child("inertial");
  add(inertial, "origin", {{"xyz", coordinates(body.centre)}});
  add(inertial, "mass", {{"value", body.mass}});
  const xml_node inertia = inertial.append_child("inertia");
  for (const auto* own : {"ixx", "iyy", "izz"}) set(inertia, {{own, body.inertia}});
  for (const auto* mixed : {"ixy", "ixz", "iyz"}) set(inertia, {{mixed, 0.0}});
  xml_node visual = node.append_child("visual");
  add(visual, "origin", {{"xyz", coordinates(body.box_centre)}});
  add(visual.append_child("geometry"), "box", {{"size", coordinates(body.box_size)}});
}

void add_joint(xml_node robot, int joint, const RigidLink& body, const actuator::Hinge& hinge, double upper) {
  const bool stops = hinge.contact.stiffness > 0.0;
  xml_node node = add(robot, "joint", {{"name", joint_name(joint)}, {"type", stops ? "revolute" : "continuous"}});
  add(node, "parent", {{"link", link_name(joint - 1)}});
  add(node, "child", {{"link", link_name(joint)}});
  add(node, "origin", {{"xyz", coordinates(body.joint)}});
  add(node, "axis", {{"xyz", "0 -1 0"}});
  add(node, "dynamics", {{"damping", hinge.damping}, {"friction", 0.0}});
  const xml_node limit = node.append_child("limit");
  if (stops) set(limit, {{"lower", hinge.contact.closing_angle}, {"upper", upper}});
  set(limit, {{"effort", no_bound}, {"velocity", no_bound}});
  xml_node gazebo = add(robot, "gazebo", {{"reference", joint_name(joint)}});
  gazebo.append_child("springReference").text().set(fmt::format("{}", rest_angle(hinge)).c_str());
  gazebo.append_child("springStiffness").text().set(fmt::format("{}", hinge.stiffness).c_str());
}

// The base with its mount: tilted links hang in gravity otherwise.
void add_base(xml_node robot, double tilt) {
  add(robot, "link", {{"name", "world"}});
  add(robot, "link", {{"name", "base"}});
  const xml_node mount = add(robot, "joint", {{"name", "mount"}, {"type", "fixed"}});
  add(mount, "parent", {{"link", "world"}});
  add(mount, "child", {{"link", "base"}});
  add(mount, "origin", {{"xyz", "0 0 0"}, {"rpy", words({0.0, 0.0 - tilt, 0.0})}});
}

std::string joints_csv(const actuator::Model& model) {
  std::ostringstream out;
  text::CsvWriter csv(out, {"joint", "stiffness_Nm_rad", "rest_angle_rad", "damping_Nms_rad", "closing_angle_rad",
                            "stop_stiffness_Nm_rad", "stop_damping_Nms_rad"});
  for (int j = 0; j < model.joints(); ++j) {
    const actuator::Hinge& hinge = model.hinges()[j];
    std::vector<text::CsvCell> row{j + 1, hinge.stiffness, rest_angle(hinge), hinge.damping};
    if (hinge.contact.stiffness > 0.0)
      row.insert(row.end(), {hinge.contact.closing_angle, hinge.contact.stiffness, hinge.contact.damping});
    else
      row.resize(7);
    csv.row(row);
  }
  return out.str();
}

}  // namespace

std::vector<ExportedFile> urdf(const ModelSubject& subject, const ExportSettings&) {
  SimulatorModel made = simulator_model(subject, "urdf");
  const actuator::Model& model = made.plain.model;
  for (int j = 0; j < model.joints(); ++j)
    if (const double rotor = model.chain().link(j).rotor_inertia; rotor > 0.0)
      made.plain.left_out.push_back(fmt::format("the rotor of {}, {:.4g} kg m2: URDF has none", joint_name(j), rotor));
  pugi::xml_document document;
  xml_node robot = add(document, "robot", {{"name", model_name(subject.origin)}});
  const std::string use = fmt::format(
      "  Gravity is {:.6g} m/s2 along -z. URDF has no springs: joints.csv has them, and so have the elements for "
      "Gazebo.\n"
      "  A joint's torque in N m: for each of its rows of one coil in torque.csv, the current of that coil (A, "
      "positive\n"
      "  opens) times torque_Nm_A at the angle of the joint.\n",
      model.chain().gravity());
  const std::string remark =
      fmt::format(" Effort and velocity of {} are no bounds of the actuator: URDF wants some.", no_bound);
  robot.append_child(pugi::node_comment)
      .set_value(head_comment(subject.origin, use, remark, made.plain.left_out).c_str());
  add_base(robot, model.chain().base_tilt());
  for (int j = 0; j < model.joints(); ++j) {
    const RigidLink& body = made.links[static_cast<std::size_t>(j)];
    add_joint(robot, j, body, model.hinges()[j], last_angle(j, made.tables));
    add_link(robot, j, body);
  }
  const std::string joints = joints_csv(model);
  std::vector<ExportedFile> files = with_torques("actuator.urdf", document, std::move(made));
  files.insert(files.begin() + 1, {.name = "joints.csv", .text = joints});
  return files;
}

}  // namespace coilwright::exports
