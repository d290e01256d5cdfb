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

/// What may scatter beside numbers of designs, of effects and of blocks: "current_A" and "grasp_opening_deg" of an
/// operating point, "each_joint_stiffness_factor" and "each_remanence_factor" of each joint and magnet by itself.
[[nodiscard]] std::vector<std::string> further_number_names();

/// How many joints or magnets at most have a number of that name each by itself, a Scatter each, about what the design
/// gives all alike; 0 for a number of the whole.
[[nodiscard]] std::size_t most_parts(std::string_view name);

/// Whether a number of that name is by default of a use: surroundings, what is held or crawled on, and a supply's
/// charge. Every finger meets all of them, where of a part each has its own.
[[nodiscard]] bool is_of_use(std::string_view name);

/// Whether builds are looked at in more uses than one each: some scatter is of a use.
[[nodiscard]] bool has_uses(const Spread& spread);

/// Over which share of the uses of a build that holds which holds in every use: 1 where all laws of uses have ends.
[[nodiscard]] double share_of_uses(const Spread& spread);

/// Places in the unit cube, `count` of `dimension` numbers > 0 and < 1 each: Sobol's sequence (Boost.Random, directions
/// of Joe and Kuo), moved by a random vector of `seed` modulo 1. The mean over them of a smooth function errs by about
/// 1 / count. The same for all designs, so that what is computed by them is as smooth as the design.
[[nodiscard]] std::vector<std::vector<double>> sobol_shares(std::size_t dimension, std::size_t count,
                                                            std::uint64_t seed);

/// The same of a pseudorandom generator: fresh dice, which know nothing of those above.
[[nodiscard]] std::vector<std::vector<double>> random_shares(std::size_t dimension, std::size_t count,
                                                             std::uint64_t seed);

/// One build of a design: its numbers at the deviations of `shares`, one per scatter and independent of each other:
/// correlations are made here. A length, or a number of an effect, that would leave its range stays at its end. Why
/// there is none where it cannot be built or has no performance.
[[nodiscard]] DesignResult built(const Spread& spread, const simulation::DesignView& design,
                                 std::span<const double> shares);

/// What a statistic says of the values that a quantity has in the builds of one design.
struct Statistic {
  /// The average, the standard deviation, or the value below which `percent` of the builds are.
  enum class Kind { mean, deviation, percentile };
  Kind kind{};
  int percent{};  ///< 1 to 99, of a percentile
};

/// The statistic and the quantity in names such as "p05_grasp_force_N", "p95_coil_hot_spot_degC", "mean_mass_g",
/// "sd_mass_g" and "p05_worst_grasp_force_N"; nothing for another name.
struct StatisticName {
  Statistic statistic;
  bool of_worst_use{};  ///< said by the name
  std::string quantity;
};
[[nodiscard]] std::optional<StatisticName> statistic_named(std::string_view name);

/// What a statistic is of in one build, in every use where the quantity or the name says so; nothing where `known`
/// lacks it.
[[nodiscard]] std::optional<simulation::ResultQuantity> quantity_of(const StatisticName& name,
                                                                    const simulation::QuantityTable& known);

/// A percentile by linear interpolation between order statistics, each in the middle of its share (Hyndman and Fan,
/// type 5): without bias for places that fill a line evenly. `percent` 0 to 100. A build without a value counts as
/// beyond all others at the end of the percentile, the lower one below 50: nothing where that leaves none.
[[nodiscard]] std::optional<double> percentile(const std::vector<std::optional<double>>& values, double percent);

struct AskedOfBuild;

/// Makes quantities of the builds of a design, for objectives, limits, expressions and columns. Every design is built
/// `Spread::draws` times, by the same places, when the first of them is asked for.
class SpreadQuantities {
 public:
  /// Makes quantities of builds of `spread`.
  explicit SpreadQuantities(Spread spread);

  /// The quantity of that name, of one in `known`; nothing where the name is no statistic or `known` lacks what it is
  /// of. Call it for every quantity before the first is asked for a value: builds are made for all of them.
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
