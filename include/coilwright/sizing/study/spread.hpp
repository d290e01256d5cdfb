#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/simulation/quantity.hpp"
#include "coilwright/sizing/study/design_problem.hpp"
#include "coilwright/sizing/study/scatter.hpp"

namespace coilwright::sizing {

/// Names of the numbers that may scatter beside those of designs, effects and blocks: "current_A", "duty",
/// "grasp_opening_deg" and "supply_voltage_V" of an operating point, "each_joint_stiffness_factor" and
/// "each_remanence_factor" of single joints and magnets.
[[nodiscard]] std::vector<std::string> further_number_names();

/// The largest number of joints or magnets that have a number of that name separately, each with a Scatter of its own;
/// 0 for a number of the whole.
[[nodiscard]] std::size_t most_parts(std::string_view name);

/// Whether a number of that name is by default of a use: surroundings, the duty, the object or the ground, and the
/// charge of a supply. Every finger meets all values of it, whereas each finger has its own value of a number of a
/// part.
[[nodiscard]] bool is_of_use(std::string_view name);

/// Whether some scatter is of a use, so that builds are evaluated in more than one use each.
[[nodiscard]] bool has_uses(const Spread& spread);

/// The share of the uses of a build that counts as every use: 1 if all laws of uses have ends.
[[nodiscard]] double share_of_uses(const Spread& spread);

/// Places in the unit cube, `count` with `dimension` numbers > 0 and < 1 each: Sobol's sequence (Boost.Random,
/// directions of Joe and Kuo), shifted by a random vector of `seed` modulo 1. The mean of a smooth function over them
/// errs by about 1 / count. They are the same for all designs, so a statistic over them is as smooth as the design.
[[nodiscard]] std::vector<std::vector<double>> sobol_shares(std::size_t dimension, std::size_t count,
                                                            std::uint64_t seed);

/// Places by a pseudorandom generator: fresh dice, independent of those of sobol_shares().
[[nodiscard]] std::vector<std::vector<double>> random_shares(std::size_t dimension, std::size_t count,
                                                             std::uint64_t seed);

/// One build of a design, with its numbers at the deviations of `shares`, one per scatter and independent of each
/// other; correlations are made here. A length, or a number of an effect, that would leave its range stays at its end.
/// If the build is impossible or has no performance, the result has the reason.
[[nodiscard]] DesignResult built(const Spread& spread, const simulation::DesignView& design,
                                 std::span<const double> shares);

/// A statistic of the values of a quantity in the builds of one design.
struct Statistic {
  /// The mean, the standard deviation, or the value below which `percent` of the builds lie.
  enum class Kind { mean, deviation, percentile };
  Kind kind{};
  int percent{};  ///< 1 to 99, of a percentile
};

/// The statistic and the quantity in names such as "p05_grasp_force_N", "p95_coil_hot_spot_degC", "mean_mass_g",
/// "sd_mass_g" and "p05_worst_grasp_force_N"; absent for another name.
struct StatisticName {
  Statistic statistic;
  bool of_worst_use{};  ///< whether the name asks for the worst use
  std::string quantity;
};
[[nodiscard]] std::optional<StatisticName> statistic_named(std::string_view name);

/// The quantity of one build over which a statistic is taken; it holds in every use if the quantity or the name says
/// so. Absent if `known` lacks it.
[[nodiscard]] std::optional<simulation::ResultQuantity> quantity_of(const StatisticName& name,
                                                                    const simulation::QuantityTable& known);

/// A percentile by linear interpolation between order statistics, each in the middle of its share (Hyndman and Fan,
/// type 5), which is unbiased for evenly spaced places. `percent` 0 to 100. A build without a value counts as beyond
/// all others on the side of the percentile (the lower side below 50); absent if no value is left.
[[nodiscard]] std::optional<double> percentile(const std::vector<std::optional<double>>& values, double percent);

struct AskedOfBuild;

/// Quantities of the builds of a design, for objectives, limits, expressions and columns. Every design is built
/// `Spread::draws` times, at the same places, when the first quantity is requested.
class SpreadQuantities {
 public:
  /// Prepares the quantities of builds of `spread`.
  explicit SpreadQuantities(Spread spread);

  /// The statistic of that name over a quantity in `known`; absent if the name is no statistic or `known` lacks its
  /// quantity. Call it for every quantity before a value is requested, because builds are made for all of them
  /// together.
  [[nodiscard]] std::optional<simulation::ResultQuantity> find(std::string_view name,
                                                               const simulation::QuantityTable& known);

  [[nodiscard]] const Spread& spread() const noexcept { return *spread_; }

 private:
  // By quantity and build.
  using Values = std::vector<std::vector<std::optional<double>>>;

  std::shared_ptr<const Spread> spread_;
  std::shared_ptr<std::vector<AskedOfBuild>> asked_;
  simulation::SharedResult<Values> values_;
};

}  // namespace coilwright::sizing
