#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "coilwright/sizing/study/sweep.hpp"

namespace coilwright::sizing {

/// The best feasible design of a configuration in one objective or, if none is feasible, the least infeasible one.
struct Leader {
  std::string_view configuration;  ///< letter; empty in a study that does not vary the configuration
  std::size_t objective{};         ///< index in the study
  SweptDesign design;
};

/// The designs among leaders that keep every limit, each once, in their order.
[[nodiscard]] std::vector<SweptDesign> feasible_designs(std::span<const Leader> leaders);

/// Keeps the leaders of a sweep, design by design.
class Leaders {
 public:
  /// Starts without a leader and copies the problem.
  explicit Leaders(const DesignProblem& problem);

  /// Considers one design. Of equal designs the first one stays.
  void consider(const SweptDesign& design);

  /// The leaders by configuration in the order of the study, then by objective. A configuration without a feasible
  /// design has one entry, for the first objective.
  [[nodiscard]] std::vector<Leader> all() const;

  /// Whether any design keeps every limit.
  [[nodiscard]] bool any_feasible() const;

 private:
  [[nodiscard]] std::size_t configuration_of(const SweptDesign& design) const;
  [[nodiscard]] bool leads(const SweptDesign& design, const SweptDesign& leader, std::size_t objective) const;

  DesignProblem problem_;
  std::map<std::pair<std::size_t, std::size_t>, SweptDesign> leaders_;  // by configuration and objective
};

}  // namespace coilwright::sizing
