#include <string>
#include <utility>

#include "cli/search/list/listings.hpp"
#include "coilwright/actuator/number_widths.hpp"
#include "coilwright/magnetics/magnet_grade.hpp"
#include "coilwright/mechanics/silicone_grade.hpp"
#include "coilwright/mechanics/silicone_hinge.hpp"
#include "coilwright/sizing/study/usual_scatters.hpp"
#include "coilwright/units/unit.hpp"
#include "coilwright/winding/wire.hpp"

namespace coilwright::cli {
namespace {

double in_unit(double value, std::string_view column) {
  return units::from_memory(value, column);
}

Listing::Cell stated(double hardness) {
  return hardness > 0.0 ? Listing::Cell(hardness) : Listing::Cell();
}

}  // namespace

Listing gauge_listing() {
  Listing listing{.columns = {"wire_gauge_AWG", "bare_diameter_mm", "insulated_diameter_mm", "resistance_Ohm_m",
                              "chassis_current_A", "current_by_law_A"},
                  .rows = {}};
  for (int awg = winding::thickest_gauge; awg <= winding::thinnest_gauge; ++awg) {
    const winding::Wire wire = winding::gauge(awg);
    listing.rows.push_back({static_cast<double>(awg), in_unit(wire.bare_diameter, "diameter_mm"),
                            in_unit(wire.insulated_diameter, "diameter_mm"), wire.resistance_per_length,
                            wire.chassis_ampacity, wire.smooth_ampacity});
  }
  return listing;
}

Listing magnet_listing() {
  Listing listing{
      .columns = {"grade", "remanence_T", "least_remanence_T", "coercivity_kA_m", "recoil_permeability",
                  "remanence_per_K", "coercivity_per_K", "temperature_limit_degC", "density_kg_m3", "price_over_N52"},
      .rows = {}};
  constexpr double kiloampere = 1e3;
  for (const magnetics::MagnetGrade& grade : magnetics::magnet_grades())
    listing.rows.push_back({std::string(grade.name), grade.remanence, grade.least_remanence,
                            grade.coercivity / kiloampere, grade.recoil_permeability, grade.remanence_coefficient,
                            grade.coercivity_coefficient, grade.temperature_limit, grade.density, grade.price_ratio});
  return listing;
}

Listing spread_listing() {
  Listing listing{.columns = {"number", "sd", "relative_sd", "parts", "source"}, .rows = {}};
  for (const auto& [making, parts] :
       {std::pair(sizing::Making::printed, "usual"), std::pair(sizing::Making::by_hand, "by_hand")})
    for (const sizing::UsualScatter& usual : sizing::usual_scatters(making)) {
      const double deviation = std::get<sizing::NormalDeviation>(usual.scatter.about).sd;
      const auto where = [&](bool relative) { return stated(usual.scatter.relative == relative ? deviation : 0.0); };
      listing.rows.push_back(
          {usual.scatter.name, where(false), where(true), std::string(parts), std::string(usual.source)});
    }
  return listing;
}

Listing width_listing() {
  using In = actuator::NumberWidth::In;
  Listing listing{.columns = {"number", "in", "least", "greatest", "what", "source", "settled_by"}, .rows = {}};
  for (const actuator::NumberWidth& width : actuator::number_widths()) {
    const bool has_ends = width.greatest > width.least;
    const auto end = [&](double value) { return has_ends ? Listing::Cell(value) : Listing::Cell(); };
    const std::string in = !has_ends                    ? ""
                           : width.in == In::deviations ? "deviations"
                           : width.in == In::shares     ? "shares"
                                                        : "values";
    listing.rows.push_back({std::string(width.name), in, end(width.least), end(width.greatest),
                            std::string(width.subject), std::string(width.source), std::string(width.settled_by)});
  }
  return listing;
}

Listing silicone_listing() {
  Listing listing{.columns = {"silicone", "shore_hardness_A", "shore_hardness_00", "youngs_modulus_MPa",
                              "density_kg_m3", "base_per_hardener"},
                  .rows = {}};
  constexpr double megapascal = 1e6;
  for (const mechanics::SiliconeGrade& grade : mechanics::silicone_grades())
    listing.rows.push_back({std::string(grade.name), stated(grade.shore_a), stated(grade.shore_00),
                            grade.young_modulus / megapascal, grade.density, grade.base_per_hardener});
  for (int shore = 10; shore <= 70; shore += 10)
    listing.rows.push_back(
        {{}, {}, static_cast<double>(shore), mechanics::young_modulus_from_shore_00(shore) / megapascal, {}, {}});
  for (int shore = 20; shore <= 80; shore += 5)
    listing.rows.push_back(
        {{}, static_cast<double>(shore), {}, mechanics::young_modulus_from_shore_a(shore) / megapascal, {}, {}});
  return listing;
}

}  // namespace coilwright::cli
