#pragma once

#include <string>
#include <vector>

#include "coilwright/exports/settings.hpp"
#include "coilwright/exports/subject.hpp"
#include "coilwright/winding/wire.hpp"

namespace coilwright::exports {

/// One layer of a coil, for whoever winds it; SI.
struct LayerRow {
  int layer{};           ///< 1 is the innermost
  double diameter{};     ///< over the wires of this layer, m
  double wire_so_far{};  ///< of all layers up to this one, m
  double resistance{};   ///< of that at 20 degC, calibrated, ohm
};

/// What a meter shows between the ends of the leads; ohm.
struct MeterReading {
  double expected{};
  double least{};    ///< by the tolerance of the wire alone
  double largest{};  ///< by the tolerance of the wire alone
};

/// One coil of the actuator and the tool it is wound on; SI.
struct WindingSheet {
  int coils{};
  winding::Wire wire{};
  int turns_in_layer{};
  int layers{};
  double turn_pitch{};
  double layer_pitch{};
  bool staggered{};            ///< layers lie in the grooves of each other
  double core_diameter{};      ///< of the bobbin, which is the bore of the coil
  double flange_distance{};    ///< between the bobbin's flanges, which is the length of the coil
  double flange_diameter{};    ///< at least
  double outer_diameter{};     ///< of the finished coil
  double lead_length{};        ///< of each of the two leads
  double wire_length{};        ///< of the turns
  double wire_with_leads{};    ///< to cut for one coil
  double copper_mass{};        ///< of the turns
  double coil_resistance{};    ///< of the turns, at 20 degC, calibrated
  double lead_resistance{};    ///< of both leads, at 20 degC
  double resistance_factor{};  ///< measured over derived, where a coil was measured; 1 where none was
  double inductance{};
  double current_limit{};  ///< of the wire
  std::vector<LayerRow> rows;
};

/// All from the assembly and its winding.
[[nodiscard]] WindingSheet winding_sheet(const DesignSubject& subject, const ExportSettings& settings);

/// What a meter shows of coil and leads at `temperature`, degC.
[[nodiscard]] MeterReading meter_reading(const WindingSheet& sheet, double temperature);

/// What the reading grows by when the finished coil comes out wider by `excess` (m, of the diameter): longer turns. Ohm
/// at 20 degC.
[[nodiscard]] double reading_of_wider_coil(const WindingSheet& sheet, double excess);

/// winding.csv (quantity, value) and layers.csv.
[[nodiscard]] std::string winding_csv(const WindingSheet& sheet);
[[nodiscard]] std::string layers_csv(const WindingSheet& sheet);

}  // namespace coilwright::exports
