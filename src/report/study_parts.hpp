#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/formats/study/result_json.hpp"
#include "coilwright/formats/study/size_json.hpp"
#include "coilwright/report/simulation/document.hpp"
#include "coilwright/sizing/problem/options.hpp"
#include "coilwright/sizing/study/broken_part_limits.hpp"
#include "coilwright/sizing/study/design_problem.hpp"

// What the texts of sizing, fronts and sweeps have in common; each part has a file of its name.
namespace coilwright::report {

// design_text.cpp

/// A variable's value at a coordinate, to read.
[[nodiscard]] std::string value_text(const sizing::StudyVariable& variable, double coordinate);

/// The variables of a point, in the order of the study.
[[nodiscard]] std::vector<std::string> variable_texts(const sizing::Study& study, std::span<const double> point);

/// "maximise peak_bending_speed_deg_s".
[[nodiscard]] std::string objective_text(const sizing::StudyObjective& objective);

/// Why a design is not feasible: its failure, or the limits that it violates and by how much, worst first. Empty for a
/// feasible design.
[[nodiscard]] std::string reasons_for_infeasibility(const sizing::Study& study, const sizing::Evaluation& evaluation);

/// The cautions that so many of `designs` designs break limits of their parts, and then conditional ones, each limit
/// with what happens beyond it, and which the study does not limit yet; `which` names the designs: "designs of this
/// front". Empty where none breaks any.
[[nodiscard]] std::vector<std::string> cautions_of_parts(const sizing::Study& study,
                                                         std::span<const sizing::BrokenPartLimit> broken,
                                                         std::string_view which, std::size_t designs);

// search_text.cpp

/// "1200 keep every limit, 700 do not, and 100 could not be evaluated".
[[nodiscard]] std::string to_text(const formats::ArchiveCounts& counts);

/// How a search ended.
struct SearchEnd {
  sizing::StopReason reason{};
  std::size_t feasible{};             ///< number of designs that keep every limit
  std::size_t of_ends{};              ///< number of designs proposed to improve one end of a front
  std::optional<double> late_gain{};  ///< sizing::late_gain()
  bool of_front{};                    ///< whether it has several objectives
};

/// How the search of an archive of so many evaluations ended.
[[nodiscard]] SearchEnd end_of(sizing::StopReason reason, const sizing::Archive& archive, std::size_t evaluations);

/// " The last fifth of them added 2.1 % of what the front dominates: .." where a search ended because of its limit of
/// evaluations, with what to do where there is more to be had; "bettered the objective" of one objective. Empty
/// otherwise.
[[nodiscard]] std::string late_gain_text(const SearchEnd& end);

/// "the limit of evaluations was reached" for StopReason::evaluation_limit.
[[nodiscard]] std::string_view meaning_of(sizing::StopReason reason);

// assumptions_text.cpp

/// The variables in which two designs differ: "gap_mm 1 instead of 0.8".
[[nodiscard]] std::string difference(const sizing::Study& study, const sizing::Record& from, const sizing::Record& to);

/// What the answer of a study rests on: for each other modelling choice the objective and the worst margin of the same
/// design, whether another design would then be better, and the measurement to make first. Without blocks where none
/// was looked at.
[[nodiscard]] Section assumptions_section(const formats::SizeReport& report);

/// What of a feasible answer was not looked at, as the run was interrupted or only the answer was asked for; empty
/// where all was.
[[nodiscard]] std::string left_out_text(const formats::SizeReport& report);

}  // namespace coilwright::report
