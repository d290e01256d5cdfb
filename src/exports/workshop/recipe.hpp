#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "coilwright/exports/settings.hpp"
#include "coilwright/exports/subject.hpp"
#include "exports/cast.hpp"

namespace coilwright::exports {

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

}  // namespace coilwright::exports
