#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "coilwright/exports/subject.hpp"
#include "exports/cast.hpp"
#include "exports/workshop/recipe.hpp"
#include "exports/workshop/winding_sheet.hpp"

namespace coilwright::exports {

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

}  // namespace coilwright::exports
