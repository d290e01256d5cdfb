#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "coilwright/sizing/problem/options.hpp"
#include "coilwright/sizing/search/pareto.hpp"
#include "coilwright/sizing/study/broken_part_limits.hpp"
#include "coilwright/sizing/study/study.hpp"

namespace coilwright::report {

/// How a search ended.
struct SearchEnd {
  sizing::StopReason reason{};
  std::size_t feasible{};             ///< number of designs that keep every limit
  std::size_t of_ends{};              ///< number of designs proposed to improve one end of a front
  std::optional<double> late_gain{};  ///< sizing::late_gain()
  bool of_front{};                    ///< whether it has several objectives
};

/// The sentences that say why a search ended, and whether more is likely to be found: "The search ended because the
/// limit of evaluations was reached. The last fifth of its designs added 2.1 % of what the front dominates: ..".
[[nodiscard]] std::string to_text(const SearchEnd& end);

/// The ends of the front and its middle as a table, and the limits of parts that its designs break; or the design
/// nearest to feasible.
[[nodiscard]] std::string to_text(const sizing::Study& study, const sizing::ParetoResult& result,
                                  std::span<const sizing::BrokenPartLimit> broken);

}  // namespace coilwright::report
