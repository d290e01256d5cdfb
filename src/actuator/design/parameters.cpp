#include "coilwright/actuator/design/parameters.hpp"

#include <fmt/format.h>

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
  if constexpr (std::is_same_v<Value, int> || std::is_enum_v<Value>) {
    member = static_cast<Value>(std::lround(value));
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
          .set = [](Design& design, double value) { design.coil.current_shares[Coil] = value; },
          // Hardly an actuator has coils with drivers of their own.
          .needed = [](const Design& design) { return design.coil.current_shares[Coil] != 1.0; }};
}

using enum ParameterRule;

// "none", then every row of a table.
template <auto Table>
std::span<const std::string_view> names_in() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> out{"none"};
    for (const auto& row : Table()) out.push_back(row.name);
    return out;
  }();
  return names;
}

// A row of a table and its index among names_in() it.
template <auto Table, class Row>
double index_in(const Row* row) {
  return row == nullptr ? 0.0 : static_cast<double>(row - Table().data() + 1);
}

template <auto Table>
auto row_in(double index) {
  const auto place = static_cast<std::size_t>(std::lround(index));
  return place == 0 ? nullptr : &Table()[place - 1];
}

constexpr std::array<std::string_view, 2> enamel_names{"grade_1", "grade_2"};
constexpr std::array<std::string_view, 3> filler_names{"unstated", "silicone", "air"};

// One of a few kinds, by the names of the enumerators. Files say what is not as usual.
template <auto Member, const auto& Names>
constexpr Parameter coil_choice(std::string_view name) {
  Parameter out = number<&Design::coil, Member>("coil", name, name, any);
  out.whole = true;
  out.name_list = [] { return std::span<const std::string_view>(Names); };
  out.needed = [](const Design& design) { return design.coil.*Member != CoilDesign{}.*Member; };
  return out;
}

// The wire: by one of two numbers, of which the one that is set last counts, as for an overall diameter that was set
// for another wire.
constexpr std::string_view the_wire = "the wire";

bool by_diameter(const Design& design) {
  return design.coil.wire_diameter > 0.0;
}

void set_gauge(Design& design, double value) {
  design.coil.wire_gauge = static_cast<int>(std::lround(value));
  design.coil.wire_diameter = 0.0;
  design.coil.wire_overall = 0.0;
}

double get_wire_diameter(const Design& design) {
  return wire_of(design.coil).bare_diameter;
}

void set_wire_diameter(Design& design, double value) {
  design.coil.wire_diameter = value;
  design.coil.wire_overall = 0.0;
}

// What a grade brings and files say only where it is another: as made of the grade.
template <auto Member>
constexpr Parameter grade_number(std::string_view key, std::string_view name, ParameterRule rule) {
  Parameter out = number<&Design::magnet, Member>("magnet", key, name, rule);
  out.needed = [](const Design& design) {
    MagnetDesign made;
    made.make_of(design.magnet.grade);
    return design.magnet.*Member != made.*Member;
  };
  return out;
}

// The silicones: that of the body, and that of the bottom layer where it is another.
struct OfBody {
  static const SiliconeDesign& in(const Design& design) { return design.body; }
  static SiliconeDesign& in(Design& design) { return design.body; }
  static bool is_there(const Design&) { return true; }
  static constexpr std::string_view section = "body";
};
struct OfBottom {
  static const SiliconeDesign& in(const Design& design) { return hinge_silicone(design); }
  static SiliconeDesign& in(Design& design) {
    if (!design.bottom_silicone) design.bottom_silicone = design.body;
    return *design.bottom_silicone;
  }
  static bool is_there(const Design& design) { return design.bottom_silicone.has_value(); }
  static constexpr std::string_view section = "bottom_layer_silicone";
};

constexpr std::string_view its_stiffness = "the stiffness of the silicone";
enum class StiffnessBy { modulus, shore_00, shore_a };

StiffnessBy stiffness_by(const SiliconeDesign& silicone) {
  if (silicone.young_modulus > 0.0) return StiffnessBy::modulus;
  return silicone.shore_hardness_00 > 0.0 ? StiffnessBy::shore_00 : StiffnessBy::shore_a;
}

template <class Of, auto Member>
constexpr Parameter silicone_number(std::string_view key, std::string_view name) {
  return {.section = Of::section,
          .key = key,
          .name = name,
          .rule = positive,
          .get = [](const Design& design) { return Of::in(design).*Member; },
          .set = [](Design& design, double value) { Of::in(design).*Member = value; },
          .needed = &Of::is_there};
}

// One of the numbers that name the stiffness: the others are given up for it.
template <class Of, auto Member, StiffnessBy By>
constexpr Parameter silicone_stiffness(std::string_view key, std::string_view name, ParameterRule rule) {
  Parameter out = silicone_number<Of, Member>(key, name);
  out.rule = rule;
  out.set = [](Design& design, double value) {
    SiliconeDesign& silicone = Of::in(design);
    if (By != StiffnessBy::modulus) silicone.young_modulus = 0.0;
    if (By == StiffnessBy::shore_a) silicone.shore_hardness_00 = 0.0;
    silicone.*Member = value;
  };
  out.needed = [](const Design& design) { return Of::is_there(design) && stiffness_by(Of::in(design)) == By; };
  out.one_name_of = its_stiffness;
  return out;
}

template <class Of>
constexpr Parameter silicone_grade(std::string_view name) {
  return {
      .section = Of::section,
      .key = "silicone",
      .name = name,
      .whole = true,
      .rule = any,
      .get = [](const Design& design) { return index_in<mechanics::silicone_grades>(Of::in(design).grade); },
      .set = [](Design& design, double value) { Of::in(design).make_of(row_in<mechanics::silicone_grades>(value)); },
      .name_list = &names_in<mechanics::silicone_grades>,
      .needed = [](const Design& design) { return Of::is_there(design) && Of::in(design).grade != nullptr; }};
}

constexpr std::array table = {
    number<&Design::coil, &CoilDesign::inner_radius>("coil", "inner_radius_mm", "coil_inner_radius_mm", length),
    number<&Design::coil, &CoilDesign::turns_radial>("coil", "turns_radial", "turns_radial", at_least_one),
    number<&Design::coil, &CoilDesign::turns_axial>("coil", "turns_axial", "turns_axial", at_least_one),
    Parameter{.section = "coil",
              .key = "wire_gauge_AWG",
              .name = "wire_gauge_AWG",
              .whole = true,
              .rule = any,
              .get = [](const Design& design) { return static_cast<double>(design.coil.wire_gauge); },
              .set = &set_gauge,
              .needed = [](const Design& design) { return !by_diameter(design); },
              .one_name_of = the_wire},
    Parameter{.section = "coil",
              .key = "wire_diameter_mm",
              .name = "wire_diameter_mm",
              .rule = positive,
              .get = &get_wire_diameter,
              .set = &set_wire_diameter,
              .needed = &by_diameter,
              .one_name_of = the_wire},
    coil_choice<&CoilDesign::enamel, enamel_names>("enamel"),
    Parameter{.section = "coil",
              .key = "wire_overall_mm",
              .name = "wire_overall_mm",
              .rule = length,
              .get = [](const Design& design) { return wire_of(design.coil).insulated_diameter; },
              .set = [](Design& design, double value) { design.coil.wire_overall = value; },
              .needed = [](const Design& design) { return design.coil.wire_overall > 0.0; }},
    coil_choice<&CoilDesign::filler, filler_names>("filler"),
    current_share<0>("current_share_1"),
    current_share<1>("current_share_2"),
    current_share<2>("current_share_3"),
    current_share<3>("current_share_4"),
    // Before the numbers that it brings along, so that a file's own count.
    Parameter{
        .section = "magnet",
        .key = "grade",
        .name = "magnet_grade",
        .whole = true,
        .rule = any,
        .get = [](const Design& design) { return index_in<magnetics::magnet_grades>(design.magnet.grade); },
        .set = [](Design& design, double value) { design.magnet.make_of(row_in<magnetics::magnet_grades>(value)); },
        .name_list = &names_in<magnetics::magnet_grades>},
    number<&Design::magnet, &MagnetDesign::radius>("magnet", "radius_mm", "magnet_radius_mm", length),
    number<&Design::magnet, &MagnetDesign::length>("magnet", "length_mm", "magnet_length_mm", length),
    number<&Design::magnet, &MagnetDesign::remanence>("magnet", "remanence_T", "remanence_T", positive),
    number<&Design::magnet, &MagnetDesign::density>("magnet", "density_kg_m3", "magnet_density_kg_m3", positive),
    number<&Design::magnet, &MagnetDesign::temperature_limit>("magnet", "temperature_limit_degC",
                                                              "magnet_temperature_limit_degC", any),
    grade_number<&MagnetDesign::coercivity>("coercivity_kA_m", "coercivity_kA_m", positive),
    grade_number<&MagnetDesign::remanence_coefficient>("remanence_coefficient_pct_K", "remanence_coefficient_pct_K",
                                                       any),
    grade_number<&MagnetDesign::coercivity_coefficient>("coercivity_coefficient_pct_K", "coercivity_coefficient_pct_K",
                                                        any),
    grade_number<&MagnetDesign::recoil_permeability>("recoil_permeability", "recoil_permeability", positive),
    grade_number<&MagnetDesign::squareness>("squareness", "squareness", positive),
    silicone_grade<OfBody>("silicone"),
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
    silicone_stiffness<OfBody, &SiliconeDesign::shore_hardness, StiffnessBy::shore_a>("shore_hardness_A",
                                                                                      "shore_hardness_A", positive),
    silicone_stiffness<OfBody, &SiliconeDesign::shore_hardness_00, StiffnessBy::shore_00>(
        "shore_hardness_00", "shore_hardness_00", positive),
    silicone_stiffness<OfBody, &SiliconeDesign::young_modulus, StiffnessBy::modulus>("youngs_modulus_MPa",
                                                                                     "youngs_modulus_MPa", positive),
    number<&Design::body, &BodyDesign::loss_time>("body", "loss_time_ms", "loss_time_ms", not_negative),
    silicone_number<OfBody, &SiliconeDesign::density>("density_kg_m3", "silicone_density_kg_m3"),
    silicone_number<OfBody, &SiliconeDesign::heat_capacity>("heat_capacity_J_kgK", "heat_capacity_J_kgK"),
    silicone_number<OfBody, &SiliconeDesign::conductivity>("conductivity_W_mK", "conductivity_W_mK"),
    silicone_grade<OfBottom>("bottom_silicone"),
    silicone_stiffness<OfBottom, &SiliconeDesign::shore_hardness, StiffnessBy::shore_a>(
        "shore_hardness_A", "bottom_shore_hardness_A", positive),
    silicone_stiffness<OfBottom, &SiliconeDesign::shore_hardness_00, StiffnessBy::shore_00>(
        "shore_hardness_00", "bottom_shore_hardness_00", positive),
    silicone_stiffness<OfBottom, &SiliconeDesign::young_modulus, StiffnessBy::modulus>(
        "youngs_modulus_MPa", "bottom_youngs_modulus_MPa", positive),
    silicone_number<OfBottom, &SiliconeDesign::density>("density_kg_m3", "bottom_density_kg_m3"),
    silicone_number<OfBottom, &SiliconeDesign::heat_capacity>("heat_capacity_J_kgK", "bottom_heat_capacity_J_kgK"),
    silicone_number<OfBottom, &SiliconeDesign::conductivity>("conductivity_W_mK", "bottom_conductivity_W_mK"),
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

std::optional<std::string> conflict_between(const Parameter& one, const Parameter& other) {
  if (&one == &other || one.one_name_of.empty() || one.one_name_of != other.one_name_of || one.section != other.section)
    return std::nullopt;
  return fmt::format("must not be there beside \"{}\": both give {}", other.key, one.one_name_of);
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
