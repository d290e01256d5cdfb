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

/// A current and a duty that follow from the design: those with which a cell drives its coils.
struct DrivenCurrent {
  /// The current and duty of one design.
  struct Drive {
    double current{};  ///< in every coil while it is on, A
    double duty{};     ///< 0 to 1
  };
  /// Returns the drive of a design. Pure; never empty.
  std::function<Drive(const actuator::Assembly&, const simulation::Settings&)> drive;
};

/// The pulsed supply of the coils, as quantities of a design.
struct StudyDriver {
  /// Share of a period during which the pulses are on. Absent, with the reason, if the supply cannot give the current;
  /// the design then cannot be operated and has no performance.
  simulation::ResultQuantity duty;
  simulation::ResultQuantity ripple_heat;      ///< heat of the coils beyond that of their mean current, %
  simulation::ResultQuantity thermal_load;     ///< thermal_load with that heat, which no other quantity includes
  simulation::ResultQuantity peak_over_limit;  ///< of all coils together, over what the driver bears
};

/// Normal deviations of that standard deviation, cut off at 4 of them. For a relative one above most_normal_share the
/// logarithm is normal, with the designed value as its median, because a normal law would give negative numbers.
struct NormalDeviation {
  double sd{};  ///< > 0
};

/// Largest relative standard deviation of a normal law: four of them leave nothing of the value.
inline constexpr double most_normal_share = 0.25;

/// Deviations uniform from `low` to `high`; low < high.
struct UniformDeviation {
  double low{};
  double high{};
};

/// Scatter of the modelling of hinges, damping, film, faces, winding and ampacity: as the design has it with that
/// probability, otherwise by one of actuator::other_choices(), all with equal probability.
struct OtherChoices {
  double as_designed{};  ///< > 0 and < 1
};

/// The scatter of one number of a build about the designed value.
struct Scatter {
  /// Name of a parameter of designs, of an effect's number ("dry_friction.torque_Nmm"), of one of
  /// further_number_names(), or of a number of a block of the study.
  std::string name;
  std::variant<NormalDeviation, UniformDeviation, OtherChoices> about;  ///< in the unit of the name, or relative
  bool relative{};  ///< whether deviations are shares of the designed value
  /// For a number of a block its value if no variable sets it, in SI; absent for other numbers.
  std::optional<double> block_value{};
  /// The measured value of the number, in the unit of the name; absent if it was not measured.
  std::optional<double> measured{};
  /// For a number with most_parts() the joint or magnet, from the base. A design without that part ignores the scatter.
  std::size_t part = 0;
  /// Whether the number differs between uses of one build, as the room's temperature does; otherwise a build has it for
  /// good.
  bool of_use{};

  /// The deviation below which a share of all deviations lies, 0 < share < 1; relative, or in the unit of the name.
  /// Precondition: not OtherChoices.
  [[nodiscard]] double deviation(double share) const;
};

/// Scatters with a Gaussian copula: the normal deviates behind their shares are correlated.
struct CorrelatedScatters {
  std::string name;                   ///< as results show them: "posterior"
  std::vector<std::size_t> scatters;  ///< their indices
  Eigen::MatrixXd root;               ///< times its transpose it is their correlation, (n, n)
};

/// A root of a correlation matrix, which may be singular. Throws std::invalid_argument if the matrix is no correlation
/// matrix.
[[nodiscard]] Eigen::MatrixXd correlation_root(const Eigen::MatrixXd& correlation);

/// The scatters between builds, and between the uses of a build. Immutable.
struct Spread {
  std::vector<Scatter> scatters;
  std::vector<CorrelatedScatters> correlated{};  ///< all others are independent
  std::size_t draws = 32;                        ///< of which statistics of one design are made; >= 8
  /// Share of the uses that counts as every use if a law of a use has no ends; > 0.5 and <= 1.
  double share_of_uses = 0.99;
  /// The current if it follows from the built design. Empty: it is that of the operating point.
  DrivenCurrent driven{};
  std::optional<StudyDriver> driver{};  ///< that has to give the current of a build, too; absent: none has to
};

}  // namespace coilwright::sizing
