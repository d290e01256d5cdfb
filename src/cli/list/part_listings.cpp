#include <string>

#include "coilwright/magnetics/magnet_grade.hpp"
#include "coilwright/mechanics/silicone_hinge.hpp"
#include "coilwright/units/unit.hpp"
#include "coilwright/winding/wire_gauge.hpp"
#include "listings.hpp"

namespace coilwright::cli {
namespace {

double in_unit(double value, std::string_view column) {
  return units::from_memory(value, column);
}

}  // namespace

Listing gauge_listing() {
  Listing listing{.columns = {"wire_gauge_AWG", "bare_diameter_mm", "insulated_diameter_mm", "resistance_Ohm_m",
                              "chassis_current_A", "current_by_law_A"},
                  .rows = {}};
  for (int awg = winding::thickest_gauge; awg <= winding::thinnest_gauge; ++awg) {
    const winding::WireGauge wire = winding::gauge(awg);
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

Listing silicone_listing() {
  Listing listing{.columns = {"shore_hardness_A", "youngs_modulus_MPa"}, .rows = {}};
  constexpr int softest = 20, hardest = 80, step = 5;
  constexpr double megapascal = 1e6;
  for (int shore = softest; shore <= hardest; shore += step)
    listing.rows.push_back({static_cast<double>(shore), mechanics::young_modulus_from_shore_a(shore) / megapascal});
  return listing;
}

}  // namespace coilwright::cli
