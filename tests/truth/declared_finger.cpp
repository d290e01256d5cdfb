#include "truth/declared_finger.hpp"

#include <nlohmann/json.hpp>
#include <numbers>

namespace truth {

using Json = nlohmann::ordered_json;

std::string declared_finger(const Faces& faces) {
  const Finger finger;
  const Pair pair;
  Json joint = {{"stiffness_Nm_rad", finger.stiffness}, {"damping_Nms_rad", finger.damping}};
  if (faces.stiffness > 0.0)
    joint["contact"] = {{"closing_angle_deg", faces.angle * 180.0 / std::numbers::pi},
                        {"stiffness_Nm_rad", faces.stiffness},
                        {"damping_Nms_rad", faces.damping}};
  Json magnetics = {{"winding", "paper_shells"},
                    {"torque", "line_of_centres"},
                    {"coil_offset_mm", 6.3},
                    {"magnet_offset_mm", 3.6},
                    {"axis_offset_mm", 11.5},
                    {"coil",
                     {{"inner_radius_mm", 3},
                      {"outer_radius_mm", 9.5},
                      {"length_mm", 12},
                      {"turns_radial", pair.turns_radial},
                      {"turns_axial", pair.turns_axial}}},
                    {"magnet", {{"radius_mm", 10}, {"length_mm", 6}, {"remanence_T", pair.remanence}}}};
  const auto link = [&](double length, double com_along, double mass) {
    return Json{{"length_m", length},
                {"com_along_m", com_along},
                {"com_offset_m", finger.axis_offset},
                {"mass_kg", mass},
                {"inertia_kgm2", 0}};
  };
  const Json file = {
      {"format", "lumped-model/1"},
      {"name", "paper finger, Table II"},
      {"gravity_m_s2", finger.gravity},
      {"links",
       {link(0.0072, finger.half_pitch, finger.first_mass), link(0.0212, finger.second_com, finger.second_mass)}},
      {"joints", {joint, joint}},
      {"magnetics", {magnetics, magnetics}}};
  return file.dump(2) + "\n";
}

}  // namespace truth
