#pragma once

#include <Eigen/Core>
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

/// The pulsed supply of the coils, as quantities of a design.
struct StudyDriver {
  /// Share of a period that it is on. Nothing, and why, where it cannot give the current: then the design cannot be
  /// operated, and has no performance.
  simulation::ResultQuantity duty;
  simulation::ResultQuantity ripple_heat;      ///< heat of the coils beyond that of their mean current, %
  simulation::ResultQuantity thermal_load;     ///< thermal_load with that heat, of which no other quantity knows
  simulation::ResultQuantity peak_over_limit;  ///< of all coils together, over what the driver bears
};

/// Deviations by the normal law of that standard deviation, cut off at 4 of them. Relative ones above
/// most_normal_share are those of a number whose logarithm is normal, with the designed value as its median: a normal
/// law would have numbers below 0.
struct NormalDeviation {
  double sd{};  ///< > 0
};

/// Four standard deviations of this many leave nothing.
inline constexpr double most_normal_share = 0.25;

/// Deviations from `low` to `high`, all alike; low < high.
struct UniformDeviation {
  double low{};
  double high{};
};

/// Not a number: how hinges, damping, film, faces, winding and ampacity are modelled. As the design has it with that
/// probability, otherwise by one of actuator::other_choices(), all alike.
struct OtherChoices {
  double as_designed{};  ///< > 0 and < 1
};

/// How one number of what is built lies about what was designed.
struct Scatter {
  /// Of a parameter of designs, of an effect's number ("dry_friction.torque_Nmm"), of further_number_names(), or of a
  /// block of the study.
  std::string name;
  std::variant<NormalDeviation, UniformDeviation, OtherChoices> about;  ///< in the unit of the name, or relative
  bool relative{};  ///< whether deviations are shares of the designed value
  /// Of a number of a block, its value where no variable sets it, in SI; nothing for other numbers.
  std::optional<double> block_value{};
  /// Of a number that was measured, what it was found to be, in the unit of the name; nothing for others.
  std::optional<double> measured{};
  /// Of a number with most_parts(): which joint or magnet, from the base. A design without it passes it over.
  std::size_t part = 0;
  /// Whether it differs from use to use of one build, as the room's temperature does; else a build has it for good.
  bool of_use{};

  /// The deviation below which a share of all lies, 0 < share < 1; relative, or in the unit of the name. Precondition:
  /// not OtherChoices.
  [[nodiscard]] double deviation(double share) const;
};

/// Scatters that move together: the normal deviates behind their shares are correlated (a Gaussian copula).
struct CorrelatedScatters {
  std::string name;                   ///< as results show them: "posterior"
  std::vector<std::size_t> scatters;  ///< their indices
  Eigen::MatrixXd root;               ///< times its transpose it is their correlation, (n, n)
};

/// A root of a correlation matrix, which may be singular. Throws std::invalid_argument for a matrix that is none.
[[nodiscard]] Eigen::MatrixXd correlation_root(const Eigen::MatrixXd& correlation);

/// What builds, and the uses of each, differ by. Immutable.
struct Spread {
  std::vector<Scatter> scatters;
  std::vector<CorrelatedScatters> correlated{};  ///< all others are independent
  std::size_t draws = 32;                        ///< of which statistics of one design are made; >= 8
  /// What holds in every use holds in that share of the uses where a law of theirs has no ends; > 0.5 and <= 1.
  double share_of_uses = 0.99;
  /// Where the current follows from the built design; empty: it is that of the operating point.
  DrivenCurrent driven{};
  std::optional<StudyDriver> driver{};  ///< that has to give the current of a build too; nothing: anything does
};

}  // namespace coilwright::sizing
