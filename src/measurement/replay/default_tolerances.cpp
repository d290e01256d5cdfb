#include "measurement/replay/default_tolerances.hpp"

#include <fmt/format.h>

#include <optional>

namespace coilwright::measurement::replay {
namespace {

// A kitchen scale over 20 g; drawings and callipers on silicone; makers' tables of remanence; two mouldings of one
// batch.
constexpr double mass = 0.03;
constexpr double length = 0.02;
constexpr double inertia = 0.05;
constexpr double remanence = 0.03;
constexpr double force_curve = 0.03;
constexpr double stiffness = 0.10;
constexpr double damping = 0.20;
constexpr double stiffness_ratio = 0.05;
constexpr double damping_ratio = 0.10;
constexpr double face_closing = 1.0;  // deg

// Differences that any model may have.
void add_differences(std::vector<DefaultTolerance>& out, const std::vector<std::string>& stiffnesses,
                     const std::vector<std::string>& dampings) {
  out.push_back({.name = "force_curve", .deviation = force_curve});
  out.push_back({.name = "joint_stiffness_ratio", .deviation = stiffness_ratio, .instead_of = stiffnesses});
  out.push_back({.name = "joint_damping_ratio", .deviation = damping_ratio, .instead_of = dampings});
  out.push_back({.name = "face_closing_deg", .deviation = face_closing});
}

}  // namespace

std::vector<DefaultTolerance> default_tolerances(const actuator::Measured& measured) {
  std::vector<DefaultTolerance> out{
      {.name = "joint_stiffness",
       .deviation = stiffness,
       .instead_of = {"/measured/joint_stiffness_Nmm_rad", "/calibration/joint_stiffness_factor"}},
      {.name = "joint_damping",
       .deviation = damping,
       .instead_of = {"/measured/joint_damping_Nmms_rad", "/calibration/joint_damping_factor"}}};
  // Where it was measured, the number that a person knows; otherwise its factor.
  const auto add = [&](std::optional<double> actuator::Measured::*member, std::string value, std::string factor,
                       double deviation) {
    const bool known = (measured.*member).has_value();
    out.push_back({.name = known ? value : factor, .deviation = deviation, .instead_of = {known ? factor : value}});
  };
  add(&actuator::Measured::tip_segment_mass, "/measured/tip_segment_mass_g", "/calibration/coil_segment_mass_factor",
      mass);
  add(&actuator::Measured::magnet_segment_mass, "/measured/magnet_segment_mass_g",
      "/calibration/magnet_segment_mass_factor", mass);
  add(&actuator::Measured::tip_com, "/measured/tip_com_mm", "/calibration/tip_com_factor", length);
  add(&actuator::Measured::axis_offset, "/measured/axis_offset_mm", "/calibration/axis_offset_factor", length);
  out.push_back({.name = "/magnet/remanence_T", .deviation = remanence, .instead_of = {std::string(force_gain_name)}});
  add_differences(out, {}, {});
  return out;
}

std::vector<DefaultTolerance> default_tolerances(const actuator::LumpedModel& model) {
  std::vector<DefaultTolerance> out;
  std::vector<std::string> stiffnesses, dampings, magnets;
  for (std::size_t j = 0; j < model.links.size(); ++j) {
    stiffnesses.push_back(fmt::format("/joints/{}/stiffness_Nm_rad", j));
    dampings.push_back(fmt::format("/joints/{}/damping_Nms_rad", j));
    magnets.push_back(fmt::format("/magnetics/{}/magnet/remanence_T", j));
  }
  out.push_back({.name = "joint_stiffness", .deviation = stiffness, .instead_of = stiffnesses});
  out.push_back({.name = "joint_damping", .deviation = damping, .instead_of = dampings});
  for (std::size_t j = 0; j < model.links.size(); ++j) {
    const mechanics::Link& link = model.links[j];
    const std::string at = fmt::format("/links/{}/", j);
    out.push_back({.name = at + "mass_kg", .deviation = mass});
    if (link.com_along != 0.0) out.push_back({.name = at + "com_along_m", .deviation = length});
    if (link.com_offset != 0.0) out.push_back({.name = at + "com_offset_m", .deviation = length});
    if (j + 1 < model.links.size() && link.length != 0.0) out.push_back({.name = at + "length_m", .deviation = length});
    if (link.inertia != 0.0) out.push_back({.name = at + "inertia_kgm2", .deviation = inertia});
  }
  out.push_back({.name = std::string(force_gain_name), .deviation = remanence, .instead_of = magnets});
  add_differences(out, stiffnesses, dampings);
  return out;
}

std::vector<std::string> exact_by_default_of_design() {
  return {"gravity and the tilt of the base",
          "numbers of turns and the gauge of the wire",
          "the resistance of the coils",
          "lengths and radii of coils and magnets, but for what they do to the shape of the torque over the angle",
          "the angles at which the hinges rest",
          "zero and scale of the angle sensor"};
}

std::vector<std::string> exact_by_default_of_lumped_model() {
  return {"gravity and the tilt of the base", "constant torques of the joints",
          "stiffness and damping of faces that touch", "zero and scale of the angle sensor"};
}

}  // namespace coilwright::measurement::replay
