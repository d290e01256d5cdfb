#include "report/search_text.hpp"

#include <fmt/format.h>

namespace coilwright::report {

std::string to_text(const formats::ArchiveCounts& counts) {
  std::string text = fmt::format("{} keep every limit, {} do not, and {} could not be evaluated", counts.ok,
                                 counts.infeasible, counts.failed);
  if (counts.failed > 0) text += fmt::format(" (most often: {})", counts.usual_failure);
  return text;
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

}  // namespace coilwright::report
