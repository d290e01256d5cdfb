#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "coilwright/sizing/study/part.hpp"
#include "coilwright/sizing/study/sobol_indices.hpp"
#include "coilwright/sizing/study/spread.hpp"
#include "coilwright/sizing/study/study.hpp"

namespace coilwright::sizing {

/// A share of builds with its 95 % interval by Clopper and Pearson.
struct Share {
  double value{};  ///< 0 to 1, as are the others
  double low{};
  double high{};
};

/// A quantity of a study in the builds of one design.
struct BuiltQuantity {
  std::string name;                 ///< of one build: "grasp_force_N"
  std::optional<double> nominal{};  ///< of the design itself
  std::optional<double> p05{}, p50{}, p95{};
  std::string limit{};           ///< "mass_g <= 70"; empty for an objective
  std::optional<Share> keeps{};  ///< of the builds that keep that limit; absent for an objective
  /// The share that the study asks for by a percentile: 0.95 for "p95_mass_g <= 70"; absent for another limit.
  std::optional<double> asked{};
  /// Share of its uses in which a build must keep the limit to count; 1 for all. Absent if each build is judged in the
  /// one use that its dice gave.
  std::optional<double> of_uses{};

  /// Whether fewer builds keep the limit than the study asks for, beyond the error of the dice.
  [[nodiscard]] bool falls_short() const { return keeps && asked && keeps->high < *asked; }
};

/// The effect of one scatter of the spread, or of a group of correlated ones, on each quantity and on the yield.
struct ScatterWorth {
  std::string scatter;  ///< name of the scatter, or of the correlated group
  /// Indices, one for each quantity, in their order; absent if a quantity does not vary or some build lacks it.
  std::vector<std::optional<SobolIndex>> first{}, total{};
  Share keeps_all{};  ///< of builds, by the same dice, in which it deviates half as far
};

/// A cause for which builds lack a requested value.
struct FailureCause {
  std::string reason;  ///< the reason's first words, ".." for numbers: "the driver cannot give the current: raise .."
  std::size_t builds{};
};

/// The statistics of the builds of a design.
struct Yield {
  std::size_t builds{};
  std::size_t not_built{};  ///< builds without a performance, such as one whose driver cannot give the current
  std::vector<FailureCause> failures{};  ///< causes of most builds first; at most five, the last then "other causes"
  Share keeps_all{};                     ///< of the builds that keep every limit
  std::vector<BuiltQuantity> quantities{};
  std::vector<ScatterWorth> worths{};  ///< one a scatter; empty if none were asked for
  std::size_t worths_left{};           ///< scatters whose worth was requested and not computed because of a stop
};

/// Settings of a yield.
struct YieldOptions {
  std::size_t builds = 1000;     ///< number of builds by fresh dice, independent of those of a search; >= 10
  std::size_t worth_builds = 0;  ///< number for every sum of a Sobol index and for every halved scatter; 0: no worths
  std::uint64_t seed = 1;
  unsigned threads = 0;  ///< 0: one per core; the answer does not depend on it
  std::stop_token stop{};
  std::function<void(std::size_t done, std::size_t of)> progress{};  ///< on any thread; may be empty
};

/// Builds a design of `study` many times and gives its objectives, its limits and the thermal load with its driver's
/// ripple. Quantities that hold in every use are taken in the worst of the uses of a build, all others in one use by
/// dice. For a limit or an objective on a percentile ("p95_coil_hot_spot_degC <= 130") each build is compared with the
/// limit itself, for one on a mean or a deviation none is. After a stop the result covers the builds made so far, with
/// the worths whose builds were all made; absent if none was made. Throws std::invalid_argument for a study without a
/// spread.
[[nodiscard]] std::optional<Yield> yield_of(const Study& study, const EvaluatedDesign& design,
                                            const YieldOptions& options);

/// One build of a yield.
struct Build {
  std::vector<std::optional<double>> values{};  ///< requested quantities, in the unit of each
  bool has_performance = true;                  ///< false: it has no values
  std::string failure{};  ///< the first words of the reason why it lacks a value; empty if it has all
};

/// A yield in parts: the builds of builds_in() over ranges that cover builds_of() give yield_from() the bits of
/// yield_of(). Each throws as yield_of(), and yield_from() also for another number of builds. @{ Number of builds of a
/// yield, including those for its worths.
[[nodiscard]] std::size_t builds_of(const Study& study, const YieldOptions& options);
/// The builds of a range; absent after a stop.
[[nodiscard]] std::optional<std::vector<Build>> builds_in(const Study& study, const EvaluatedDesign& design,
                                                          const YieldOptions& options, const IndexRange& range);
/// The yield from all builds.
[[nodiscard]] Yield yield_from(const Study& study, const EvaluatedDesign& design, const YieldOptions& options,
                               std::span<const Build> builds);
///@}

}  // namespace coilwright::sizing
