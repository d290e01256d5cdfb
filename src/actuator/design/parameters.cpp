#include "coilwright/actuator/design/parameters.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace coilwright::actuator {
namespace {

template <auto Part, auto Member>
double get(const Design& design) {
  return static_cast<double>(design.*Part.*Member);
}

template <auto Part, auto Member>
void set(Design& design, double value) {
  auto& member = design.*Part.*Member;
  using Value = std::remove_reference_t<decltype(member)>;
  if constexpr (std::is_same_v<Value, int>) {
    member = static_cast<int>(std::lround(value));
  } else {
    member = value;
  }
}

template <auto Part, auto Member>
constexpr Parameter number(std::string_view section, std::string_view key, std::string_view name, ParameterRule rule) {
  using Value = std::remove_cvref_t<decltype(std::declval<Design>().*Part.*Member)>;
  return {.section = section,
          .key = key,
          .name = name,
          .whole = std::is_same_v<Value, int>,
          .rule = rule,
          .get = &get<Part, Member>,
          .set = &set<Part, Member>};
}

template <std::size_t Coil>
constexpr Parameter current_share(std::string_view name) {
  return {.section = "coil",
          .key = name,
          .name = name,
          .rule = ParameterRule::share,
          .get = [](const Design& design) { return design.coil.current_shares[Coil]; },
          .set = [](Design& design, double value) { design.coil.current_shares[Coil] = value; }};
}

using enum ParameterRule;

// "none", then every grade of the table.
std::span<const std::string_view> grade_names() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> out{"none"};
    for (const magnetics::MagnetGrade& grade : magnetics::magnet_grades()) out.push_back(grade.name);
    return out;
  }();
  return names;
}

double get_grade(const Design& design) {
  const magnetics::MagnetGrade* grade = design.magnet.grade;
  return grade == nullptr ? 0.0 : static_cast<double>(grade - magnetics::magnet_grades().data() + 1);
}

void set_grade(Design& design, double value) {
  const auto index = static_cast<std::size_t>(std::lround(value));
  design.magnet.make_of(index == 0 ? nullptr : &magnetics::magnet_grades()[index - 1]);
}

constexpr std::array table = {
    number<&Design::coil, &CoilDesign::inner_radius>("coil", "inner_radius_mm", "coil_inner_radius_mm", length),
    number<&Design::coil, &CoilDesign::turns_radial>("coil", "turns_radial", "turns_radial", at_least_one),
    number<&Design::coil, &CoilDesign::turns_axial>("coil", "turns_axial", "turns_axial", at_least_one),
    number<&Design::coil, &CoilDesign::wire_gauge>("coil", "wire_gauge_AWG", "wire_gauge_AWG", any),
    current_share<0>("current_share_1"),
    current_share<1>("current_share_2"),
    current_share<2>("current_share_3"),
    current_share<3>("current_share_4"),
    // Before the numbers that it brings along, so that a file's own count.
    Parameter{.section = "magnet",
              .key = "grade",
              .name = "magnet_grade",
              .whole = true,
              .rule = any,
              .get = &get_grade,
              .set = &set_grade,
              .name_list = &grade_names},
    number<&Design::magnet, &MagnetDesign::radius>("magnet", "radius_mm", "magnet_radius_mm", length),
    number<&Design::magnet, &MagnetDesign::length>("magnet", "length_mm", "magnet_length_mm", length),
    number<&Design::magnet, &MagnetDesign::remanence>("magnet", "remanence_T", "remanence_T", positive),
    number<&Design::magnet, &MagnetDesign::density>("magnet", "density_kg_m3", "magnet_density_kg_m3", positive),
    number<&Design::magnet, &MagnetDesign::temperature_limit>("magnet", "temperature_limit_degC",
                                                              "magnet_temperature_limit_degC", any),
    number<&Design::body, &BodyDesign::gap>("body", "gap_mm", "gap_mm", length),
    number<&Design::body, &BodyDesign::bottom_layer>("body", "bottom_layer_mm", "bottom_layer_mm", length),
    number<&Design::body, &BodyDesign::side_wall>("body", "side_wall_mm", "side_wall_mm", length),
    number<&Design::body, &BodyDesign::bottom_wall>("body", "bottom_wall_mm", "bottom_wall_mm", length),
    number<&Design::body, &BodyDesign::top_wall>("body", "top_wall_mm", "top_wall_mm", length),
    number<&Design::body, &BodyDesign::front_length>("body", "front_length_mm", "front_length_mm", length),
    number<&Design::body, &BodyDesign::rear_length>("body", "rear_length_mm", "rear_length_mm", length),
    number<&Design::body, &BodyDesign::hinge_length>("body", "hinge_length_mm", "hinge_length_mm", length),
    number<&Design::body, &BodyDesign::slot_width>("body", "slot_width_mm", "slot_width_mm", not_negative),
    number<&Design::body, &BodyDesign::poisson_ratio>("body", "poisson_ratio", "poisson_ratio", not_negative),
    number<&Design::body, &BodyDesign::loss_factor>("body", "loss_factor", "loss_factor", not_negative),
    number<&Design::body, &BodyDesign::constant_damping>("body", "constant_damping_Nmms_rad",
                                                         "constant_damping_Nmms_rad", not_negative),
    number<&Design::body, &BodyDesign::shore_hardness>("body", "shore_hardness_A", "shore_hardness_A", positive),
    number<&Design::body, &BodyDesign::loss_time>("body", "loss_time_ms", "loss_time_ms", not_negative),
    number<&Design::body, &BodyDesign::density>("body", "density_kg_m3", "silicone_density_kg_m3", positive),
    number<&Design::body, &BodyDesign::heat_capacity>("body", "heat_capacity_J_kgK", "heat_capacity_J_kgK", positive),
    number<&Design::body, &BodyDesign::conductivity>("body", "conductivity_W_mK", "conductivity_W_mK", positive),
    number<&Design::surroundings, &Surroundings::gravity>("surroundings", "gravity_m_s2", "gravity_m_s2", not_negative),
    number<&Design::surroundings, &Surroundings::base_tilt>("surroundings", "base_tilt_deg", "base_tilt_deg", any),
    number<&Design::surroundings, &Surroundings::ambient>("surroundings", "ambient_degC", "ambient_degC", any),
    number<&Design::surroundings, &Surroundings::coil_limit>("surroundings", "coil_limit_degC", "coil_limit_degC", any),
    number<&Design::surroundings, &Surroundings::heat_transfer>("surroundings", "heat_transfer_W_m2K",
                                                                "heat_transfer_W_m2K", positive),
    number<&Design::calibration, &Calibration::axial_pitch>("calibration", "axial_pitch_factor", "axial_pitch_factor",
                                                            positive),
    number<&Design::calibration, &Calibration::radial_pitch>("calibration", "radial_pitch_factor",
                                                             "radial_pitch_factor", positive),
    number<&Design::calibration, &Calibration::joint_stiffness>("calibration", "joint_stiffness_factor",
                                                                "joint_stiffness_factor", positive),
    number<&Design::calibration, &Calibration::joint_damping>("calibration", "joint_damping_factor",
                                                              "joint_damping_factor", positive),
    number<&Design::calibration, &Calibration::constant_damping>("calibration", "constant_damping_factor",
                                                                 "constant_damping_factor", not_negative),
    number<&Design::calibration, &Calibration::axis_offset>("calibration", "axis_offset_factor", "axis_offset_factor",
                                                            positive),
    number<&Design::calibration, &Calibration::magnet_segment_mass>("calibration", "magnet_segment_mass_factor",
                                                                    "magnet_segment_mass_factor", positive),
    number<&Design::calibration, &Calibration::coil_segment_mass>("calibration", "coil_segment_mass_factor",
                                                                  "coil_segment_mass_factor", positive),
    number<&Design::calibration, &Calibration::tip_com>("calibration", "tip_com_factor", "tip_com_factor", positive),
    number<&Design::calibration, &Calibration::coil_resistance>("calibration", "coil_resistance_factor",
                                                                "coil_resistance_factor", positive),
    number<&Design::calibration, &Calibration::heat_transfer>("calibration", "heat_transfer_factor",
                                                              "heat_transfer_factor", positive),
};

}  // namespace

std::span<const Parameter> parameters() {
  return table;
}

std::optional<double> value_named(const Parameter& parameter, std::string_view name) {
  const std::span<const std::string_view> names = parameter.names();
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) return std::nullopt;
  return static_cast<double>(found - names.begin());
}

const Parameter* find_parameter(std::string_view name) {
  const auto found = std::ranges::find(table, name, &Parameter::name);
  return found == table.end() ? nullptr : &*found;
}

}  // namespace coilwright::actuator
