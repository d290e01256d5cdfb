#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "coilwright/exports/subject.hpp"
#include "coilwright/text/markup.hpp"
#include "coilwright/winding/wire.hpp"
#include "exports/cast.hpp"

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

/// One row of the bill of materials.
struct BillRow {
  std::string item;
  std::string specification;  ///< what to order
  std::string quantity;       ///< with its unit
  double price{};             ///< US$, as actuator::cost_of() splits them
};

/// Everything that one actuator is made of, and what drives it. The prices are those of the source paper's Table III,
/// scaled: the sum of all rows but the last is actuator::Cost::total().
[[nodiscard]] std::vector<BillRow> bill_of_materials(const DesignSubject& subject, const ExportSettings& settings,
                                                     const WindingSheet& winding, const Cast& cast);

/// materials.csv.
[[nodiscard]] std::string materials_csv(const std::vector<BillRow>& rows);

/// Silicone that ends in one segment of the actuator.
struct SegmentSilicone {
  int segment{};  ///< 1 is the base's
  actuator::ComponentKind kind{};
  double volume{};  ///< m^3
  double mass{};    ///< kg
};

/// Silicone that is mixed at once.
struct Batch {
  std::string_view use;
  double density{};            ///< kg/m^3
  double base_per_hardener{};  ///< mass of part A over that of part B; 0: not known
  double in_actuator{};        ///< m^3
  double waste{};              ///< that stays in cups and on tools, m^3
  double dip{};                ///< that the dipping cup must hold beside, m^3; not used up

  [[nodiscard]] double mixed() const { return in_actuator + waste + dip; }
};

/// How much silicone to mix, and when.
struct Recipe {
  std::vector<SegmentSilicone> segments;
  std::vector<Batch> batches;
  double coil_dip{};    ///< wall on a coil's face, m: one dip
  double magnet_dip{};  ///< wall on a magnet's face, m: two dips
};

/// In the three mixes of the source paper's section IV, after that of a bottom layer of its own silicone.
[[nodiscard]] Recipe recipe(const DesignSubject& subject, const ExportSettings& settings, const Cast& cast);

/// casting.csv: the batches, then the segments.
[[nodiscard]] std::string casting_csv(const Recipe& recipe);

/// How one part is built in. Every coil is wound in one sense: seen from its marked face, the wire runs clockwise from
/// the start of the winding, at the bore, to its end. Marked faces look towards the tip.
struct PartRow {
  int number{};  ///< 1 is the base's
  actuator::ComponentKind kind{};
  double centre{};                 ///< from the rear end of the body, m
  std::string_view north_towards;  ///< "tip" or "base": of a magnet; of a coil at positive current
  std::string_view current;        ///< of a coil, positive, seen from the tip: "clockwise" or "anticlockwise"; or empty
  std::string_view positive_lead;  ///< of a coil: "start" or "end" of the winding; or empty
  /// Face of a coil over which the start leaves the bore: "base", "tip" or "either", where no magnet is; "neither"
  /// between two magnets. Empty for a magnet.
  std::string_view start_face;
};

/// What a positive current does at one joint.
struct JointRow {
  int number{};             ///< 1 is the base's
  double place{};           ///< of its slit, from the rear end of the body, m
  double gap{};             ///< silicone between the two parts, m
  std::string_view effect;  ///< "pushes apart", "pulls together" or "nearly nothing" (two coils)
};

/// The actuator as it is put together.
struct AssemblyOrder {
  std::vector<PartRow> parts;
  std::vector<JointRow> joints;
  std::vector<std::string> steps;   ///< whole sentences, in their order
  std::vector<std::string> checks;  ///< with a meter, a compass and a cell, before and after bonding
};

/// Polarities as actuator::Component says: a coil of +1 at positive current repels a magnet of +1. A magnet of +1 has
/// its north pole towards the tip.
[[nodiscard]] AssemblyOrder assembly_order(const DesignSubject& subject, const Cast& cast, const Recipe& recipe,
                                           const WindingSheet& winding);

/// assembly.csv: the parts, base first.
[[nodiscard]] std::string assembly_csv(const AssemblyOrder& order);

/// The sections of workshop.html, each a heading with what stands below it. `figure` is HTML.
[[nodiscard]] std::string winding_section(const WindingSheet& sheet);
[[nodiscard]] std::string bill_section(const std::vector<BillRow>& rows);
[[nodiscard]] std::string recipe_section(const Recipe& recipe);
[[nodiscard]] std::string assembly_section(const AssemblyOrder& order, std::string_view figure);

/// The nearest number of six decimal digits: what a workshop can read, and a thousand times finer than it can work.
[[nodiscard]] double rounded(double value);

}  // namespace coilwright::exports
