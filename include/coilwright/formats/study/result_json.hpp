#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "coilwright/sizing/problem/archive.hpp"
#include "coilwright/sizing/study/broken_part_limits.hpp"
#include "coilwright/sizing/study/design_problem.hpp"
#include "coilwright/sizing/study/study.hpp"
#include "coilwright/text/json/json.hpp"

namespace coilwright::formats {

/// Counts of the designs of an archive by their status.
struct ArchiveCounts {
  std::size_t ok{};
  std::size_t infeasible{};
  std::size_t failed{};
  std::size_t left_out{};       ///< designs that a limit excludes by shape, winding and current, without an evaluation
  std::size_t of_ends{};        ///< evaluated designs that were proposed to better one end of a front
  std::string rarest_limit{};   ///< limit that the fewest evaluated designs keep; empty without limits
  std::size_t keep_rarest{};    ///< number of designs that keep it
  std::string usual_failure{};  ///< the most frequent reason of those that failed
};
[[nodiscard]] ArchiveCounts counts_of(const sizing::Archive& archive);

/// {"ok": .., "infeasible": .., "failed": .., "left_out": ..}
[[nodiscard]] text::Json to_json(const ArchiveCounts& counts);

/// The objectives as the study states them: [{"maximise": "stroke_deg"}].
[[nodiscard]] text::Json objectives_asked(const sizing::Study& study);

/// [{"quantity": .., "designs": .., "consequence": ..}]
[[nodiscard]] text::Json to_json(std::span<const sizing::BrokenPartLimit> broken);

/// The first keys of a result file: the question, and how it was searched.
[[nodiscard]] text::Json result_head(std::string_view command, const sizing::Study& study, sizing::StopReason reason);

/// A variable's value at a coordinate: a word, a whole number or a number in the unit of the variable's name.
[[nodiscard]] text::Json value_json(const sizing::StudyVariable& variable, double coordinate);

/// The variables of a point, in the order of the study.
[[nodiscard]] text::Json variables_json(const sizing::Study& study, std::span<const double> point);

/// {"peak_bending_speed_deg_s": 1708.1, ...}; null for a failed design.
[[nodiscard]] text::Json objectives_json(const sizing::Study& study, const sizing::Evaluation& evaluation);

/// [{"quantity": "mass_g", "at_most": 70, "value": 69.2, "margin": 0.8}, ...]; values null for a failed design.
[[nodiscard]] text::Json constraints_json(const sizing::Study& study, const sizing::Evaluation& evaluation);

/// A design with its three parts, under "variables", "objectives" and "constraints".
[[nodiscard]] text::Json design_json(const sizing::Study& study, std::span<const double> point,
                                     const sizing::Evaluation& evaluation);

}  // namespace coilwright::formats
