#include "coilwright/actuator/number_widths.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "coilwright/actuator/design/parameters.hpp"
#include "coilwright/actuator/design/value_limits.hpp"
#include "coilwright/actuator/hinges.hpp"
#include "coilwright/mechanics/silicone_hinge.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::actuator {
namespace {

using In = NumberWidth::In;

constexpr double megapascal = 1e6;

// E by tensile tests over E of the table (docs/theory/actuator.md, "Silicones"); of others half is what is known.
constexpr std::array<std::pair<std::string_view, double>, 6> tensile_shares{{{"Ecoflex 00-10", 26.5 / 94.6},
                                                                             {"Ecoflex 00-30", 50.6 / 118.0},
                                                                             {"Ecoflex 00-50", 71.8 / 142.0},
                                                                             {"Dragon Skin 10", 144.0 / 260.0},
                                                                             {"Dragon Skin 20", 387.0 / 579.0},
                                                                             {"Dragon Skin 30", 582.0 / 1016.0}}};

struct Shares {
  double least;
  double greatest;
};

// By a hardness alone: sheets have 0.79 to 1.4 of Gent's relation and tensile tests half; of Hertz's contact, 0.6 to
// 2.16 and 0.3.
constexpr Shares by_shore_a{.least = 0.5, .greatest = 1.4};
constexpr Shares by_shore_00{.least = 0.3, .greatest = 2.16};

bool same(double one, double other) {
  constexpr double rounding = 1e-3;  // of a table's digits
  return std::abs(one / other - 1.0) < rounding;
}

// From tensile tests to the hardness, where that is above the sheet.
Shares shares_of(const mechanics::SiliconeGrade& grade) {
  double by_hardness = 0.0;
  if (grade.shore_00 > 0.0) by_hardness = mechanics::young_modulus_from_shore_00(grade.shore_00);
  if (grade.shore_a >= 20.0) by_hardness = mechanics::young_modulus_from_shore_a(grade.shore_a);
  if (same(by_hardness, grade.young_modulus)) return by_shore_a;
  const auto found = std::ranges::find(tensile_shares, grade.name, &std::pair<std::string_view, double>::first);
  return {.least = found == tensile_shares.end() ? 0.5 : found->second,
          .greatest = std::max(1.0, by_hardness / grade.young_modulus)};
}

// A modulus that a file states itself is taken as measured.
std::vector<double> other_moduli(const SiliconeDesign& silicone) {
  const double modulus = silicone.modulus();
  Shares shares{};
  if (silicone.grade != nullptr && same(modulus, silicone.grade->young_modulus))
    shares = shares_of(*silicone.grade);
  else if (silicone.young_modulus > 0.0)
    return {};
  else
    shares = silicone.shore_hardness_00 > 0.0 ? by_shore_00 : by_shore_a;
  std::vector<double> out{shares.least * modulus / megapascal};
  if (shares.greatest > 1.0) out.push_back(shares.greatest * modulus / megapascal);
  return out;
}

bool has_bottom(const Design& design) {
  return design.bottom_silicone.has_value();
}
bool damping_is_by_law(const Design& design) {
  return !has_measured_damping(design);
}
bool is_of_loss_factor(const Design& design) {
  return damping_is_by_law(design) && design.choices.damping == DampingLaw::loss_factor;
}
bool is_of_loss_time(const Design& design) {
  return damping_is_by_law(design) && design.choices.damping == DampingLaw::proportional;
}

// Makers' tables stand behind what a grade brings; another value was stated.
template <auto Member>
bool is_of_grade(const Design& design) {
  MagnetDesign made;
  made.make_of(design.magnet.grade);
  return design.magnet.grade != nullptr && design.magnet.*Member == made.*Member;
}

constexpr NumberWidth without(std::string_view name, std::string_view why) {
  return {.name = name, .subject = {}, .source = why, .settled_by = {}};
}

// A row of what differs from build to build: known to the wider of the two ways to build.
constexpr NumberWidth tolerance(NumberWidth row) {
  row.greatest = std::max(row.printed, row.by_hand);
  row.least = -row.greatest;
  return row;
}

constexpr std::string_view ruler = "the part or the cast, with calipers";
constexpr std::string_view releases_of_two = "the ringing after a release of two fingers with different bottom layers";
constexpr std::string_view sheet =
    "a maker's sheet or a hardness, against tensile tests (theory/actuator.md, Silicones)";
constexpr std::string_view tensile = "the force that bends a joint of this silicone, into measured";
constexpr std::string_view in_modulus = "one name of the modulus: youngs_modulus_MPa has it";
constexpr std::string_view sheets_of_silicones = "makers' sheets of silicone rubber";
constexpr std::string_view its_curve = "the maker's curve of the magnets at two temperatures, into magnet";
constexpr std::string_view unfilled_silicones =
    "sheets measured by ASTM E1530: 0.22 to 0.25 W/(m K) (Thermtest); down to 0.15, assumed";
constexpr std::string_view commanded = "commanded, with the current";

// The rows with `printed` stand in the order in which builds draw them: another order is another set of builds.
constexpr std::array width_rows{
    without("current_share_1", commanded),
    without("current_share_2", commanded),
    without("current_share_3", commanded),
    without("current_share_4", commanded),
    tolerance({.name = "coil_inner_radius_mm",
               .subject = "bore of the coil",
               .source = "bobbins printed by stereolithography: +-0.1 mm (print services; +-0.3 mm by filament)",
               .settled_by = ruler,
               .in = In::deviations,
               .by_hand = 0.1}),
    without("wire_diameter_mm", "IEC 60317-0-1 within 1 to 1.6 %: coil_resistance_factor and the pitches have it"),
    without("wire_overall_mm", "what the enamel takes of the room: enamel and the pitches have it"),
    NumberWidth{.name = "enamel",
                .subject = "enamel of the wire",
                .source = "both grades of IEC 60317-0-1 are sold",
                .settled_by = "the order of the wire: enamel of the coil",
                .decided = true,
                .open =
                    [](const Design& design) {
                      return design.coil.wire_overall == 0.0 && design.calibration.radial_pitch == 1.0 &&
                             design.coil.enamel == winding::Enamel::grade_1;
                    },
                .values = [](const Design&) { return std::vector<double>{1.0}; }},
    NumberWidth{.name = "filler",
                .subject = "what is between the wires",
                .source = "coils are wound dry or potted",
                .settled_by = "how the coil is wound: filler of the coil",
                .decided = true,
                .open = [](const Design& design) { return design.coil.filler == Filler::unstated; },
                .values =
                    [](const Design&) {
                      return std::vector<double>{2.0, 1.0};
                    }},
    tolerance({.name = "remanence_T",
               .subject = "remanence of the magnets",
               .source = "makers' ranges of one grade of NdFeB, typical +-3 %",
               .settled_by = "the force between one coil and its magnet at two distances",
               .printed = 0.03,
               .by_hand = 0.03}),
    tolerance({.name = "magnet_radius_mm",
               .subject = "radius of the magnets",
               .source = "makers of discs: +-0.1 mm as sintered, +-0.05 mm ground",
               .settled_by = ruler,
               .in = In::deviations,
               .printed = 0.1,
               .by_hand = 0.1}),
    tolerance({.name = "magnet_length_mm",
               .subject = "length of the magnets",
               .source = "makers of discs: +-0.1 mm as sintered, +-0.05 mm ground",
               .settled_by = ruler,
               .in = In::deviations,
               .printed = 0.1,
               .by_hand = 0.1}),
    NumberWidth{.name = "magnet_density_kg_m3",
                .subject = "density of the magnets",
                .source = "makers' tables of sintered NdFeB: 7400 to 7600 kg/m3",
                .settled_by = "a balance",
                .in = In::values,
                .least = 7400.0,
                .greatest = 7600.0},
    without("magnet_temperature_limit_degC", "a limit that its maker sets"),
    // None of these is a scatter of builds: a lot of magnets has one value, and of HcJ no less than is guaranteed.
    NumberWidth{.name = "coercivity_kA_m",
                .subject = "coercivity of the magnets",
                .source = "makers guarantee the least; what is bought has 5 to 10 % more (theory/magnetics.md, Grades)",
                .settled_by = its_curve,
                .least = 0.0,
                .greatest = 0.1,
                .open = &is_of_grade<&MagnetDesign::coercivity>},
    NumberWidth{.name = "remanence_coefficient_pct_K",
                .subject = "loss of remanence in the heat",
                .source = "makers of sintered NdFeB: -0.09 to -0.13 %/K (theory/magnetics.md, Grades)",
                .settled_by = "the flux of a magnet at two temperatures",
                .in = In::values,
                .least = -0.13,
                .greatest = -0.09,
                .open = &is_of_grade<&MagnetDesign::remanence_coefficient>},
    NumberWidth{.name = "coercivity_coefficient_pct_K",
                .subject = "loss of coercivity in the heat",
                .source = "makers of one class are 20 % below and 10 % above (theory/magnetics.md, Grades)",
                .settled_by = its_curve,
                .least = -0.2,
                .greatest = 0.1,
                .open = &is_of_grade<&MagnetDesign::coercivity_coefficient>},
    NumberWidth{.name = "recoil_permeability",
                .subject = "recoil permeability of the magnets",
                .source = "makers of sintered NdFeB: 1.02 to 1.05, 1.05 in most tables (theory/magnetics.md, Grades)",
                .settled_by = its_curve,
                .in = In::values,
                .least = 1.02,
                .greatest = 1.05,
                .open = &is_of_grade<&MagnetDesign::recoil_permeability>},
    NumberWidth{.name = "squareness",
                .subject = "squareness of the magnets",
                .source = "sintered NdFeB: 0.9 is guaranteed, 0.99 a good one (theory/magnetics.md, Irreversible loss)",
                .settled_by = its_curve,
                .in = In::values,
                .least = 0.9,
                .greatest = 0.99,
                .open = &is_of_grade<&MagnetDesign::squareness>},
    tolerance({.name = "gap_mm",
               .subject = "gap between coil and magnet",
               .source = "ISO 3302-1 M2, what a mould fixes, to 4 mm: +-0.1 mm; cores set by hand: +-0.2 mm, assumed",
               .settled_by = ruler,
               .in = In::deviations,
               .printed = 0.1,
               .by_hand = 0.2}),
    tolerance(
        {.name = "bottom_layer_mm",
         .subject = "bottom layer, the hinge",
         .source = "ISO 3302-1 M2, what a mould fixes, to 4 mm: +-0.1 mm; what a cut by hand leaves: +-0.3 mm, assumed",
         .settled_by = "the stiffness of each joint, or a cut through the cast",
         .in = In::deviations,
         .printed = 0.1,
         .by_hand = 0.3}),
    tolerance({.name = "side_wall_mm",
               .subject = "side walls",
               .source = "ISO 3302-1 M2, what a mould fixes, to 4 mm: +-0.1 mm",
               .settled_by = ruler,
               .in = In::deviations,
               .by_hand = 0.1}),
    tolerance({.name = "bottom_wall_mm",
               .subject = "wall below the parts",
               .source = "parts set by hand: +-0.1 mm, assumed",
               .settled_by = ruler,
               .in = In::deviations,
               .by_hand = 0.1}),
    tolerance(
        {.name = "top_wall_mm",
         .subject = "wall above the parts",
         .source =
             "ISO 3302-1, across the closure of a mould, to 4 mm: M2 +-0.15, M3 +-0.4 mm; +-0.3 mm of an open top",
         .settled_by = ruler,
         .in = In::deviations,
         .by_hand = 0.3}),
    tolerance({.name = "front_length_mm",
               .subject = "silicone before the last part",
               .source = "trimmed by hand: +-0.5 mm, assumed",
               .settled_by = ruler,
               .in = In::deviations,
               .by_hand = 0.5}),
    tolerance({.name = "rear_length_mm",
               .subject = "silicone behind the first part",
               .source = "clamped by hand: +-1 mm, assumed",
               .settled_by = ruler,
               .in = In::deviations,
               .by_hand = 1.0}),
    NumberWidth{.name = "hinge_length_mm",
                .subject = "length of the strip that bends",
                .source = "the ends of a cast strip: +-0.3 mm, assumed",
                .settled_by = "the force that bends a joint",
                .in = In::deviations,
                .least = -0.3,
                .greatest = 0.3,
                .open = [](const Design& design) { return design.choices.hinge == HingeLaw::beam; }},
    NumberWidth{.name = "slot_width_mm",
                .subject = "width of the cut",
                .source = "cuts by hand: +-0.2 mm, assumed",
                .settled_by = ruler,
                .in = In::deviations,
                .least = -0.2,
                .greatest = 0.2,
                .open = [](const Design& design) { return design.choices.hinge == HingeLaw::slot; }},
    NumberWidth{.name = "poisson_ratio",
                .subject = "Poisson's ratio of the silicone",
                .source = "bulk modulus over a thousand times E is 0.4998; finite elements take 0.49",
                .settled_by = "the force that bends a joint",
                .in = In::values,
                .least = 0.49,
                .greatest = 0.5,
                .open = [](const Design& design) { return !has_measured_stiffness(design); }},
    NumberWidth{.name = "loss_factor",
                .subject = "loss factor of the silicone",
                .source = "silicones of this hardness: 0.05 to 0.2 (theory/actuator.md, Damping)",
                .settled_by = releases_of_two,
                .in = In::values,
                .least = 0.05,
                .greatest = 0.2,
                .open = &is_of_loss_factor},
    NumberWidth{.name = "constant_damping_Nmms_rad",
                .subject = "damping that does not follow the hinge",
                .source = "none to all of the prototype's 0.129 (theory/actuator.md, Damping)",
                .settled_by = releases_of_two,
                .in = In::values,
                .least = 0.0,
                .greatest = 0.129,
                .open = &damping_is_by_law},
    NumberWidth{.name = "loss_time_ms",
                .subject = "damping of the silicone over its stiffness",
                .source = "a loss factor of 0.05 at 5 Hz to all of the prototype's damping",
                .settled_by = releases_of_two,
                .in = In::values,
                .least = 1.6,
                .greatest = 10.3,
                .open = &is_of_loss_time},
    without("shore_hardness_A", in_modulus),
    without("shore_hardness_00", in_modulus),
    NumberWidth{.name = "youngs_modulus_MPa",
                .subject = "modulus of the silicone",
                .source = sheet,
                .settled_by = tensile,
                .least = -0.72,
                .greatest = 1.16,
                .open = [](const Design& design) { return has_bottom(design) || !has_measured_stiffness(design); },
                .values = [](const Design& design) { return other_moduli(design.body); }},
    tolerance({.name = "silicone_density_kg_m3",
               .subject = "density of the silicone",
               .source = "two digits of a sheet: +-2 %, assumed",
               .settled_by = "a balance",
               .by_hand = 0.02}),
    NumberWidth{.name = "heat_capacity_J_kgK",
                .subject = "heat capacity of the silicone",
                .source = sheets_of_silicones,
                .settled_by = "a warm-up with a thermocouple in the coil",
                .in = In::values,
                .least = 1050.0,
                .greatest = 1300.0},
    NumberWidth{.name = "conductivity_W_mK",
                .subject = "conductivity of the silicone",
                .source = unfilled_silicones,
                .settled_by = "a hold of an hour with a thermocouple in the coil",
                .in = In::values,
                .least = 0.15,
                .greatest = 0.25},
    without("bottom_shore_hardness_A", in_modulus),
    without("bottom_shore_hardness_00", in_modulus),
    NumberWidth{.name = "bottom_youngs_modulus_MPa",
                .subject = "modulus of the bottom layer",
                .source = sheet,
                .settled_by = tensile,
                .least = -0.72,
                .greatest = 1.16,
                .open = [](const Design& design) { return has_bottom(design) && !has_measured_stiffness(design); },
                .values = [](const Design& design) { return other_moduli(hinge_silicone(design)); }},
    NumberWidth{.name = "bottom_density_kg_m3",
                .subject = "density of the bottom layer",
                .source = "two digits of a sheet: +-2 %, assumed",
                .settled_by = "a balance",
                .least = -0.02,
                .greatest = 0.02,
                .open = &has_bottom},
    NumberWidth{.name = "bottom_heat_capacity_J_kgK",
                .subject = "heat capacity of the bottom layer",
                .source = sheets_of_silicones,
                .settled_by = "a warm-up with a thermocouple in the coil",
                .in = In::values,
                .least = 1050.0,
                .greatest = 1300.0,
                .open = &has_bottom},
    NumberWidth{.name = "bottom_conductivity_W_mK",
                .subject = "conductivity of the bottom layer",
                .source = unfilled_silicones,
                .settled_by = "a hold of an hour with a thermocouple in the coil",
                .in = In::values,
                .least = 0.15,
                .greatest = 0.25,
                .open = &has_bottom},
    NumberWidth{.name = "gravity_m_s2",
                .subject = "gravity of the place",
                .source = "from the equator to the poles: 9.78 to 9.83 m/s2",
                .settled_by = "the latitude",
                .in = In::values,
                .least = 9.78,
                .greatest = 9.83,
                .decided = true,
                // Another than the Earth's was chosen.
                .open =
                    [](const Design& design) {
                      return design.surroundings.gravity > 9.7 && design.surroundings.gravity < 9.9;
                    }},
    tolerance({.name = "base_tilt_deg",
               .subject = "mounting",
               .source = "a finger that hangs unless its tilt is said: sideways and upright; by hand +-3 deg, assumed",
               .settled_by = "how it is mounted: base_tilt_deg",
               .in = In::deviations,
               .by_hand = 3.0,
               .decided = true,
               .open = [](const Design& design) { return design.surroundings.gravity > 0.0; },
               .values =
                   [](const Design& design) {
                     const double tilt = units::from_memory(design.surroundings.base_tilt, "base_tilt_deg");
                     return tilt == 0.0 ? std::vector{90.0, -90.0, 180.0} : std::vector{tilt - 3.0, tilt + 3.0};
                   }}),
    NumberWidth{.name = "ambient_degC",
                .subject = "temperature of the place",
                .source = "rooms of IEC 60068-1: 15 to 35 degC",
                .settled_by = "a thermometer where it works: ambient_degC",
                .in = In::values,
                .least = 15.0,
                .greatest = 35.0,
                .decided = true,
                // Outside of these it is another place that was chosen.
                .open =
                    [](const Design& design) {
                      return design.surroundings.ambient >= 15.0 && design.surroundings.ambient <= 35.0;
                    }},
    NumberWidth{
        .name = "coil_limit_degC",
        .subject = "temperature that the enamel bears",
        .source = "classes of enamel of IEC 60317: 130 to 180 degC beside 155",
        .settled_by = "the order of the wire: coil_limit_degC",
        .in = In::values,
        .least = 130.0,
        .greatest = 180.0,
        .decided = true,
        .open = [](const Design& design) { return design.surroundings.coil_limit == Surroundings{}.coil_limit; }},
    without("heat_transfer_W_m2K", "heat_transfer_factor times it counts"),
    tolerance({.name = "axial_pitch_factor",
               .subject = "pitch of the turns",
               .source = "winding by hand: +-2 %, assumed",
               .settled_by = ruler,
               .by_hand = 0.02}),
    tolerance({.name = "joint_stiffness_factor",
               .subject = "stiffness of the joints from batch to batch",
               .source =
                   "sold to +-5 points of Shore A, of which the test has +-2: +-4 are 16 % of the modulus by Gent; "
                   "mixed and cured by hand +-30 %, assumed",
               .settled_by = "the stiffness of a joint of the batch",
               .printed = 0.16,
               .by_hand = 0.3}),
    tolerance({.name = "joint_damping_factor",
               .subject = "damping of the silicone from batch to batch",
               .source = "assumed",
               .settled_by = "the ringing after a release",
               .printed = 0.3,
               .by_hand = 0.3}),
    tolerance({.name = "constant_damping_factor",
               .subject = "damping of wires and faces from build to build",
               .source = "assumed: measured on one finger alone",
               .settled_by = "the ringing after a release",
               .printed = 0.6,
               .by_hand = 0.6}),
    NumberWidth{.name = "axis_offset_factor",
                .subject = "line about which a joint turns",
                .source = "finite elements: 0.62 to 0.72 of the bottom layer below the slit, taken 0.5",
                .settled_by = "the torque of a coil on its magnet, with the joint at two angles",
                .least = 0.0,
                .greatest = 0.05},
    NumberWidth{.name = "magnet_segment_mass_factor",
                .subject = "mass of a magnet's segment",
                .source = "the prototype's is 1.2 % more than its dimensions say",
                .settled_by = "a balance",
                .least = -0.03,
                .greatest = 0.03},
    NumberWidth{.name = "coil_segment_mass_factor",
                .subject = "mass of a coil's segment",
                .source = "the prototype's is 2.2 % more than its dimensions say",
                .settled_by = "a balance",
                .least = -0.03,
                .greatest = 0.03},
    NumberWidth{.name = "tip_com_factor",
                .subject = "centre of mass of the tip",
                .source = "the prototype's lies 3.7 % further out than its dimensions say",
                .settled_by = "a balance on an edge",
                .least = -0.04,
                .greatest = 0.04},
    tolerance({.name = "coil_resistance_factor",
               .subject = "resistance of the coils",
               .source = "IEC 60317-0-1: resistance of wires of 0.2 to 0.5 mm within +-3 to 5 %",
               .settled_by = "an ohmmeter",
               .printed = 0.03,
               .by_hand = 0.03}),
    tolerance({.name = "radial_pitch_factor",
               .subject = "pitch of the layers",
               .source = "winding by hand, assumed",
               .settled_by = ruler,
               .printed = 0.04,
               .by_hand = 0.04}),
    tolerance({.name = "heat_transfer_factor",
               .subject = "heat transfer in its place",
               .source = "calibrated on one remark; changes by 25 % with the rise",
               .settled_by = "a hold of an hour with a thermocouple in the coil",
               .printed = 0.3,
               .by_hand = 0.3}),
};

}  // namespace

std::span<const NumberWidth> number_widths() {
  return width_rows;
}

std::vector<double> other_values(const NumberWidth& width, const Design& design) {
  if (width.subject.empty() || (width.open != nullptr && !width.open(design))) return {};
  if (width.values != nullptr) return width.values(design);
  const Parameter& parameter = *find_parameter(width.name);
  const double value = units::from_memory(parameter.get(design), parameter.key);
  std::vector<double> out;
  for (const double end : {width.least, width.greatest}) {
    const double other = width.in == In::values ? end : width.in == In::shares ? value * (1.0 + end) : value + end;
    const bool is_there = parameter.rule == ParameterRule::length
                              ? units::to_memory(other, parameter.key) >= shortest_length
                              : other > 0.0 || parameter.rule == ParameterRule::any ||
                                    (other == 0.0 && parameter.rule == ParameterRule::not_negative);
    if (other != value && is_there) out.push_back(other);
  }
  return out;
}

}  // namespace coilwright::actuator
