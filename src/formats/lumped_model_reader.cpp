#include "lumped_model_reader.hpp"

#include <algorithm>
#include <boost/math/interpolators/barycentric_rational.hpp>
#include <memory>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "coilwright/magnetics/curve.hpp"
#include "coilwright/magnetics/hinge_torque.hpp"
#include "magnetic_parts.hpp"

namespace coilwright::formats {
namespace {

using actuator::Hinge;
using actuator::HingePair;
using magnetics::Curve;
using mechanics::Link;

// A curve over the whole working range of a joint, exact to a millionth of its largest torque.
constexpr double degree = std::numbers::pi / 180.0;
constexpr Curve::Spec pair_range{.lower = -2.0 * degree, .upper = 120.0 * degree, .tolerance = 1e-6};

Link read_link(const Node& node) {
  return read_object(node, [](ObjectReader& in) {
    return Link{.length = in.quantity("length_m", non_negative),
                .com_along = in.quantity("com_along_m"),
                .com_offset = in.quantity("com_offset_m"),
                .mass = in.quantity("mass_kg", positive),
                .inertia = in.quantity("inertia_kgm2", non_negative)};
  });
}

Hinge read_joint(const Node& node) {
  return read_object(node, [](ObjectReader& in) {
    Hinge hinge{.stiffness = in.quantity("stiffness_Nm_rad", non_negative),
                .damping = in.quantity("damping_Nms_rad", non_negative),
                .torque_offset = in.quantity_or("torque_offset_Nm", 0.0)};
    if (const auto contact = in.find_not_null("contact")) {
      hinge.contact = read_object(*contact, [](ObjectReader& faces) {
        return mechanics::FaceContact{.closing_angle = faces.quantity("closing_angle_deg"),
                                      .stiffness = faces.quantity("stiffness_Nm_rad", positive),
                                      .damping = faces.quantity_or("damping_Nms_rad", 0.0, non_negative)};
      });
    }
    return hinge;
  });
}

// Coil and magnet of Table II with the paper's l_a, l_b and h.
Curve read_pair_curve(ObjectReader& in) {
  const magnetics::Winding winding = read_winding(in);
  const magnetics::ThickCoil coil = read_coil(in.at("coil"), winding);
  const magnetics::CylinderMagnet magnet = read_magnet(in.at("magnet"));
  const magnetics::HingeGeometry geometry{.coil_offset = in.quantity("coil_offset_mm", positive),
                                          .magnet_offset = in.quantity("magnet_offset_mm", positive),
                                          .axis_offset = in.quantity("axis_offset_mm", positive)};
  const auto fidelity =
      in.choice_or("torque", magnetics::Fidelity::line_of_centres,
                   {{"line_of_centres", magnetics::Fidelity::line_of_centres}, {"exact", magnetics::Fidelity::exact}});
  return magnetics::torque_curve(coil, magnet, geometry, fidelity, pair_range);
}

// Measured torque per ampere over the joint angle, joined by a rational interpolant without poles (Floater and
// Hormann).
Curve read_table_curve(ObjectReader& in) {
  const Node angle_node = in.at("angle_deg");
  const std::vector<double> angles = angle_node.quantities(Length::at_least(4));
  const std::vector<double> torques = in.quantities("torque_Nmm_A", Length::exactly(angles.size()));
  if (std::ranges::adjacent_find(angles, std::greater_equal<>()) != angles.end())
    throw angle_node.error_without_value("must increase from one angle to the next");
  const boost::math::barycentric_rational<double> table(angles.data(), torques.data(), angles.size(), 3);
  const auto values = [&table](std::span<const double> at, std::span<double> out) {
    std::ranges::transform(at, out.begin(), [&table](double angle) { return table(angle); });
  };
  return Curve(values, {.lower = angles.front(), .upper = angles.back(), .tolerance = 1e-4});
}

// One entry per joint, null for a joint without a coil. Each coil has a current of its own.
std::vector<HingePair> read_magnetics(const Node& node, std::size_t joints) {
  std::vector<HingePair> pairs;
  const std::vector<Node> entries = node.elements(Length::exactly(joints));
  for (std::size_t j = 0; j < joints; ++j) {
    if (entries[j].is_null()) continue;
    Curve curve = read_object(entries[j], [](ObjectReader& in) {
      return in.one_of({"coil", "angle_deg"}) == "coil" ? read_pair_curve(in) : read_table_curve(in);
    });
    pairs.push_back({.joint = static_cast<int>(j),
                     .coil = static_cast<int>(pairs.size()),
                     .torque_per_ampere = std::make_shared<const Curve>(std::move(curve))});
  }
  return pairs;
}

}  // namespace

actuator::Model read_lumped_model(ObjectReader& in) {
  const double gravity = in.quantity_or("gravity_m_s2", 9.81, non_negative);
  std::vector<Link> links;
  for (const Node& node : in.elements("links", Length::from_to(1, mechanics::max_joints)))
    links.push_back(read_link(node));
  std::vector<Hinge> hinges;
  for (const Node& node : in.elements("joints", Length::exactly(links.size()))) hinges.push_back(read_joint(node));
  std::vector<HingePair> pairs;
  if (const auto magnetics = in.find_not_null("magnetics")) pairs = read_magnetics(*magnetics, links.size());
  const int coils = static_cast<int>(pairs.size());
  return actuator::Model({.chain = mechanics::PlanarChain(links, gravity),
                          .hinges = std::move(hinges),
                          .magnetics = actuator::MagneticStage(std::move(pairs), {}),
                          .coils = coils,
                          .tip = {.link = static_cast<int>(links.size()) - 1, .along = links.back().length}});
}

}  // namespace coilwright::formats
