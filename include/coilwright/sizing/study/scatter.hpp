#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/simulation/quantity.hpp"

namespace coilwright::sizing {

/// Current and duty follow from the design: what a cell drives through its coils.
struct DrivenCurrent {
  /// Of one design.
  struct Drive {
    double current{};  ///< in every coil while it is on, A
    double duty{};     ///< 0 to 1
  };
  /// Pure; never empty.
  std::function<Drive(const actuator::Assembly&, const simulation::Settings&)> drive;
};

/// Deviations by the normal law of that standard deviation, cut off at 4 of them.
struct NormalDeviation {
  double sd{};  ///< > 0
};

/// Deviations from `low` to `high`, all alike; low < high.
struct UniformDeviation {
  double low{};
  double high{};
};

/// How one number of what is built lies about what was designed.
struct Scatter {
  std::string name;  ///< of a parameter of designs, of operating_number_names(), or of a block of the study
  std::variant<NormalDeviation, UniformDeviation> about;  ///< in the unit of the name, or relative
  bool relative{};                                        ///< whether deviations are shares of the designed value

  /// The deviation below which a share of all lies, 0 < share < 1; relative, or in the unit of the name.
  [[nodiscard]] double deviation(double share) const;
};

/// What builds, objects and supplies differ by: independent scatters. Immutable.
struct Spread {
  std::vector<Scatter> scatters;
  /// Of a number of a block, its value where no variable sets it, in SI: one per scatter, nothing for other numbers.
  std::vector<std::optional<double>> block_values;
  std::size_t draws = 32;  ///< of which statistics of one design are made; >= 8
  /// Where the current follows from the built design; empty: it is that of the operating point.
  DrivenCurrent driven{};
};

}  // namespace coilwright::sizing
