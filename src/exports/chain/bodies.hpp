#pragma once

#include <fmt/format.h>
#include <pugixml.hpp>

#include <Eigen/Core>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/actuator/model/model.hpp"
#include "coilwright/exports/subject.hpp"
#include "exports/chain/plain_model.hpp"

namespace coilwright::exports {

/// What a joint is called in every format: "joint1" is the first.
[[nodiscard]] std::string joint_name(int joint);

/// A link of a planar chain as a body in space. Its frame is at its joint; at angle 0 it is that of the world, z up, so
/// that the link hangs along -z. Joints turn about -y: a positive angle bends the chain towards +x, and opens the slits
/// on its -x side.
struct RigidLink {
  Eigen::Vector3d joint;   ///< own joint in the frame of the link before, m
  Eigen::Vector3d centre;  ///< of mass, m
  double mass{};           ///< kg
  /// About the centre of mass, of every axis, kg m^2: what the plane tells of y. A point mass has the least that a
  /// simulator takes for a body, 1e-7 of mass times distance squared.
  double inertia{};
  Eigen::Vector3d box_centre;  ///< of a box to look at, m
  Eigen::Vector3d box_size;    ///< whole lengths, m
};

/// The links of a chain, base to tip.
[[nodiscard]] std::vector<RigidLink> rigid_links(const mechanics::PlanarChain& chain);

/// A point of a link in its frame, m.
[[nodiscard]] Eigen::Vector3d in_frame(double along, double offset);

/// Numbers with spaces between them, each with the fewest digits that read back as the same double.
[[nodiscard]] std::string words(const std::vector<double>& numbers);
/// The same for a vector.
[[nodiscard]] std::string coordinates(const Eigen::Vector3d& vector);

/// What a simulator's file of links and joints is made of.
struct SimulatorModel {
  PlainModel plain;  ///< with what such a file leaves out
  std::vector<TorqueTable> tables;
  std::vector<RigidLink> links;
};
/// Throws std::invalid_argument, naming the format, for a joint whose rest angle would need a stiffness.
[[nodiscard]] SimulatorModel simulator_model(const ModelSubject& subject, std::string_view format);

/// Rest angle of a hinge, rad; 0 for one without torque offset.
[[nodiscard]] double rest_angle(const actuator::Hinge& hinge);

/// "actuator" where the origin has no name.
[[nodiscard]] std::string model_name(const Origin& origin);

/// Comment at the head of such a file: where it is from and its units, `use`, what the limits of its joints are,
/// `remark` behind that, and what is left out.
[[nodiscard]] std::string head_comment(const Origin& origin, std::string_view use, std::string_view remark,
                                       const std::vector<std::string>& left_out);

/// The document as a file of that name with what is left out of it, and torque.csv where there are torques.
[[nodiscard]] std::vector<ExportedFile> with_torques(std::string name, const pugi::xml_document& document,
                                                     SimulatorModel model);

/// An attribute of an element: a text, or a number with the fewest digits that read back as the same double.
struct XmlAttribute {
  XmlAttribute(const char* its_name, std::string_view text) : name(its_name), value(text) {}
  XmlAttribute(const char* its_name, double number) : name(its_name), value(fmt::format("{}", number)) {}

  const char* name;
  std::string value;
};

/// Sets attributes, after those that are there.
inline void set(pugi::xml_node node, std::initializer_list<XmlAttribute> attributes) {
  for (const XmlAttribute& each : attributes) node.append_attribute(each.name).set_value(each.value.c_str());
}

/// An element with these attributes, behind those that `parent` has.
inline pugi::xml_node add(pugi::xml_node parent, const char* element, std::initializer_list<XmlAttribute> attributes) {
  pugi::xml_node node = parent.append_child(element);
  set(node, attributes);
  return node;
}

/// What may stand in a comment: two hyphens in a row may not, nor one at the end.
[[nodiscard]] std::string comment_text(std::string text);

/// The document as UTF-8 text, two spaces a level.
[[nodiscard]] std::string text_of(const pugi::xml_document& document);

}  // namespace coilwright::exports
