#include "report/study_parts.hpp"

#include <fmt/format.h>

#include <optional>

#include "coilwright/report/simulation/percent.hpp"
#include "coilwright/sizing/problem/late_gain.hpp"

namespace coilwright::report {

std::string to_text(const formats::ArchiveCounts& counts) {
  std::string text = fmt::format("{} keep every limit, {} do not, and {} could not be evaluated", counts.ok,
                                 counts.infeasible, counts.failed);
  if (counts.failed > 0) text += fmt::format(" (most often: {})", counts.usual_failure);
  if (counts.left_out > 0)
    text += fmt::format("; {} more were not evaluated, because their shape, winding and current break a limit",
                        counts.left_out);
  constexpr double few = 0.1;
  const std::size_t evaluated = counts.ok + counts.infeasible;
  if (!counts.rarest_limit.empty() && static_cast<double>(counts.ok) < few * static_cast<double>(evaluated))
    text += fmt::format(". Few keep every limit; fewest keep {}: {} of {}", counts.rarest_limit, counts.keep_rarest,
                        evaluated);
  return text;
}

std::string late_gain_text(const SearchEnd& end) {
  if (end.reason != sizing::StopReason::evaluation_limit) return {};
  const std::optional<double> gain = end.late_gain;
  if (!gain && end.feasible == 0)
    return " None keeps every limit: more evaluations (--max-evaluations) help only if some design does; look first at "
           "what the nearest one breaks.";
  if (!gain)
    return " None of the first four fifths of them keeps every limit: more evaluations (--max-evaluations) would find "
           "better.";
  if (*gain == 0.0 && !end.of_front) return " The last fifth of them found nothing better.";
  if (*gain == 0.0 && end.of_ends == 0)
    return " The last fifth of them added nothing; the front is not known to be complete.";
  if (*gain == 0.0)
    return fmt::format(
        " {} of them searched for an end of the front alone, and the last fifth added nothing. What another --seed "
        "would find is not known.",
        end.of_ends);
  std::string text =
      end.of_front ? fmt::format(" The last fifth of them added {} of what the front dominates", percent(*gain, 2))
                   : fmt::format(" The last fifth of them bettered the objective by {}", percent(*gain, 2));
  constexpr double worth_more = 0.01;
  return text + (*gain < worth_more ? "." : ": more evaluations (--max-evaluations) would find better.");
}

std::string_view meaning_of(sizing::StopReason reason) {
  switch (reason) {
    case sizing::StopReason::evaluation_limit:
      return "the limit of evaluations was reached";
    case sizing::StopReason::space_exhausted:
      return "every design of the space was evaluated";
    case sizing::StopReason::converged:
      return "the algorithm converged";
    case sizing::StopReason::interrupted:
      return "it was interrupted";
  }
  return "";
}

SearchEnd end_of(sizing::StopReason reason, const sizing::Archive& archive, std::size_t evaluations) {
  const formats::ArchiveCounts counts = formats::counts_of(archive);
  return {.reason = reason,
          .feasible = counts.ok,
          .of_ends = counts.of_ends,
          .late_gain = sizing::late_gain(archive, evaluations),
          .of_front = archive.problem().objectives.size() > 1};
}

}  // namespace coilwright::report
