#include "exports/workshop/sheets.hpp"

#include <numbers>
#include <sstream>

#include "coilwright/actuator/design/dimensions.hpp"
#include "coilwright/text/csv/csv_writer.hpp"
#include "coilwright/units/unit.hpp"
#include "coilwright/winding/copper.hpp"

namespace coilwright::exports {
namespace {

// By which the flanges of a bobbin stand out of the coil, m: enough to hold the outermost layer. A choice.
constexpr double flange_overhang = 2e-3;

std::vector<LayerRow> rows_of(const winding::Winding& coil, double resistance_factor) {
  std::vector<LayerRow> rows;
  double wire = 0.0;
  for (int layer = 0; layer < coil.spec().turns_radial; ++layer) {
    const double radius = winding::layer_radius(coil, layer);
    wire += 2.0 * std::numbers::pi * radius * coil.spec().turns_axial;
    rows.push_back({.layer = layer + 1,
                    .diameter = 2.0 * radius + coil.wire().insulated_diameter,
                    .wire_so_far = wire,
                    .resistance = resistance_factor * coil.wire().resistance_per_length * wire});
  }
  return rows;
}

}  // namespace

WindingSheet winding_sheet(const DesignSubject& subject, const ExportSettings& settings) {
  const winding::Winding coil = actuator::winding_of(subject.design);
  const actuator::CoilElectrics& electrics = subject.assembly.coil;
  const double factor = subject.design.calibration.coil_resistance;
  const double leads = 2.0 * settings.lead_length;
  return {.coils = subject.assembly.coils,
          .wire = coil.wire(),
          .turns_in_layer = coil.spec().turns_axial,
          .layers = coil.spec().turns_radial,
          .turn_pitch = coil.axial_pitch(),
          .layer_pitch = coil.radial_pitch(),
          .staggered = coil.spec().packing.nested(),
          .core_diameter = 2.0 * coil.inner_radius(),
          .flange_distance = coil.length(),
          .flange_diameter = 2.0 * (coil.outer_radius() + flange_overhang),
          .outer_diameter = 2.0 * coil.outer_radius(),
          .lead_length = settings.lead_length,
          .wire_length = electrics.wire_length,
          .wire_with_leads = electrics.wire_length + leads,
          .copper_mass = electrics.copper_mass,
          .coil_resistance = electrics.resistance,
          .lead_resistance = leads * coil.wire().resistance_per_length,
          .resistance_factor = factor,
          .inductance = electrics.inductance,
          .current_limit = electrics.current_limit,
          .rows = rows_of(coil, factor)};
}

MeterReading meter_reading(const WindingSheet& sheet, double temperature) {
  const double expected =
      (sheet.coil_resistance + sheet.lead_resistance) * winding::copper_resistance_ratio(temperature);
  const winding::ResistanceRange range = winding::resistance_range(sheet.wire);
  return {.expected = expected, .least = expected * range.least, .largest = expected * range.largest};
}

double reading_of_wider_coil(const WindingSheet& sheet, double excess) {
  // The mean radius, with which the length of a turn goes, grows by a quarter of the diameter's excess.
  const double mean_diameter = 0.5 * (sheet.core_diameter + sheet.outer_diameter);
  return sheet.coil_resistance * 0.5 * excess / mean_diameter;
}

std::string winding_csv(const WindingSheet& sheet) {
  std::ostringstream out;
  text::CsvWriter csv(out, {"quantity", "value"});
  const auto row = [&](std::string_view name, double si) { csv.row({name, rounded(units::from_memory(si, name))}); };
  const MeterReading reading = meter_reading(sheet, 20.0);
  row("coils", sheet.coils);
  if (sheet.wire.awg) row("wire_gauge_AWG", *sheet.wire.awg);
  row("bare_diameter_mm", sheet.wire.bare_diameter);
  row("least_bare_diameter_mm", sheet.wire.least_bare);
  row("largest_bare_diameter_mm", sheet.wire.largest_bare);
  row("insulated_diameter_mm", sheet.wire.insulated_diameter);
  row("turns_in_layer", sheet.turns_in_layer);
  row("layers", sheet.layers);
  row("turn_pitch_mm", sheet.turn_pitch);
  row("layer_pitch_mm", sheet.layer_pitch);
  row("core_diameter_mm", sheet.core_diameter);
  row("flange_distance_mm", sheet.flange_distance);
  row("flange_diameter_mm", sheet.flange_diameter);
  row("outer_diameter_mm", sheet.outer_diameter);
  row("lead_mm", sheet.lead_length);
  row("wire_of_turns_m", sheet.wire_length);
  row("wire_with_leads_m", sheet.wire_with_leads);
  row("copper_mass_g", sheet.copper_mass);
  row("coil_resistance_Ohm", sheet.coil_resistance);
  row("lead_resistance_Ohm", sheet.lead_resistance);
  row("meter_reading_20_degC_Ohm", reading.expected);
  row("least_reading_Ohm", reading.least);
  row("largest_reading_Ohm", reading.largest);
  row("inductance_mH", sheet.inductance);
  row("current_limit_A", sheet.current_limit);
  return out.str();
}

std::string layers_csv(const WindingSheet& sheet) {
  std::ostringstream out;
  text::CsvWriter csv(out, {"layer", "diameter_mm", "turns_so_far", "wire_so_far_m", "resistance_so_far_Ohm"});
  for (const LayerRow& row : sheet.rows)
    csv.row({row.layer, rounded(units::from_memory(row.diameter, "diameter_mm")), row.layer * sheet.turns_in_layer,
             rounded(row.wire_so_far), rounded(row.resistance)});
  return out.str();
}

}  // namespace coilwright::exports
