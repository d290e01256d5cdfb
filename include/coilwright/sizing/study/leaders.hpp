#pragma once

#include <cstddef>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "coilwright/sizing/study/sweep.hpp"

namespace coilwright::sizing {

/// The design that leads a configuration in one objective: its best feasible one or, if none is, its least infeasible.
struct Leader {
  std::string_view configuration;  ///< its letter; empty in a study that does not vary the configuration
  std::size_t objective{};         ///< index in the study
  SweptDesign design;
};

/// Keeps the leaders of a sweep while its designs pass by.
class Leaders {
 public:
  explicit Leaders(DesignProblem problem);

  /// Of equals the one that came first stays.
  void consider(const SweptDesign& design);

  /// By configuration in the order of the study, then by objective. For a configuration with nothing feasible one
  /// entry, of the first objective.
  [[nodiscard]] std::vector<Leader> all() const;

  /// Whether any design kept every limit.
  [[nodiscard]] bool any_feasible() const;

 private:
  [[nodiscard]] std::size_t configuration_of(const SweptDesign& design) const;
  [[nodiscard]] bool leads(const SweptDesign& design, const SweptDesign& leader, std::size_t objective) const;

  DesignProblem problem_;
  std::map<std::pair<std::size_t, std::size_t>, SweptDesign> leaders_;  // by configuration and objective
};

}  // namespace coilwright::sizing
