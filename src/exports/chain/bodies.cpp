#include "exports/chain/bodies.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "coilwright/text/one_line.hpp"

namespace coilwright::exports {
namespace {

// Share of mass times distance squared that stands in for the inertia of a point; it moves no frequency by more.
constexpr double inertia_of_a_point = 1e-7;
// A box to look at has at least this share of its link's length, and of 10 mm, on every side.
constexpr double thinnest = 0.1;
constexpr double usual_length = 10e-3;

RigidLink body_of(const mechanics::Link& link, double joint_along) {
  const double reach = std::hypot(link.com_along, link.com_offset);
  const double length = std::max(link.length, thinnest * usual_length);
  // The joint is at the face of the segment, and its centre of mass near the middle of its height.
  const double height = std::max(2.0 * std::abs(link.com_offset), thinnest * length);
  return {.joint = in_frame(joint_along, 0.0),
          .centre = in_frame(link.com_along, link.com_offset),
          .mass = link.mass,
          .inertia = std::max(link.inertia, inertia_of_a_point * link.mass * std::max(reach * reach, 1e-6)),
          .box_centre = in_frame(0.5 * length, link.com_offset),
          .box_size = {height, height, length}};
}

}  // namespace

Eigen::Vector3d in_frame(double along, double offset) {
  return {-offset + 0.0, 0.0, -along + 0.0};  // no negative zeros
}

std::vector<RigidLink> rigid_links(const mechanics::PlanarChain& chain) {
  std::vector<RigidLink> bodies;
  double joint_along = 0.0;
  for (const mechanics::Link& link : chain.links()) {
    bodies.push_back(body_of(link, joint_along));
    joint_along = link.length;
  }
  return bodies;
}

std::string words(const std::vector<double>& numbers) {
  return fmt::format("{}", fmt::join(numbers, " "));
}

std::string coordinates(const Eigen::Vector3d& vector) {
  return fmt::format("{} {} {}", vector.x(), vector.y(), vector.z());
}

SimulatorModel simulator_model(const ModelSubject& subject, std::string_view format) {
  PlainModel plain = plain_model(subject.model);
  for (const actuator::Hinge& hinge : plain.model.hinges())
    if (hinge.torque_offset != 0.0 && hinge.stiffness == 0.0)
      throw std::invalid_argument(
          fmt::format("{}: a joint with a torque offset needs a stiffness, for its rest angle", format));
  plain.left_out.emplace_back(
      "inertia about the axes in the plane of bending: the planar model does not know it, and each body has that of "
      "its bending for all axes");
  std::vector<TorqueTable> tables = torque_tables(plain.model);
  std::vector<RigidLink> links = rigid_links(plain.model.chain());
  return {.plain = std::move(plain), .tables = std::move(tables), .links = std::move(links)};
}

double rest_angle(const actuator::Hinge& hinge) {
  return hinge.torque_offset == 0.0 ? 0.0 : hinge.torque_offset / hinge.stiffness;
}

std::string model_name(const Origin& origin) {
  return origin.name.empty() ? "actuator" : text::one_line(origin.name);
}

std::string head_comment(const Origin& origin, std::string_view use, std::string_view remark,
                         const std::vector<std::string>& left_out) {
  std::string text = fmt::format(
      "\n  {}{}\n  SI units. Hangs along -z where all joints are 0; a positive angle bends it towards +x.\n{}  The "
      "lower limit of a joint is where its faces meet; the upper one is where its torque ceases to be known, and no\n  "
      "stop of the actuator.{}\n",
      origin.name.empty() ? "Actuator" : text::one_line(origin.name),
      origin.made_by.empty() ? "." : ". Made by " + origin.made_by + ".", use, remark);
  for (const std::string& line : left_out) text += fmt::format("  Left out: {}.\n", line);
  return comment_text(std::move(text));
}

std::vector<ExportedFile> with_torques(std::string name, const pugi::xml_document& document, SimulatorModel model) {
  std::vector<ExportedFile> files{{.name = std::move(name),
                                   .text = text_of(document),
                                   .left_out = std::move(model.plain.left_out),
                                   .too_much = std::move(model.plain.too_much)}};
  if (!model.tables.empty()) files.push_back({.name = "torque.csv", .text = torque_csv(model.tables)});
  return files;
}

std::string joint_name(int joint) {
  return fmt::format("joint{}", joint + 1);
}

std::string comment_text(std::string text) {
  for (std::size_t at = text.find("--"); at != std::string::npos; at = text.find("--", at + 1))
    text.insert(at + 1, 1, ' ');
  if (!text.empty() && text.back() == '-') text += ' ';
  return text;
}

std::string text_of(const pugi::xml_document& document) {
  std::ostringstream out;
  document.save(out, "  ", pugi::format_default, pugi::encoding_utf8);
  return out.str();
}

}  // namespace coilwright::exports
